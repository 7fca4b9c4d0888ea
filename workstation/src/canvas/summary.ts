// What an icon says of itself in one line, below its name.
import type { Sensor } from "../../generated/protocol";
import { isSource, type Condition, type Icon, type Source } from "../model/operation";
import { number, t, unitText } from "../words/words";

export function sourceText(source: Source): string {
  if ("count-of" in source) return t("source.count", { icon: source["count-of"] });
  if ("argument" in source) return t("source.argument", { name: source.argument });
  return t("source.output", { icon: source["output-of"], name: source.name });
}

export function amountText(value: unknown, unit = ""): string {
  if (value === undefined) return "";
  if (isSource(value)) return sourceText(value);
  if (typeof value === "boolean") return t(value ? "value.true" : "value.false");
  if (typeof value === "number") return unit === "" ? number(value) : `${number(value)} ${unitText(unit)}`;
  return String(value);
}

function unitOf(sensor: string | undefined, sensors: readonly Sensor[]): string {
  return sensors.find((each) => each.sensor === sensor)?.unit ?? "";
}

export function conditionText(condition: Partial<Condition> & { limits?: Icon["limits"] }, sensors: readonly Sensor[]): string {
  const what = condition.sensor ?? (condition.value ? sourceText(condition.value) : "");
  const unit = unitOf(condition.sensor, sensors);
  const low = condition["at-least"], high = condition["at-most"];
  if (condition.limits) return `${what}: ${condition.limits.map((each) => amountText(each)).join(" · ")} ${unit}`.trim();
  if (low !== undefined && high !== undefined) return `${amountText(low)} ≤ ${what} ≤ ${amountText(high, unit)}`;
  if (low !== undefined) return `${what} ≥ ${amountText(low, unit)}`;
  return `${what} ≤ ${amountText(high, unit)}`;
}

export function summary(icon: Icon, sensors: readonly Sensor[]): string {
  const repeat = icon.repeat === undefined ? "" : ` × ${amountText(icon.repeat)}`;
  switch (icon.kind) {
    case "skill": return (icon.skill ?? "") + repeat;
    case "planned": return t("summary.planned", { skill: icon.skill ?? "" });
    case "operation": return (icon.file ?? icon.operation ?? "") + repeat;
    case "delay": return amountText(icon.seconds, "s");
    case "wait": case "test": {
      const several = icon.all ?? icon.any;
      if (several) return several.map((each) => conditionText(each, sensors)).join(icon.all ? " ∧ " : " ∨ ");
      if (!icon.sensor && !icon.value) return t("summary.noSensor");
      return conditionText(icon as Partial<Condition>, sensors);
    }
    case "zero": return icon.sensor ?? "";
    case "question": return icon.text || t("summary.noText");
    default: return "";
  }
}

/** The name that the icon shows: START and MERGE need none of their own. */
export function title(icon: Icon): string {
  if (icon.kind === "start") return t("kind.start");
  if (icon.kind === "restart") return t("kind.restart");
  return icon.id;
}

/** When a breakpoint halts: "code 1, count of put ≥ 3, each 2nd time". Empty: always. */
export function breakText(kept: NonNullable<Icon["break"]>): string {
  const condition = kept.value ? conditionText({ value: kept.value, ...(kept["at-least"] === undefined ? {} : { "at-least": kept["at-least"] }), ...(kept["at-most"] === undefined ? {} : { "at-most": kept["at-most"] }) }, []) : "";
  return [
    kept.code === undefined ? "" : t("break.code", { code: kept.code }), condition,
    (kept.every ?? 1) > 1 ? t("break.every", { count: kept.every ?? 1 }) : "",
  ].filter(Boolean).join(", ");
}
