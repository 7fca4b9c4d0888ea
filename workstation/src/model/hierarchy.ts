// Collapsing icons into a hierarchical one, and expanding it again (thesis, 4.4.3). Both keep what the drawing
// does; where that is not possible they say why (a key of the words catalogue) and change nothing.
import { sourcesOf } from "./edit";
import { addOperation, dropUnused, freeName, iconOf, operationNamed, operationsOf, withOperation } from "./operation";
import type { Drawing, Icon, Operation, Point } from "./operation";
import { lines, redirect, type Line } from "./ports";

export type Outcome = { drawing: Drawing; id: string; name: string } | { refused: string };

/** The CASE that the token meets next, behind MERGEs and delays. */
export function caseBehind(operation: Operation, id: string | undefined): Icon | undefined {
  const seen = new Set<string>();
  for (let icon = id === undefined ? undefined : iconOf(operation, id); icon && !seen.has(icon.id);) {
    if (icon.kind === "case") return icon;
    if (icon.kind !== "merge" && icon.kind !== "delay") return undefined;
    seen.add(icon.id);
    icon = icon.next === undefined ? undefined : iconOf(operation, icon.next);
  }
  return undefined;
}

interface Border {
  entry: string;
  /** Where the token goes when it has left, and by which lines. */
  exits: Map<string, Line[]>;
}

function border(operation: Operation, ids: ReadonlySet<string>): Border | { refused: string } {
  const all = lines(operation);
  const entries = new Set(all.filter((line) => !ids.has(line.from) && ids.has(line.to)).map((line) => line.to));
  if (entries.size > 1) return { refused: "collapse.entries" };
  const inside = operation.icons.filter((icon) => ids.has(icon.id));
  if (inside.some((icon) => ["start", "exit", "restart"].includes(icon.kind))) return { refused: "collapse.ends" };
  for (const icon of operation.icons)
    for (const used of sourcesOf(icon)) if (ids.has(used) !== ids.has(icon.id)) return { refused: "collapse.sources" };
  const reachedFrom = new Set(all.filter((line) => ids.has(line.from)).map((line) => line.to));
  const entry = [...entries][0] ?? inside.find((icon) => !reachedFrom.has(icon.id))?.id ?? inside[0]?.id;
  if (entry === undefined) return { refused: "collapse.nothing" };
  if (iconOf(operation, entry)?.kind === "case") return { refused: "collapse.case" };
  const exits = new Map<string, Line[]>();
  for (const line of all)
    if (ids.has(line.from) && !ids.has(line.to)) exits.set(line.to, [...(exits.get(line.to) ?? []), line]);
  return { entry, exits };
}

const middle = (icons: readonly Icon[]): Point => {
  const xs = icons.map((icon) => icon.at?.[0] ?? 0), ys = icons.map((icon) => icon.at?.[1] ?? 0);
  return [Math.round((Math.min(...xs) + Math.max(...xs)) / 2), Math.round((Math.min(...ys) + Math.max(...ys)) / 2)];
};

interface Way {
  target: string;
  /** The EXIT that stands for it inside. */
  exit: string;
  code: number | undefined;
}

/** One way: `next`. Two, one of which errors alone take: `next` and `error`. More: by code, with a CASE. */
function waysOut(operation: Operation, exits: Border["exits"], taken: Set<string>): Way[] | { refused: string } {
  const targets = [...exits.entries()].sort(([, a], [, b]) =>
    Number(a.every((line) => line.port === "error")) - Number(b.every((line) => line.port === "error")));
  if (targets.length > 5) return { refused: "collapse.ways" };
  const keepsCode = targets.some(([target]) => caseBehind(operation, target));
  if (keepsCode && (targets.length > 2 || (targets[1] && !targets[1][1].every((line) => line.port === "error"))))
    return { refused: "collapse.code" };
  return targets.map(([target], i) => {
    const exit = freeName(i === 0 ? "done" : i === 1 ? "failed" : `way-${i}`, taken);
    taken.add(exit);
    return { target, exit, code: keepsCode ? undefined : i };
  });
}

