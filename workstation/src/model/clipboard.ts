// Copy and paste of icons, also from one operation to another: the lines among them go along, and so do the
// sub-operations that they stand for.
import { renameSources } from "./edit";
import { addOperation, freeName, operationNamed, withOperation, type Drawing, type Icon, type Operation, type Point } from "./operation";
import { redirect } from "./ports";

export interface Clip {
  icons: Icon[];
  operations: Operation[];
}

/** All operations that stand behind these icons, at any depth. */
function behind(drawing: Drawing, icons: readonly Icon[]): Operation[] {
  const found = new Map<string, Operation>();
  const todo = [...icons];
  for (let icon = todo.pop(); icon; icon = todo.pop()) {
    if (icon.kind !== "operation" || icon.file || !icon.operation || found.has(icon.operation)) continue;
    const operation = operationNamed(drawing, icon.operation);
    if (!operation) continue;
    found.set(operation.name, operation);
    todo.push(...operation.icons);
  }
  return [...found.values()];
}

export function copy(drawing: Drawing, operation: Operation, ids: ReadonlySet<string>): Clip {
  const icons = operation.icons
    .filter((icon) => ids.has(icon.id))
    .map((icon) => redirect(icon, (to) => (ids.has(to) ? to : undefined)));
  return { icons, operations: behind(drawing, icons) };
}

/** Two operations that say the same may share a name; another one gets a name of its own. */
function bringOperations(drawing: Drawing, clip: Clip): { drawing: Drawing; names: Map<string, string> } {
  let result = drawing;
  const names = new Map<string, string>();
  for (const each of clip.operations) {
    const there = operationNamed(result, each.name);
    if (there && JSON.stringify(there) === JSON.stringify(each)) continue;
    const taken = [result.name, ...(result.operations ?? []).map((other) => other.name)];
    const name = freeName(each.name, taken);
    if (name !== each.name) names.set(each.name, name);
    result = addOperation(result, { ...each, name });
  }
  if (names.size === 0) return { drawing: result, names };
  const brought = new Set(clip.operations.map((each) => names.get(each.name) ?? each.name));
  const operations = result.operations?.map((each) =>
    brought.has(each.name) ? { ...each, icons: each.icons.map((icon) => renamedUse(icon as Icon, names)) as never } : each);
  return { drawing: { ...result, operations } as Drawing, names };
}

function renamedUse(icon: Icon, names: ReadonlyMap<string, string>): Icon {
  const name = icon.kind === "operation" && !icon.file ? names.get(icon.operation ?? "") : undefined;
  return name === undefined ? icon : { ...icon, operation: name };
}

/** `by`: how far the pasted icons lie from where they were copied. */
export function paste(drawing: Drawing, into: string, clip: Clip, by: Point): { drawing: Drawing; ids: string[] } {
  const brought = bringOperations(drawing, clip);
  const operation = operationNamed(brought.drawing, into);
  if (!operation) return { drawing, ids: [] };
  const taken = new Set(operation.icons.map((icon) => icon.id));
  const hasStart = operation.icons.some((icon) => icon.kind === "start");
  const names = new Map<string, string>();
  // An operation has one START; a second one is not pasted.
  const icons = clip.icons.filter((icon) => !(hasStart && icon.kind === "start"));
  for (const icon of icons) {
    const name = freeName(icon.id, taken);
    taken.add(name);
    names.set(icon.id, name);
  }
  const pasted = icons.map((icon) => {
    const led = redirect(icon, (to) => names.get(to));
    const sourced = renameSources(led, (id) => names.get(id) ?? id);
    const at: Point = [(icon.at?.[0] ?? 0) + by[0], (icon.at?.[1] ?? 0) + by[1]];
    return { ...renamedUse(sourced, brought.names), id: names.get(icon.id)!, at };
  });
  const changed = { ...operation, icons: [...operation.icons, ...pasted] };
  return { drawing: withOperation(brought.drawing, into, changed), ids: pasted.map((icon) => icon.id) };
}
