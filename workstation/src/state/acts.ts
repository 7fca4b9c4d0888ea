// What a person does to the cell: load, run, pause, stop, breakpoints, controls. A refusal becomes a notice that
// stays until it is read.
import { create } from "zustand";
import type { Value } from "../../generated/protocol";
import { operationNamed, type Drawing } from "../model/operation";
import { Broken, Refused, type MethodName, type Params, type Result } from "../protocol/connection";
import { t } from "../words/words";
import { call, useCell } from "./cell";
import { mainFile, textOf } from "./checks";
import { useDrawing } from "./drawing";

export interface Notice {
  id: number;
  kind: "error" | "done";
  text: string;
  hint: string;
}

export const useNotices = create<{ notices: readonly Notice[] }>()(() => ({ notices: [] }));
let noticed = 0;

export function notice(kind: Notice["kind"], text: string, hint = ""): void {
  const { notices } = useNotices.getState();
  if (notices.some((each) => each.text === text && each.kind === kind)) return;
  const id = ++noticed;
  useNotices.setState({ notices: [...notices.slice(-3), { id, kind, text, hint }] });
  if (kind === "done") setTimeout(() => dismiss(id), 4000);
}

export function dismiss(id: number): void {
  useNotices.setState((state) => ({ notices: state.notices.filter((each) => each.id !== id) }));
}

/** What the server answered; nothing if it refused, which the person is told. */
export async function ask<M extends MethodName>(method: M, params?: Params<M>): Promise<Result<M> | undefined> {
  try {
    return await call(method, params);
  } catch (problem) {
    if (problem instanceof Refused) notice("error", problem.message, problem.data.hint ?? "");
    else if (problem instanceof Broken) notice("error", t("said.away"));
    else throw problem;
    return undefined;
  }
}

/** The drawing that the cell has loaded, as far as this page knows. */
let loaded: Drawing | undefined;

function differs(drawing: Drawing): boolean {
  if (loaded === drawing) return false;
  const there = useCell.getState().present?.snapshot.loaded;
  const text = there?.files[there.main];
  if (text === undefined || Object.keys(there?.files ?? {}).length === 0) return true;
  try {
    const same = canonical(JSON.parse(text)) === canonical(drawing);
    if (same) loaded = drawing;
    return !same;
  } catch {
    return true;
  }
}

/** The same text whatever the order of fields, and wherever the icons lie. */
function canonical(value: unknown): string {
  return JSON.stringify(value, (key, each) =>
    key === "at" || key === "note" ? undefined : each && typeof each === "object" && !Array.isArray(each) ? Object.fromEntries(Object.entries(each).sort(([a], [b]) => (a < b ? -1 : 1))) : each);
}

export const differsFromLoaded = (): boolean => {
  const { drawing } = useDrawing.getState();
  return useCell.getState().present?.snapshot.operation === drawing.name && differs(drawing);
};

/** Loads the drawing with its breakpoints, if the cell has another one. */
async function load(): Promise<boolean> {
  const { drawing } = useDrawing.getState();
  if (useCell.getState().present?.snapshot.operation === drawing.name && !differs(drawing)) return true;
  if (!(await ask("operation.load", { main: mainFile, files: { [mainFile]: textOf(drawing) } }))) return false;
  loaded = drawing;
  return true;
}

export async function run(): Promise<void> {
  if (await load()) await ask("operation.run");
}
export async function step(): Promise<void> {
  if (await load()) await ask("operation.step");
}
export const resume = (): Promise<unknown> => ask("operation.resume");
export const pause = (): Promise<unknown> => ask("operation.pause");
/** Whatever runs, of whatever client. */
export const stop = (): Promise<unknown> => ask("stop");

export async function restart(): Promise<void> {
  const { drawing } = useDrawing.getState();
  const start = drawing.icons.find((icon) => icon.kind === "start");
  if (!(await load()) || !start) return;
  if (await ask("operation.from", { icon: start.id })) await ask("operation.run");
}

export async function runFrom(path: string): Promise<void> {
  if (!(await load())) return;
  if (await ask("operation.from", { icon: path })) await ask("operation.run");
}

/** All paths on which the operation `name` runs. */
export function pathsTo(drawing: Drawing, name: string): string[] {
  const found: string[] = [];
  const walk = (at: string, prefix: string, depth: number) => {
    if (at === name) found.push(prefix);
    if (depth > 16 || found.length > 64) return;
    for (const icon of operationNamed(drawing, at)?.icons ?? [])
      if (icon.kind === "operation" && !icon.file && icon.operation) walk(icon.operation, `${prefix}${icon.id}/`, depth + 1);
  };
  walk(drawing.name, "", 0);
  return found;
}

/** While the loaded operation is paused or stopped: the new value counts from the icon's next run on. */
export async function setWhilePaused(operation: string, icon: string, parameter: string, value: Value, before: Drawing): Promise<void> {
  const snapshot = useCell.getState().present?.snapshot;
  const { drawing } = useDrawing.getState();
  if (!snapshot || snapshot.operation !== drawing.name || !["paused", "stopped"].includes(snapshot.state)) return;
  const same = !differs(before);
  let all = true;
  for (const prefix of pathsTo(drawing, operation)) all = (await ask("operation.set", { icon: prefix + icon, parameter, value })) !== undefined && all;
  if (same && all) loaded = useDrawing.getState().drawing;
}
