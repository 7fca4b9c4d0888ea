// Saving and opening: in the cell's store, and as files of this machine. The text that is kept is always the one
// that the server's formatter writes.
import { create } from "zustand";
import { empty, type Drawing } from "../model/operation";
import { Broken, Refused } from "../protocol/connection";
import { t } from "../words/words";
import { ask, notice } from "./acts";
import { call, useCell } from "./cell";
import { textOf } from "./checks";
import { edit, isChanged, show, useDrawing } from "./drawing";
import { readable } from "./tidy";

/** A question of saving or opening that waits for the person. */
export type Pending =
  | { kind: "name"; suggested: string }
  | { kind: "conflict"; name: string; newest: number }
  | { kind: "discard"; then(): void }
  | { kind: "exists"; name: string };

export const useKeep = create<{ pending: Pending | undefined }>()(() => ({ pending: undefined }));
export const settle = (): void => useKeep.setState({ pending: undefined });

async function canonicalText(drawing: Drawing): Promise<string | undefined> {
  return (await ask("operation.format", { text: textOf(drawing) }))?.text;
}

function saved(drawing: Drawing, name: string, version: number): void {
  useDrawing.setState({ saved: drawing, name, version });
  notice("done", t("keep.saved", { name, version }));
}

/** `basedOn`: the version that is replaced knowingly. */
export async function saveAs(name: string, basedOn: number): Promise<void> {
  settle();
  let { drawing } = useDrawing.getState();
  // The operation is called as its file, unless it was given a name of its own.
  if (drawing.name === "untitled") {
    edit("edit.operation", (now) => ({ ...now, name }));
    ({ drawing } = useDrawing.getState());
  }
  const text = await canonicalText(drawing);
  if (text === undefined) return;
  try {
    const result = await call("store.save", { name, text, based_on: basedOn });
    saved(drawing, name, result.version);
  } catch (problem) {
    if (problem instanceof Refused && problem.why === "newer") useKeep.setState({ pending: { kind: "conflict", name, newest: problem.data.newest ?? 0 } });
    else if (problem instanceof Refused && problem.why === "exists") useKeep.setState({ pending: { kind: "exists", name } });
    else if (problem instanceof Refused) notice("error", problem.message, problem.data.hint ?? "");
    else if (problem instanceof Broken) notice("error", t("keep.awaySave"));
    else throw problem;
  }
}

export async function save(options: { as?: boolean } = {}): Promise<void> {
  const { name, version, drawing } = useDrawing.getState();
  if (useCell.getState().stored === undefined) return notice("error", t("keep.noStore"), t("keep.noStoreHint"));
  if (name === undefined || options.as) useKeep.setState({ pending: { kind: "name", suggested: name ?? (drawing.name === "untitled" ? "" : drawing.name) } });
  else await saveAs(name, version);
}

/** Does it, after the person has said what becomes of changes that are not saved. */
export function unlessChanged(then: () => void): void {
  const state = useDrawing.getState();
  if (isChanged(state) && state.drawing.icons.length > 0) useKeep.setState({ pending: { kind: "discard", then } });
  else then();
}

export function newDrawing(): void {
  unlessChanged(() => show(empty("untitled")));
}

export async function openStored(name: string, version?: number): Promise<void> {
  const result = await ask("store.read", { name, ...(version === undefined ? {} : { version }) });
  if (!result) return;
  const drawing = parsed(result.text);
  // An older version is opened as a change of the newest one.
  if (drawing) show(await readable(drawing), { name, version: result.newest, changed: result.version !== result.newest });
}

function parsed(text: string): Drawing | undefined {
  try {
    const drawing = JSON.parse(text) as Drawing;
    if (drawing["operation-format"] === 1 && Array.isArray(drawing.icons)) return drawing;
  } catch (problem) {
    notice("error", t("keep.noJson"), String(problem instanceof Error ? problem.message : problem));
    return undefined;
  }
  notice("error", t("keep.noOperation"));
  return undefined;
}

/** Shows what the cell has loaded; false: nothing that could be shown. */
export async function showLoaded(): Promise<boolean> {
  const loaded = useCell.getState().present?.snapshot.loaded;
  const text = loaded?.files[loaded.main];
  const drawing = text === undefined ? undefined : parsed(text);
  if (!drawing) return false;
  show(await readable(drawing), loaded?.stored ? { name: loaded.stored.name, version: loaded.stored.version } : { changed: true });
  return true;
}

export async function exportFile(): Promise<void> {
  const { drawing, name } = useDrawing.getState();
  const text = await canonicalText(drawing);
  if (text === undefined) return;
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type: "application/json" }));
  link.download = `${name ?? drawing.name}.op.json`;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

export function importFile(): Promise<void> {
  const input = document.createElement("input");
  input.type = "file";
  input.accept = ".json,application/json";
  return new Promise((resolve) => {
    input.onchange = async () => {
      const file = input.files?.[0];
      const drawing = file ? parsed(await file.text()) : undefined;
      if (drawing) unlessChanged(() => void readable(drawing).then((each) => show(each, { changed: true })));
      resolve();
    };
    input.oncancel = () => resolve();
    input.click();
  });
}
