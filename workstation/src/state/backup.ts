// A copy of the drawing in the browser: what was not saved survives a crash, a reload, an empty battery. It is kept twice:
// in localStorage, which a page reads at once, but which a browser writes to the disk only some seconds later; and in
// IndexedDB, which has it on the disk when it says so.
import { walk, isChanged, show, useDrawing, type DrawingState } from "./drawing";
import type { Drawing } from "../model/operation";

const key = "workcell-drawing";

interface Kept {
  drawing: Drawing;
  trail: readonly string[];
  name?: string | undefined;
  version: number;
  changed: boolean;
  /** When it was kept, by this machine's clock in ms: the newer copy counts. */
  kept?: number;
}

let opening: Promise<IDBDatabase> | undefined;
function database(): Promise<IDBDatabase> {
  opening ??= new Promise((resolve, reject) => {
    const asked = indexedDB.open("workcell", 1);
    asked.onupgradeneeded = () => asked.result.createObjectStore("kept");
    asked.onsuccess = () => resolve(asked.result);
    asked.onerror = () => reject(asked.error);
  });
  return opening;
}

async function onDisk(kept: Kept): Promise<void> {
  const at = (await database()).transaction("kept", "readwrite", { durability: "strict" });
  at.objectStore("kept").put(kept, key);
}

async function fromDisk(): Promise<Kept | undefined> {
  const asked = (await database()).transaction("kept").objectStore("kept").get(key) as IDBRequest<Kept | undefined>;
  return new Promise((resolve, reject) => {
    asked.onsuccess = () => resolve(asked.result);
    asked.onerror = () => reject(asked.error);
  });
}

function write(state: DrawingState): void {
  const kept: Kept = { drawing: state.drawing, trail: state.trail, name: state.name, version: state.version, changed: isChanged(state), kept: Date.now() };
  try {
    localStorage.setItem(key, JSON.stringify(kept));
  } catch {
    // The browser's room is full: the drawing is still on the page and can be saved.
  }
  // A browser that offers no disk (a private window) keeps the first copy alone.
  onDisk(kept).catch(() => {});
}

function bring(kept: Kept): void {
  show(kept.drawing, { name: kept.name, version: kept.version, changed: kept.changed });
  useDrawing.setState({ trail: walk(kept.drawing, kept.trail).trail });
}

const whole = (kept: Kept | null | undefined): kept is Kept => kept?.drawing?.["operation-format"] === 1 && Array.isArray(kept.drawing.icons);

/** True: there was one. */
export function restore(): boolean {
  let kept: Kept | null = null;
  try {
    kept = JSON.parse(localStorage.getItem(key) ?? "null") as Kept | null;
  } catch {
    // Half a text: the other copy is whole.
  }
  if (whole(kept)) bring(kept);
  return whole(kept) && kept.drawing.icons.length > 0;
}

/** After a crash of the whole browser the copy on the disk is the newer one. True: it has been shown. */
export async function restoreFromDisk(): Promise<boolean> {
  const { drawing } = useDrawing.getState();
  try {
    const first = JSON.parse(localStorage.getItem(key) ?? "null") as Kept | null, kept = await fromDisk();
    if (!whole(kept) || (kept.kept ?? 0) <= (first?.kept ?? (first ? Infinity : 0)) || useDrawing.getState().drawing !== drawing) return false;
    bring(kept);
    return kept.drawing.icons.length > 0;
  } catch {
    return false;
  }
}

export function keepBackup(): void {
  let timer: ReturnType<typeof setTimeout> | undefined;
  useDrawing.subscribe((now, before) => {
    if (now.drawing === before.drawing && now.saved === before.saved && now.trail === before.trail) return;
    clearTimeout(timer);
    timer = setTimeout(() => write(useDrawing.getState()), 200);
  });
  addEventListener("pagehide", () => write(useDrawing.getState()));
}