const ends = new Set(["skill", "wait", "test", "zero", "operation"]);

/** The icons inside whose code a CASE outside reads: those that lead there by `next`, also over MERGEs and delays. */
function readOutside(operation: Operation, ids: ReadonlySet<string>): Icon[] {
  return operation.icons.filter((icon) => {
    if (!ids.has(icon.id) || !ends.has(icon.kind)) return false;
    const branch = caseBehind(operation, icon.next);
    return branch !== undefined && !ids.has(branch.id);
  });
}

export function collapse(drawing: Drawing, into: string, ids: ReadonlySet<string>, wanted: string): Outcome {
  const operation = operationNamed(drawing, into);
  if (!operation || ids.size === 0) return { refused: "collapse.nothing" };
  const edge = border(operation, ids);
  if ("refused" in edge) return edge;
  const inside = operation.icons.filter((icon) => ids.has(icon.id));
  const taken = new Set(inside.map((icon) => icon.id));
  const ways = waysOut(operation, edge.exits, taken);
  if ("refused" in ways) return ways;

  const read = readOutside(operation, ids);
  // Inside, the CASE no longer comes before `error`.
  if (read.some((icon) => icon.error !== undefined && ids.has(icon.error))) return { refused: "collapse.code" };
  const open = new Set(read.filter((icon) => icon.error === undefined).map((icon) => icon.id));

  const name = freeName(wanted, operationsOf(drawing).map((each) => each.name));
  const outside = operation.icons.filter((icon) => !ids.has(icon.id));
  const id = freeName(wanted, outside.map((icon) => icon.id));
  const exitOf = new Map(ways.map((way) => [way.target, way.exit]));
  const left = Math.min(...inside.map((icon) => icon.at?.[0] ?? 0));
  const right = Math.max(...inside.map((icon) => icon.at?.[0] ?? 0));
  const top = iconOf(operation, edge.entry)?.at?.[1] ?? 0;
  const sub: Operation = {
    name,
    icons: [
      { id: freeName("start", taken), kind: "start", next: edge.entry, at: [left - 168, top] } as Icon,
      ...inside.map((icon) => redirect(open.has(icon.id) ? ({ ...icon, error: icon.next } as Icon) : icon, (to) => exitOf.get(to) ?? to)),
      ...ways.map((way, i) => ({
        id: way.exit, kind: "exit", ...(way.code === undefined ? {} : { code: way.code }), at: [right + 240, top + i * 96],
      }) as Icon),
    ],
  };

  const at = middle(inside);
  const hierarchical: Icon = { id, kind: "operation", operation: name, at } as Icon;
  const added: Icon[] = [hierarchical];
  if (ways.length <= 2) {
    if (ways[0]) hierarchical.next = ways[0].target;
    if (ways[1]) hierarchical.error = ways[1].target;
  } else {
    const branch = freeName(`${id}-way`, [...outside.map((icon) => icon.id), id]);
    hierarchical.next = branch;
    const named = ways.slice(0, 4).map((way) => ({ codes: [way.code ?? 0], to: way.target }));
    const rest = ways[4] ? { default: ways[4].target } : {};
    added.push({ id: branch, kind: "case", ways: named, ...rest, at: [at[0] + 240, at[1]] } as Icon);
  }
  const first = operation.icons.findIndex((icon) => ids.has(icon.id));
  const before = new Set(operation.icons.slice(0, first).map((icon) => icon.id));
  const redirected = outside.map((icon) => redirect(icon, (to) => (ids.has(to) ? id : to)));
  const icons = [...redirected.filter((icon) => before.has(icon.id)), ...added, ...redirected.filter((icon) => !before.has(icon.id))];
  return { drawing: addOperation(withOperation(drawing, into, { ...operation, icons }), sub), id, name };
}

