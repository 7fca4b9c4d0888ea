// An operation as it stands in its file. The types come from the schema of that file; nothing here changes one.
import type { Arguments, Condition, Icons, OnStop, Root, Source } from "../../generated/operation";

/** The first operation of the file and, under `operations`, those that its hierarchical icons name. */
export type Drawing = Root;
export type { Arguments, Condition, OnStop, Source };

type Union = Icons[number];
export type Kind = Union["kind"];
type Keys<U> = U extends unknown ? keyof U : never;
type Field<U, K> = U extends unknown ? (K extends keyof U ? U[K] : never) : never;

/** An icon of any kind, with the fields of all kinds; the schema says which kind has which. */
export type Icon = { id: string; kind: Kind } & { [K in Exclude<Keys<Union>, "id" | "kind">]?: Field<Union, K> };

export interface Operation {
  name: string;
  description?: string;
  arguments?: Arguments;
  "on-stop"?: OnStop;
  icons: Icon[];
}

export type Value = number | boolean | string;
export type Point = [number, number];

export const isSource = (value: unknown): value is Source => typeof value === "object" && value !== null;

export function empty(name: string): Drawing {
  return { "operation-format": 1, name, icons: [] };
}

/** The operations of a file, the first one first. */
export function operationsOf(drawing: Drawing): Operation[] {
  const { "operation-format": _, operations, ...first } = drawing;
  return [first as Operation, ...((operations ?? []) as Operation[])];
}

export function operationNamed(drawing: Drawing, name: string): Operation | undefined {
  if (drawing.name === name) return drawing as Operation;
  return drawing.operations?.find((each) => each.name === name) as Operation | undefined;
}

/** The same file with this operation in place of the one that was called `name`. */
export function withOperation(drawing: Drawing, name: string, changed: Operation): Drawing {
  if (drawing.name === name) {
    const result = { "operation-format": 1, ...changed } as Drawing;
    if (drawing.operations) result.operations = drawing.operations;
    return result;
  }
  const operations = drawing.operations?.map((each) => (each.name === name ? (changed as typeof each) : each));
  return { ...drawing, operations } as Drawing;
}

export function addOperation(drawing: Drawing, added: Operation): Drawing {
  return { ...drawing, operations: [...(drawing.operations ?? []), added as never] };
}

/** Without the sub-operations that no hierarchical icon names any more and that are in `candidates`. */
export function dropUnused(drawing: Drawing, candidates: ReadonlySet<string>): Drawing {
  const used = new Set<string>();
  for (const each of operationsOf(drawing)) {
    for (const icon of each.icons) if (icon.kind === "operation" && !icon.file && icon.operation) used.add(icon.operation);
    if (typeof each["on-stop"] === "string") used.add(each["on-stop"]);
  }
  const kept = drawing.operations?.filter((each) => used.has(each.name) || !candidates.has(each.name));
  if (!kept || kept.length === drawing.operations?.length) return drawing;
  const { operations: _, ...rest } = drawing;
  return kept.length === 0 ? rest : { ...rest, operations: kept };
}

export function iconOf(operation: Operation, id: string): Icon | undefined {
  return operation.icons.find((each) => each.id === id);
}

/** "side", "side-2", "side-3": the first that `taken` does not have. */
export function freeName(wanted: string, taken: Iterable<string>): string {
  const names = new Set(taken);
  const base = wanted.replaceAll("/", "-").trim() || "icon";
  if (!names.has(base)) return base;
  const stem = base.replace(/-\d+$/, "");
  for (let i = 2; ; ++i) if (!names.has(`${stem}-${i}`)) return `${stem}-${i}`;
}
