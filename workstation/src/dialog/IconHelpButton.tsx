// The foot of an icon's dialog: HELP, which opens the skill's template, and what the check found here.
import { Button } from "react-aria-components";
import { iconOf, operationNamed } from "../model/operation";
import { useChecks } from "../state/checks";
import { useDrawing } from "../state/drawing";
import { popOpen } from "../state/edits";
import { openFindings, openWindow } from "../state/windows";
import { Symbol } from "../symbols/Symbol";
import { t } from "../words/words";

export function IconHelpButton({ operation, icon: id }: { operation: string; icon: string }) {
  const drawing = useDrawing((state) => state.drawing);
  const findings = useChecks((state) => state.findings.get(`${operation}/${id}`)?.length ?? 0);
  const owner = operationNamed(drawing, operation);
  const icon = owner && iconOf(owner, id);
  return (
    <>
      {icon?.kind === "skill" && <Button className="button" onPress={() => openWindow("skill", icon.skill)}><Symbol name="help" size={18} />{t("form.help")}</Button>}
      {icon?.kind === "operation" && !icon.file && <Button className="button" onPress={() => popOpen(id)}><Symbol name="enter" size={18} />{t("menu.enter")}</Button>}
      {findings > 0 && <Button className="button" onPress={() => openFindings(operation, id)}><Symbol name="warning" size={18} />{t("findings.count", { count: findings })}</Button>}
    </>
  );
}