/** Where the token goes that leaves the hierarchical icon by this EXIT, to which `from` leads by `port`. */
function targetOf(operation: Operation, icon: Icon, exit: Icon, port: string, from: Icon): string | undefined | { refused: string } {
  const branch = caseBehind(operation, icon.next);
  // Behind a MERGE it is no longer known whether the code was normal, which decides between `error` and the CASE's default.
  if (exit.code === undefined && branch && icon.error !== undefined && !ends.has(from.kind)) return { refused: "expand.code" };
  if (exit.code === undefined) return port === "error" ? (icon.error ?? (branch ? icon.next : undefined)) : icon.next;
  if (typeof exit.code !== "number") return { refused: "expand.code" };
  const code = exit.code;
  if (!branch) return code === 0 ? icon.next : icon.error;
  const way = branch.ways?.find((each) => each.codes.includes(code))?.to;
  const target = way ?? (code !== 0 ? icon.error : undefined) ?? branch.default;
  // Behind it, a second CASE would read another code than the EXIT gave.
  return caseBehind(operation, target) ? { refused: "expand.code" } : target;
}

export function expand(drawing: Drawing, inside: string, id: string): Outcome {
  const operation = operationNamed(drawing, inside);
  const icon = operation && iconOf(operation, id);
  const sub = icon?.operation && !icon.file ? operationNamed(drawing, icon.operation) : undefined;
  if (!operation || !icon || !sub) return { refused: icon?.file ? "expand.file" : "expand.missing" };
  if (icon.repeat !== undefined || icon.parameters) return { refused: "expand.repeat" };
  if (sub["on-stop"]) return { refused: "expand.onStop" };
  if (operation.icons.some((each) => sourcesOf(each).has(id))) return { refused: "expand.sources" };
  if (sub.icons.some((each) => each.kind === "restart")) return { refused: "expand.restart" };
  const start = sub.icons.find((each) => each.kind === "start");
  if (start?.next === undefined) return { refused: "expand.start" };

  const kept = operation.icons.filter((each) => each.id !== id);
  const taken = new Set(kept.map((each) => each.id));
  const names = new Map<string, string>();
  const moved = sub.icons.filter((each) => each.kind !== "start" && each.kind !== "exit");
  for (const each of moved) {
    const name = freeName(each.id, taken);
    taken.add(name);
    names.set(each.id, name);
  }
  const exits = new Map(sub.icons.filter((each) => each.kind === "exit").map((each) => [each.id, each]));
  const [dx, dy] = offset(icon, moved);
  let refused: string | undefined;
  const out = (to: string, port: string, from: Icon): string | undefined => {
    const exit = exits.get(to);
    if (!exit) return names.get(to);
    const target = targetOf(operation, icon, exit, port, from);
    if (typeof target === "object") return (refused = target.refused), undefined;
    return target;
  };
  const brought = moved.map((each) => ({
    ...redirect(each, (to, port) => out(to, port, each)), id: names.get(each.id)!, at: [(each.at?.[0] ?? 0) + dx, (each.at?.[1] ?? 0) + dy] as Point,
  }));
  const entry = out(start.next, "next", start);
  if (refused !== undefined) return { refused };
  const redirected = kept.map((each) => redirect(each, (to) => (to === id ? entry : to)));
  const index = operation.icons.indexOf(icon);
  const icons = [...redirected.slice(0, index), ...brought, ...redirected.slice(index)] as Icon[];
  const result = withOperation(drawing, inside, { ...operation, icons });
  return { drawing: dropUnused(result, new Set([sub.name])), id: names.get(start.next) ?? id, name: sub.name };
}

function offset(icon: Icon, moved: readonly Icon[]): Point {
  if (moved.length === 0) return [0, 0];
  const left = Math.min(...moved.map((each) => each.at?.[0] ?? 0));
  const top = Math.min(...moved.map((each) => each.at?.[1] ?? 0));
  return [(icon.at?.[0] ?? 0) - left, (icon.at?.[1] ?? 0) - top];
}
