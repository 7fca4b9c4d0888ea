// Without the right token the page shows nothing of the cell; it says where the token is.
import { useState } from "react";
import { Button } from "react-aria-components";
import { TextBox } from "./dialog/TextBox";
import { keepToken } from "./protocol/token";
import { connect, useCell } from "./state/cell";
import { Symbol } from "./symbols/Symbol";
import { t } from "./words/words";

export function NoToken() {
  const [token, setToken] = useState("");
  const enter = () => {
    keepToken(token.trim());
    useCell.setState({ link: "connecting" });
    connect();
  };
  return (
    <main className="no-token">
      <form onSubmit={(event) => (event.preventDefault(), enter())}>
        <Symbol name="lock" size={32} />
        <h1>{t("token.title")}</h1>
        <p>{t("token.text")}</p>
        <TextBox label={t("token.label")} value={token} onChange={setToken} />
        <Button className="button primary" type="submit" isDisabled={token.trim() === ""}>{t("token.enter")}</Button>
      </form>
    </main>
  );
}
