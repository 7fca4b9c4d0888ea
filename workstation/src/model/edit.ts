// Changes of one operation. Each takes an operation and gives the changed one; what did not change stays the
// same object, so history and views see at once what is new.
import type { Condition, Icon, Kind, Operation, Point } from "./operation";
import { freeName, isSource } from "./operation";
import { lead, outputs, redirect, type PortName } from "./ports";

const mapIcons = (operation: Operation, change: (icon: Icon) => Icon): Operation => {
  let changed = false;
  const icons = operation.icons.map((icon) => {
    const result = change(icon);
    changed ||= result !== icon;
    return result;
  });
  return changed ? { ...operation, icons } : operation;
};

export function changeIcon(operation: Operation, id: string, change: (icon: Icon) => Icon): Operation {
  return mapIcons(operation, (icon) => (icon.id === id ? change(icon) : icon));
}

/** A field of the icon; undefined takes it away. */
export function setField<K extends keyof Icon>(icon: Icon, field: K, value: Icon[K] | undefined): Icon {
  if (icon[field] === value) return icon;
  const { [field]: _, ...rest } = icon;
  return (value === undefined ? rest : { ...icon, [field]: value }) as Icon;
}

export function setParameter(icon: Icon, name: string, value: NonNullable<Icon["parameters"]>[string] | undefined): Icon {
  const { [name]: _, ...rest } = icon.parameters ?? {};
  const parameters = value === undefined ? rest : { ...icon.parameters, [name]: value };
  return setField(icon, "parameters", Object.keys(parameters).length > 0 ? parameters : undefined);
}

/** The least that the schema asks of an icon of this kind. */
export function newIcon(kind: Kind, id: string, at: Point, more: Partial<Icon> = {}): Icon {
  const least: Partial<Record<Kind, Partial<Icon>>> = {
    case: { ways: [{ codes: [0] }, { codes: [1] }] },
    delay: { seconds: 1 },
    wait: { sensor: "", "at-least": 0 },
    test: { sensor: "", limits: [0] },
    zero: { sensor: "force-z" },
    question: { text: "", answers: [{ text: "" }] },
    planned: { skill: id, codes: [{ code: 0, text: "OK" }] },
  };
  return { id, kind, ...least[kind], ...more, at } as Icon;
}

export function addIcon(operation: Operation, icon: Icon): Operation {
  return { ...operation, icons: [...operation.icons, icon] };
}

/** The icons go, and so do the lines to them. */
export function removeIcons(operation: Operation, ids: ReadonlySet<string>): Operation {
  const icons = operation.icons
    .filter((icon) => !ids.has(icon.id))
    .map((icon) => redirect(icon, (to) => (ids.has(to) ? undefined : to)));
  return { ...operation, icons };
}

export function moveIcons(operation: Operation, places: ReadonlyMap<string, Point>): Operation {
  return mapIcons(operation, (icon) => {
    const at = places.get(icon.id);
    if (!at || (icon.at && icon.at[0] === at[0] && icon.at[1] === at[1])) return icon;
    return { ...icon, at };
  });
}

export function connect(operation: Operation, from: string, port: PortName, to: string | undefined): Operation {
  return changeIcon(operation, from, (icon) => lead(icon, port, to));
}

/** The output that a new line takes if none was named: the first that leads nowhere, else the first. */
export function openPort(icon: Icon): PortName | undefined {
  const all = outputs(icon);
  return (all.find((port) => port.to === undefined) ?? all[0])?.name;
}

const renamedCondition = (condition: Condition, rename: (value: unknown) => unknown): Condition =>
  Object.fromEntries(Object.entries(condition).map(([name, value]) => [name, rename(value)])) as unknown as Condition;

/** Counts and figures of the icon `from` become those of `to`, wherever the icon uses them. */
export function renameSources(icon: Icon, change: (id: string) => string): Icon {
  const rename = (value: unknown): unknown => {
    if (Array.isArray(value)) return value.map((each) => (isSource(each) && !("codes" in each) ? rename(each) : each));
    if (!isSource(value)) return value;
    if ("count-of" in value) return { "count-of": change(value["count-of"]) };
    if ("output-of" in value) return { ...value, "output-of": change(value["output-of"]) };
    return value;
  };
  let result = icon;
  for (const field of ["repeat", "time-limit", "seconds", "timeout", "value", "at-least", "at-most", "limits", "code"] as const)
    if (icon[field] !== undefined) result = { ...result, [field]: rename(icon[field]) };
  for (const field of ["all", "any"] as const)
    if (icon[field]) result = { ...result, [field]: icon[field].map((each) => renamedCondition(each, rename)) };
  if (icon.parameters)
    result = { ...result, parameters: Object.fromEntries(Object.entries(icon.parameters).map(([name, value]) => [name, rename(value) as typeof value])) };
  return result;
}

/** The ids of the icons whose counts or figures the icon uses. */
export function sourcesOf(icon: Icon): Set<string> {
  const used = new Set<string>();
  renameSources(icon, (id) => (used.add(id), id));
  return used;
}

/** A new name for an icon, in all lines and sources too. A name that is taken is made free. */
export function renameIcon(operation: Operation, from: string, wanted: string): Operation {
  if (wanted === from) return operation;
  const to = freeName(wanted, operation.icons.map((icon) => icon.id).filter((id) => id !== from));
  return mapIcons(operation, (icon) => {
    const led = redirect(icon, (each) => (each === from ? to : each));
    const sourced = sourcesOf(led).has(from) ? renameSources(led, (id) => (id === from ? to : id)) : led;
    return sourced.id === from ? { ...sourced, id: to } : sourced;
  });
}
