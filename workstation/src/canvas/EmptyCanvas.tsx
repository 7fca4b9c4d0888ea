// What an empty canvas says: what to do first.
import { Button } from "react-aria-components";
import { insertIcon } from "../state/edits";
import { openWindow } from "../state/windows";
import { t } from "../words/words";
import { focusIcon } from "./keys";

export function EmptyCanvas() {
  return (
    <div className="empty">
      <div>
        <h2>{t("empty.title")}</h2>
        <p>{t("empty.text")}</p>
        <div className="acts">
          <Button className="button primary" onPress={() => focusIcon(insertIcon({ kind: "start" }, [0, 0]))}>{t("empty.start")}</Button>
          <Button className="button" onPress={() => openWindow("store")}>{t("empty.open")}</Button>
        </div>
      </div>
    </div>
  );
}
