// What was refused or has gone wrong. It stays until it is read.
import { Button } from "react-aria-components";
import { dismiss, useNotices } from "../state/acts";
import { Symbol } from "../symbols/Symbol";
import { t } from "../words/words";

export function Notices() {
  const notices = useNotices((state) => state.notices);
  return (
    <div className="notices" role="region" aria-label={t("notices.label")} aria-live="assertive">
      {notices.map((each) => (
        <div key={each.id} className="notice" data-kind={each.kind}>
          <Symbol name={each.kind === "error" ? "error" : "tick"} size={18} />
          <div><p>{each.text}</p>{each.hint !== "" && <p className="hint">{each.hint}</p>}</div>
          <Button className="button quiet only" aria-label={t("notices.dismiss")} onPress={() => dismiss(each.id)}><Symbol name="cross" size={16} /></Button>
        </div>
      ))}
    </div>
  );
}
