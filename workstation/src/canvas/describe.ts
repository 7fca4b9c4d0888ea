// An icon in one sentence, for a screen reader.
import type { Icon } from "../model/operation";
import { outputs, type PortName } from "../model/ports";
import { useCell } from "../state/cell";
import { useChecks } from "../state/checks";
import { duration, t } from "../words/words";
import { runStateOf } from "./runState";
import { summary } from "./summary";

export function portText(icon: Icon, port: PortName): string {
  const [kind, index] = port.split(":");
  if (kind === "way") return t("port.way", { codes: icon.ways?.[Number(index)]?.codes.join(", ") ?? "" });
  if (kind === "answer") return t("port.answer", { text: icon.answers?.[Number(index)]?.text ?? "" });
  if (kind === "default") return t("port.default");
  return t(kind === "error" ? "port.error" : "port.next");
}

export function describe(icon: Icon, operation: string, path: string): string {
  const cell = useCell.getState(), checks = useChecks.getState();
  const parts = [icon.id, t(`kind.${icon.kind}`)];
  const line = summary(icon, cell.sensors);
  if (line !== "" && line !== icon.id) parts.push(line);
  for (const port of outputs(icon))
    parts.push(port.to === undefined ? t("describe.open", { port: portText(icon, port.name) }) : t("describe.to", { port: portText(icon, port.name), to: port.to }));
  const times = checks.times.get(`${operation}/${icon.id}`);
  if (times?.longest_s) parts.push(t("time.most", { time: duration(times.longest_s) }));
  const findings = checks.findings.get(`${operation}/${icon.id}`)?.filter((each) => each.severity !== "note").length ?? 0;
  if (findings > 0) parts.push(t("findings.count", { count: findings }));
  const run = runStateOf(cell, path);
  if (run !== "none") parts.push(t(`run.${run}`));
  return parts.join(", ");
}
