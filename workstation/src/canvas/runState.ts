// What an icon is doing in the run that the cell is at.
import { useCell, type Cell } from "../state/cell";
import { useDrawing } from "../state/drawing";

export type RunState = "none" | "acting" | "halted" | "passed" | "failed";

/** Marks of a run belong to the drawing that is loaded. */
export const isLoaded = (cell: Cell, name: string): boolean => cell.present?.snapshot.operation === name;

export function runStateOf(cell: Cell, path: string): RunState {
  const { present } = cell;
  if (!present) return "none";
  const { snapshot, runs } = present;
  const here = snapshot.here?.icon ?? snapshot.token;
  const at = here === path || here.startsWith(`${path}/`);
  if (at && snapshot.state === "running") return "acting";
  if (at && snapshot.state === "failed") return "failed";
  if (at && (snapshot.state === "paused" || snapshot.state === "stopped")) return "halted";
  const run = runs.get(path);
  if (!run || run.visits === 0) return "none";
  return run.kind === undefined || run.kind === "normal" ? "passed" : "failed";
}

export function useRunState(path: string): RunState {
  const name = useDrawing((state) => state.drawing.name);
  return useCell((cell) => (isLoaded(cell, name) ? runStateOf(cell, path) : "none"));
}
