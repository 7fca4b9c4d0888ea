// Executions of one skill as rows: from the cell's history, and those tried aside. Plain functions over rows choose,
// sort and compare them.
import type { Methods, Skill, Value } from "../../generated/protocol";

export type Executed = Methods["history.steps"]["result"]["rows"][number];

export interface Row {
  /** "12.3": run and step; "aside.4". */
  id: string;
  aside: boolean;
  icon: string;
  /** Wall clock; empty of one tried aside. */
  begun: string;
  run: number;
  step: number;
  parameters: Readonly<Record<string, Value>>;
  figures: Readonly<Record<string, number>>;
  /** The worst of each requirement in this run, in its unit. */
  measured: Readonly<Record<string, number>>;
  kind: string;
  code: number;
  reason: string;
  duration: number;
}

export function rowOf(each: Executed): Row {
  const { step } = each;
  return {
    id: `${each.run}.${step.step}`, aside: false, icon: step.icon, begun: each.begun, run: each.run, step: step.step, parameters: each.parameters as Record<string, Value>,
    figures: step.figures ?? {}, measured: step.measured ?? {}, kind: step.kind ?? "normal", code: step.code ?? 0, reason: step.reason ?? "", duration: step.end_s - step.begin_s,
  };
}

/** A column: where a row has the value, its name and unit. */
export interface Column {
  id: string;
  group: "parameter" | "figure" | "requirement";
  name: string;
  unit: string;
  of(row: Row): Value | undefined;
}

const units: Readonly<Record<string, string>> = { force: "N", "greatest-force": "N", "mean-force": "N", "rms-force": "N", distance: "mm", duration: "s", x: "mm", y: "mm", z: "mm" };

export function columnsOf(skill: Skill | undefined, rows: readonly Row[]): Column[] {
  const names = (pick: (row: Row) => Readonly<Record<string, unknown>>) => [...new Set(rows.flatMap((row) => Object.keys(pick(row))))];
  const parameters = (skill?.parameters ?? []).map((each): Column => ({ id: `parameter:${each.name}`, group: "parameter", name: each.name, unit: each.unit, of: (row) => row.parameters[each.name] }));
  const figures = names((row) => row.figures).map((name): Column => ({ id: `figure:${name}`, group: "figure", name, unit: units[name] ?? "", of: (row) => row.figures[name] }));
  // What the environment promises is measured, too; it is no requirement of the skill.
  const requirements = names((row) => row.measured).filter((name) => skill?.requirements.some((each) => each.name === name)).map((name): Column => {
    const unit = skill?.requirements.find((each) => each.name === name)?.unit ?? "";
    return { id: `requirement:${name}`, group: "requirement", name, unit: unit === "s" ? "ms" : unit, of: (row) => (row.measured[name] === undefined ? undefined : row.measured[name]! * (unit === "s" ? 1000 : 1)) };
  });
  return [...parameters, ...figures, ...requirements];
}

/** Those in which the rows differ. */
export const differing = (columns: readonly Column[], rows: readonly Row[]): Column[] =>
  columns.filter((column) => new Set(rows.map((row) => column.of(row))).size > 1);

export interface Filter {
  /** Part of the icon's path; empty: all. */
  icon: string;
  /** A code; undefined: all. */
  code: number | undefined;
  where: "all" | "cell" | "aside";
}

export const chosen = (rows: readonly Row[], filter: Filter): Row[] =>
  rows.filter((row) => (filter.icon === "" || row.icon === filter.icon) && (filter.code === undefined || row.code === filter.code) && (filter.where === "all" || (filter.where === "aside") === row.aside));

export function sorted(rows: readonly Row[], column: Column | undefined, down: boolean): Row[] {
  if (!column) return [...rows];
  const key = (row: Row): number | string => {
    const value = column.of(row);
    return typeof value === "string" ? value : value === undefined ? -Infinity : Number(value);
  };
  return [...rows].sort((a, b) => {
    const x = key(a), y = key(b);
    return (x < y ? -1 : x > y ? 1 : 0) * (down ? -1 : 1);
  });
}

/** Values of a sweep, both ends among them. */
export function sweep(from: number, to: number, count: number): number[] {
  if (count <= 1) return [from];
  return Array.from({ length: count }, (_, i) => Number((from + ((to - from) * i) / (count - 1)).toPrecision(9)));
}
