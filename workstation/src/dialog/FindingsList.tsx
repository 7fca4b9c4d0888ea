// What the check found: at one icon, or in the whole operation. Each has its page and, where there is one, its cure.
import { Button } from "react-aria-components";
import type { Finding } from "../../generated/protocol";
import { focusIcon } from "../canvas/keys";
import { mend, useChecks } from "../state/checks";
import { enter, useDrawing } from "../state/drawing";
import { pathsTo } from "../state/acts";
import { openWindow } from "../state/windows";
import { Symbol } from "../symbols/Symbol";
import { t } from "../words/words";

/** Shows the icon of a finding, in whatever operation it lies. */
function jump(finding: Finding): void {
  const { drawing } = useDrawing.getState();
  const path = pathsTo(drawing, finding.operation ?? drawing.name)[0];
  if (path === undefined || !finding.icon) return;
  enter(path.split("/").filter(Boolean), [finding.icon]);
  focusIcon(finding.icon);
}

const weight = { error: 0, warning: 1, note: 2 };

export function FindingsList({ operation, icon }: { operation: string; icon: string }) {
  const findings = useChecks((state) => (icon === "" ? state.result?.findings : state.findings.get(`${operation}/${icon}`)));
  if (!findings || findings.length === 0) return <p className="nothing good"><Symbol name="tick" size={18} />{t("findings.none")}</p>;
  return (
    <ul className="findings">
      {[...findings].sort((a, b) => weight[a.severity] - weight[b.severity]).map((each, i) => <Item key={i} finding={each} showIcon={icon === ""} />)}
    </ul>
  );
}

function Item({ finding, showIcon }: { finding: Finding; showIcon: boolean }) {
  return (
    <li className="finding" data-severity={finding.severity}>
      <Symbol name={finding.severity === "note" ? "info" : finding.severity} size={18} />
      <div>
        <p>{finding.message}</p>
        {finding.notes.map((each, i) => <p key={i} className="hint">{each.text}</p>)}
        {finding.hint !== "" && finding.hint_for === "all" && <p className="finding-hint">{finding.hint}</p>}
        <div className="chips">
          {finding.edits.length > 0 && <Button className="button small primary" onPress={() => mend(finding)}><Symbol name="tick" size={14} />{t("findings.mend")}</Button>}
          {showIcon && finding.icon && <Button className="button small" onPress={() => jump(finding)}><Symbol name="target" size={14} />{finding.icon}</Button>}
          <Button className="button small quiet" onPress={() => openWindow("explain", finding.code)}>{finding.code}</Button>
        </div>
      </div>
    </li>
  );
}
