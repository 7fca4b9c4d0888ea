// The drawing on the canvas: the document, where one looks at it, what is selected, and its history.
import { create } from "zustand";
import { noHistory, record, redo as redoIn, undo as undoIn, type Entry, type History } from "../model/history";
import { empty, iconOf, operationNamed, withOperation, type Drawing, type Operation } from "../model/operation";

export interface DrawingState {
  drawing: Drawing;
  /** The hierarchical icons from the first operation down to the one that is shown. */
  trail: readonly string[];
  selected: ReadonlySet<string>;
  /** The icon that the keyboard is at. */
  focus: string | undefined;
  history: History;
  /** In the store; undefined: it has no name there yet. */
  name: string | undefined;
  version: number;
  /** As it was saved or opened; another object: something has changed. */
  saved: Drawing;
  /** Counts the documents that were opened: each is shown whole at first. */
  opened: number;
  /** Said to a screen reader. */
  said: string;
}

const nothing = empty("untitled");

export const useDrawing = create<DrawingState>()(() => ({
  drawing: nothing,
  trail: [],
  selected: new Set(),
  focus: undefined,
  history: noHistory,
  name: undefined,
  version: 0,
  saved: nothing,
  opened: 0,
  said: "",
}));

/** The operation at the end of the trail; as far as the trail leads, if icons of it have gone. */
export function walk(drawing: Drawing, trail: readonly string[]): { operation: Operation; trail: string[] } {
  let operation = drawing as Operation;
  const walked: string[] = [];
  for (const id of trail) {
    const icon = iconOf(operation, id);
    const next = icon?.kind === "operation" && !icon.file && icon.operation ? operationNamed(drawing, icon.operation) : undefined;
    if (!next) break;
    operation = next;
    walked.push(id);
  }
  return { operation, trail: walked };
}

export const shownOperation = (state: DrawingState): Operation => walk(state.drawing, state.trail).operation;
export const isChanged = (state: DrawingState): boolean => state.drawing !== state.saved;

interface EditOptions {
  /** Key strokes in one field are one entry. */
  run?: string;
  select?: Iterable<string>;
  trail?: readonly string[];
}

/** Changes the document, as one entry of its history. `label` is a key of the words. */
export function edit(label: string, change: (drawing: Drawing) => Drawing, options: EditOptions = {}): void {
  const state = useDrawing.getState();
  const after = change(state.drawing);
  const selected = options.select ? new Set(options.select) : keepThere(state, after);
  const trail = walk(after, options.trail ?? state.trail).trail;
  if (after === state.drawing) return useDrawing.setState({ selected, trail });
  const entry: Entry = {
    label,
    before: state.drawing,
    after,
    placeBefore: { path: [...state.trail], selected: [...state.selected] },
    placeAfter: { path: trail, selected: [...selected] },
    ...(options.run === undefined ? {} : { run: options.run }),
  };
  const focus = [...selected].at(-1) ?? state.focus;
  useDrawing.setState({ drawing: after, trail, selected, focus, history: record(state.history, entry) });
}

function keepThere(state: DrawingState, after: Drawing): Set<string> {
  const ids = new Set(walk(after, state.trail).operation.icons.map((icon) => icon.id));
  return new Set([...state.selected].filter((id) => ids.has(id)));
}

/** Changes the operation that is shown. */
export function editShown(label: string, change: (operation: Operation) => Operation, options: EditOptions = {}): void {
  const { name } = shownOperation(useDrawing.getState());
  edit(label, (drawing) => {
    const operation = operationNamed(drawing, name);
    if (!operation) return drawing;
    const changed = change(operation);
    return changed === operation ? drawing : withOperation(drawing, name, changed);
  }, options);
}

export function undo(): Entry | undefined {
  const { history } = useDrawing.getState();
  const step = undoIn(history);
  if (!step) return undefined;
  const { before, placeBefore } = step.entry;
  useDrawing.setState({ drawing: before, history: step.history, trail: walk(before, placeBefore.path).trail, selected: new Set(placeBefore.selected) });
  return step.entry;
}

export function redo(): Entry | undefined {
  const { history } = useDrawing.getState();
  const step = redoIn(history);
  if (!step) return undefined;
  const { after, placeAfter } = step.entry;
  useDrawing.setState({ drawing: after, history: step.history, trail: walk(after, placeAfter.path).trail, selected: new Set(placeAfter.selected) });
  return step.entry;
}

/** Another document: a new one, one of the store, or one that the cell runs. */
export function show(drawing: Drawing, from: { name?: string | undefined; version?: number; changed?: boolean } = {}): void {
  useDrawing.setState({
    opened: useDrawing.getState().opened + 1, drawing, trail: [], selected: new Set(), focus: undefined, history: noHistory,
    name: from.name, version: from.version ?? 0, saved: from.changed ? { ...drawing } : drawing,
  });
}

export function select(ids: Iterable<string>, focus?: string): void {
  const selected = new Set(ids);
  useDrawing.setState({ selected, focus: focus ?? [...selected].at(-1) ?? useDrawing.getState().focus });
}

export function enter(trail: readonly string[], selected: Iterable<string> = []): void {
  const state = useDrawing.getState();
  const walked = walk(state.drawing, trail).trail;
  useDrawing.setState({ trail: walked, selected: new Set(selected), focus: [...selected].at(-1) });
}

export function say(said: string): void {
  useDrawing.setState({ said });
}
