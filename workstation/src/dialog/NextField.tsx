// Where an output leads, as a choice: the same as drawing its line.
import { portText } from "../canvas/describe";
import { operationNamed, type Icon } from "../model/operation";
import { hasInput, lead, outputs, type PortName } from "../model/ports";
import { useDrawing } from "../state/drawing";
import { change } from "../state/edits";
import { t } from "../words/words";
import { Choose } from "./Choose";

export function NextField({ operation, icon, port }: { operation: string; icon: Icon; port: PortName }) {
  const drawing = useDrawing((state) => state.drawing);
  const icons = operationNamed(drawing, operation)?.icons ?? [];
  const to = outputs(icon).find((each) => each.name === port)?.to;
  const options = [{ id: "\u0000", name: t("next.nowhere") }, ...icons.filter(hasInput).map((each) => ({ id: each.id, name: each.id, aside: t(`kind.${each.kind}`) }))];
  return (
    <Choose label={portText(icon, port)} value={to ?? "\u0000"} options={options}
      onChange={(id) => change(operation, icon.id, "edit.connect", (each) => lead(each, port, id === "\u0000" ? undefined : id))} />
  );
}
