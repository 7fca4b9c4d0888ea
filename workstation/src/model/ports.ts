// The outputs of an icon: which there are, where they lead, and how a line is put to them.
import type { Icon, Kind, Operation } from "./operation";

/** "next", "error", "default", "way:0", "answer:0". */
export type PortName = string;

export interface Port {
  name: PortName;
  to: string | undefined;
}

const withNext = new Set<Kind>(["start", "skill", "merge", "delay", "wait", "test", "zero", "planned", "operation"]);
const withError = new Set<Kind>(["skill", "wait", "test", "zero", "planned", "operation", "question"]);

export const hasInput = (icon: Icon): boolean => icon.kind !== "start";

/** From top to bottom, as they are drawn. */
export function outputs(icon: Icon): Port[] {
  const result: Port[] = [];
  icon.ways?.forEach((way, i) => result.push({ name: `way:${i}`, to: way.to }));
  icon.answers?.forEach((answer, i) => result.push({ name: `answer:${i}`, to: answer.to }));
  if (icon.kind === "case") result.push({ name: "default", to: icon.default });
  if (withNext.has(icon.kind)) result.push({ name: "next", to: icon.next });
  if (withError.has(icon.kind)) result.push({ name: "error", to: icon.error });
  return result;
}

function set<K extends keyof Icon>(icon: Icon, field: K, value: Icon[K] | undefined): Icon {
  const { [field]: _, ...rest } = icon;
  return (value === undefined ? rest : { ...rest, [field]: value }) as Icon;
}

function retarget<T extends { to?: string }>(list: T[] | undefined, index: number, to: string | undefined): T[] {
  return (list ?? []).map((each, i) => {
    if (i !== index) return each;
    const { to: _, ...rest } = each;
    return (to === undefined ? rest : { ...rest, to }) as T;
  });
}

/** The icon with its output leading to `to`, or nowhere. */
export function lead(icon: Icon, port: PortName, to: string | undefined): Icon {
  const [list, index] = port.split(":");
  if (list === "way") return set(icon, "ways", retarget(icon.ways, Number(index), to));
  if (list === "answer") return set(icon, "answers", retarget(icon.answers, Number(index), to));
  return set(icon, list as "next" | "error" | "default", to);
}

/** Every output that leads to `from` leads to what `to` says of it. */
export function redirect(icon: Icon, change: (to: string, port: PortName) => string | undefined): Icon {
  let result = icon;
  for (const port of outputs(icon)) {
    if (port.to === undefined) continue;
    const to = change(port.to, port.name);
    if (to !== port.to) result = lead(result, port.name, to);
  }
  return result;
}

export interface Line {
  from: string;
  port: PortName;
  to: string;
}

export function lines(operation: Operation): Line[] {
  return operation.icons.flatMap((icon) =>
    outputs(icon).flatMap((port) => (port.to === undefined ? [] : [{ from: icon.id, port: port.name, to: port.to }])));
}

/** The ids of all icons to which the token can come from START. The others are drawn dashed and do not run. */
export function reached(operation: Operation): Set<string> {
  const byId = new Map(operation.icons.map((icon) => [icon.id, icon]));
  const todo = operation.icons.filter((icon) => icon.kind === "start").map((icon) => icon.id);
  const seen = new Set<string>();
  for (let id = todo.pop(); id !== undefined; id = todo.pop()) {
    const icon = byId.get(id);
    if (!icon || seen.has(id)) continue;
    seen.add(id);
    for (const port of outputs(icon)) if (port.to !== undefined) todo.push(port.to);
  }
  return seen;
}
