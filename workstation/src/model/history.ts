// Undo and redo without limit. An entry keeps the drawing before and after a change. Drawings share all that did
// not change, so an entry is small, and what undo gives back is the very drawing that was there.
import type { Drawing } from "./operation";

/** Where the person was: undo goes back there, whatever is shown now. */
export interface Place {
  /** The names of the operations, from the first down to the one that is shown. */
  path: string[];
  selected: string[];
}

export interface Entry {
  /** A key of the words catalogue. */
  label: string;
  before: Drawing;
  after: Drawing;
  placeBefore: Place;
  placeAfter: Place;
  /** Entries of the same run, as the key strokes in one field, are one. */
  run?: string;
}

export interface History {
  readonly past: readonly Entry[];
  readonly future: readonly Entry[];
}

export const noHistory: History = { past: [], future: [] };

export function record(history: History, entry: Entry): History {
  if (entry.before === entry.after) return history;
  const last = history.past.at(-1);
  if (entry.run !== undefined && last?.run === entry.run && last.after === entry.before) {
    const joined = { ...entry, before: last.before, placeBefore: last.placeBefore };
    return { past: [...history.past.slice(0, -1), joined], future: [] };
  }
  return { past: [...history.past, entry], future: [] };
}

export function undo(history: History): { history: History; entry: Entry } | undefined {
  const entry = history.past.at(-1);
  if (!entry) return undefined;
  return { entry, history: { past: history.past.slice(0, -1), future: [...history.future, entry] } };
}

export function redo(history: History): { history: History; entry: Entry } | undefined {
  const entry = history.future.at(-1);
  if (!entry) return undefined;
  return { entry, history: { past: [...history.past, entry], future: history.future.slice(0, -1) } };
}
