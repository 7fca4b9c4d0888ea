// A copy of the drawing in the browser: what was not saved survives a crash, a reload, an empty battery.
import { walk, isChanged, show, useDrawing, type DrawingState } from "./drawing";
import type { Drawing } from "../model/operation";

const key = "workcell-drawing";

interface Kept {
  drawing: Drawing;
  trail: readonly string[];
  name?: string | undefined;
  version: number;
  changed: boolean;
}

function write(state: DrawingState): void {
  const kept: Kept = { drawing: state.drawing, trail: state.trail, name: state.name, version: state.version, changed: isChanged(state) };
  try {
    localStorage.setItem(key, JSON.stringify(kept));
  } catch {
    // The browser's room is full: the drawing is still on the page and can be saved.
  }
}

/** True: there was one. */
export function restore(): boolean {
  try {
    const kept = JSON.parse(localStorage.getItem(key) ?? "null") as Kept | null;
    if (!kept || kept.drawing["operation-format"] !== 1 || !Array.isArray(kept.drawing.icons)) return false;
    show(kept.drawing, { name: kept.name, version: kept.version, changed: kept.changed });
    useDrawing.setState({ trail: walk(kept.drawing, kept.trail).trail });
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
