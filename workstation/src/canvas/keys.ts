// The keyboard on the canvas. Everything that the mouse does is done here, too; `keys` is also what the help shows.
import type { Icon, Operation, Point } from "../model/operation";
import { lines, outputs } from "../model/ports";
import { enter, say, select, shownOperation, useDrawing } from "../state/drawing";
import { connectIcons, copySelected, disconnect, nudge, pasteClip, popOpen, portFor, redoSaid, removeSelected, undoSaid } from "../state/edits";
import { openIcon, openWindow } from "../state/windows";
import { t, type Word } from "../words/words";
import { sizeOf } from "./shape";
import { useView } from "./view";
import { portText } from "./describe";

/** In the order of the help. `+` stands between keys that are pressed together. */
export const keys: readonly { keys: string; word: Word }[] = [
  { keys: "← → ↑ ↓", word: "key.move" },
  { keys: "Enter", word: "key.open" },
  { keys: "A…Z", word: "key.insert" },
  { keys: "Ctrl+L", word: "key.from" },
  { keys: "Ctrl+Enter", word: "key.to" },
  { keys: "Ctrl+K", word: "key.connect" },
  { keys: "Ctrl+U", word: "key.disconnect" },
  { keys: "Space", word: "key.select" },
  { keys: "Shift+←", word: "key.nudge" },
  { keys: "Delete", word: "key.delete" },
  { keys: "Ctrl+C", word: "key.copy" },
  { keys: "Ctrl+V", word: "key.paste" },
  { keys: "Ctrl+Z", word: "key.undo" },
  { keys: "Ctrl+Shift+Z", word: "key.redo" },
  { keys: "Ctrl+A", word: "key.all" },
  { keys: "Ctrl+↓", word: "key.enter" },
  { keys: "Ctrl+↑", word: "key.leave" },
  { keys: "Shift+F10", word: "key.menu" },
  { keys: "?", word: "key.offer" },
  { keys: "F5", word: "key.run" },
  { keys: "F6", word: "key.pause" },
  { keys: "F8", word: "key.step" },
  { keys: "F9", word: "key.stop" },
  { keys: "F1", word: "key.help" },
];

const centre = (icon: Icon): Point => {
  const { width, height } = sizeOf(icon);
  return [(icon.at?.[0] ?? 0) + width / 2, (icon.at?.[1] ?? 0) + height / 2];
};

/** The nearest icon in the direction of an arrow key: what lies straight ahead counts as nearer. At most `widest` times as far aside as ahead. */
export function nearest(operation: Operation, from: string, dx: number, dy: number, widest = 3): string | undefined {
  const start = operation.icons.find((icon) => icon.id === from);
  if (!start) return operation.icons[0]?.id;
  const [x, y] = centre(start);
  let best: { id: string; cost: number } | undefined;
  for (const icon of operation.icons) {
    if (icon === start) continue;
    const [cx, cy] = centre(icon);
    const ahead = (cx - x) * dx + (cy - y) * dy, aside = Math.abs((cx - x) * dy) + Math.abs((cy - y) * dx);
    if (ahead <= 4 || aside > widest * ahead) continue;
    const cost = ahead + 2 * aside;
    if (!best || cost < best.cost) best = { id: icon.id, cost };
  }
  return best?.id;
}

/** At the end of a row: the icon of the next row to which a line leads, or the one from which it comes. */
function along(operation: Operation, from: string, dx: number): string | undefined {
  const all = lines(operation);
  return dx > 0 ? all.find((line) => line.from === from)?.to : dx < 0 ? all.find((line) => line.to === from)?.from : undefined;
}

export function focusIcon(id: string | undefined): void {
  if (id === undefined) return;
  requestAnimationFrame(() => document.querySelector<HTMLElement>(`.icon[data-id="${CSS.escape(id)}"]`)?.focus({ preventScroll: true }));
}

const arrows: Record<string, [number, number]> = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };

function arrow(event: KeyboardEvent, [dx, dy]: [number, number]): void {
  const state = useDrawing.getState();
  const operation = shownOperation(state);
  if (event.shiftKey) return nudge(dx * 8, dy * 8);
  if (event.ctrlKey || event.metaKey) {
    if (dy > 0 && state.focus) popOpen(state.focus);
    if (dy < 0 && state.trail.length > 0) enter(state.trail.slice(0, -1), [state.trail.at(-1)!]);
    return focusIcon(useDrawing.getState().focus ?? shownOperation(useDrawing.getState()).icons[0]?.id);
  }
  const next = state.focus === undefined ? operation.icons[0]?.id : nearest(operation, state.focus, dx, dy, 1) ?? along(operation, state.focus, dx) ?? nearest(operation, state.focus, dx, dy);
  if (next === undefined) return say(t("said.noNeighbour"));
  select([next], next);
  focusIcon(next);
}

function beginLine(id: string): void {
  const icon = shownOperation(useDrawing.getState()).icons.find((each) => each.id === id);
  if (!icon) return;
  const all = outputs(icon);
  if (all.length === 0) return say(t("said.noOutput", { name: id }));
  const { lineFrom } = useView.getState();
  // Again at the same icon: its next output.
  const index = lineFrom?.icon === id ? (all.findIndex((port) => port.name === lineFrom.port) + 1) % all.length : all.findIndex((port) => port.name === portFor(id));
  const port = all[index]!.name;
  useView.setState({ lineFrom: { icon: id, port } });
  say(t("said.lineFrom", { name: id, port: portText(icon, port) }));
}

function endLine(id: string): void {
  const { lineFrom } = useView.getState();
  if (!lineFrom) return say(t("said.noLine"));
  connectIcons(lineFrom.icon, lineFrom.port, id);
  useView.setState({ lineFrom: undefined });
}

function unline(id: string): void {
  const { line } = useView.getState();
  const port = line?.from === id ? line.port : outputs(shownOperation(useDrawing.getState()).icons.find((each) => each.id === id)!).findLast((each) => each.to !== undefined)?.name;
  if (port !== undefined) disconnect(id, port);
}

function remove(): void {
  const state = useDrawing.getState();
  const { line } = useView.getState();
  if (line) {
    disconnect(line.from, line.port);
    return useView.setState({ line: undefined });
  }
  const operation = shownOperation(state);
  const left = [...state.selected].map((id) => nearest({ ...operation, icons: operation.icons.filter((icon) => icon.id === id || !state.selected.has(icon.id)) }, id, -1, 0))
    .find((id) => id !== undefined);
  const next = left ?? operation.icons.find((icon) => !state.selected.has(icon.id))?.id;
  removeSelected(next);
  focusIcon(next);
}

/** Where the list for a new icon opens: beside the icon that the keyboard is at. */
function insertBeside(text: string): void {
  const { insert } = useView.getState();
  // Typed faster than the list took the focus.
  if (insert) return useView.setState({ insert: { ...insert, text: insert.text + text } });
  const state = useDrawing.getState();
  const operation = shownOperation(state);
  const beside = operation.icons.find((icon) => icon.id === state.focus);
  const open = beside && outputs(beside).find((port) => port.to === undefined);
  const box = document.querySelector(`.icon[data-id="${CSS.escape(state.focus ?? "")}"]`)?.getBoundingClientRect();
  const screen: Point = box ? [Math.min(box.right + 24, innerWidth - 340), Math.min(box.top, innerHeight - 400)] : [innerWidth / 2 - 160, innerHeight / 3];
  useView.setState({ insert: { at: placeBehind(operation, beside), screen, text, from: beside && open ? { icon: beside.id, port: open.name } : undefined } });
}

const room = 32;

/** The icons that a new one at this place would lie on or touch. */
function inTheWay(operation: Operation, [x, y]: Point): Icon[] {
  return operation.icons.filter((icon) => {
    const [left, top] = icon.at ?? [0, 0], { width, height } = sizeOf(icon);
    return left < x + 184 + room && x < left + width + room && top < y + 48 + room && y < top + height + room;
  });
}

/** Down from `at`, the first place where a new icon lies on no other. */
export function freePlace(operation: Operation, at: Point): Point {
  for (let [x, y] = at; ; y += 32) if (inTheWay(operation, [x, y]).length === 0) return [x, y];
}

/** Where a new icon goes that follows this one: at its right, or in a new row when this one is as long as is read well. */
export function placeBehind(operation: Operation, before: Icon | undefined): Point {
  if (!before) return freePlace(operation, [0, 0]);
  const [x, y] = before.at ?? [0, 0];
  const first = Math.min(...operation.icons.map((icon) => icon.at?.[0] ?? 0));
  const longest = (document.querySelector(".canvas")?.clientWidth ?? 1024) / 0.85;
  const right = x + sizeOf(before).width + 64;
  if (right + 184 - first <= longest) return freePlace(operation, [right, y]);
  // Behind START, which begins the row above.
  const start = operation.icons.find((icon) => icon.kind === "start" && icon.at?.[0] === first);
  return freePlace(operation, [start ? first + sizeOf(start).width + 64 : first, y + 136]);
}

/** `at`; if a new icon would touch others there, the nearest place beside them, so that every connector can be reached. */
export function besides(operation: Operation, at: Point): Point {
  const others = inTheWay(operation, at);
  if (others.length === 0) return at;
  const right = Math.max(...others.map((icon) => (icon.at?.[0] ?? 0) + sizeOf(icon).width)) + room;
  const left = Math.min(...others.map((icon) => icon.at?.[0] ?? 0)) - room - 184;
  const aside = [right, left].sort((a, b) => Math.abs(a - at[0]) - Math.abs(b - at[0])).map((x): Point => [x, at[1]]);
  return aside.find((each) => inTheWay(operation, each).length === 0) ?? freePlace(operation, at);
}

function withCtrl(event: KeyboardEvent): boolean {
  const { focus } = useDrawing.getState();
  switch (event.key.toLowerCase()) {
    case "a": select(shownOperation(useDrawing.getState()).icons.map((icon) => icon.id)); return true;
    case "c": copySelected(); return true;
    case "x": copySelected(); remove(); return true;
    case "v": pasteClip(); focusIcon(useDrawing.getState().focus); return true;
    case "l": if (focus) beginLine(focus); return true;
    case "k": if (focus) useView.setState({ connecting: { icon: focus, port: useView.getState().lineFrom?.port } }); return true;
    case "u": if (focus) unline(focus); return true;
    case "enter": if (focus) endLine(focus); return true;
    default: return false;
  }
}

/** Undo, redo, help: wherever the focus is, unless a text is being written. True: it was such a key. */
export function everywhere(event: KeyboardEvent): boolean {
  const ctrl = event.ctrlKey || event.metaKey;
  if (ctrl && event.key.toLowerCase() === "z") return event.shiftKey ? redoSaid() : undoSaid(), true;
  if (ctrl && event.key.toLowerCase() === "y") return redoSaid(), true;
  if (event.key === "F1") return openWindow("keys"), true;
  return false;
}

/** Keys while an icon or the empty canvas has the focus. True: it was one of them. */
export function onCanvas(event: KeyboardEvent): boolean {
  const state = useDrawing.getState();
  const direction = arrows[event.key];
  if (direction) return arrow(event, direction), true;
  if (event.ctrlKey || event.metaKey) return withCtrl(event);
  if (event.altKey) return false;
  switch (event.key) {
    case "Enter":
      if (state.focus) openIcon(shownOperation(state).name, state.focus);
      return true;
    case "Delete": case "Backspace": return remove(), true;
    case " ": {
      if (!state.focus) return true;
      const selected = new Set(state.selected);
      if (!selected.delete(state.focus)) selected.add(state.focus);
      select(selected, state.focus);
      return true;
    }
    case "Escape":
      useView.setState({ lineFrom: undefined, line: undefined, insert: undefined, menu: undefined });
      select([], state.focus);
      return true;
    case "ContextMenu": case "F10":
      if (event.key === "F10" && !event.shiftKey) return false;
      if (state.focus) openMenu(state.focus);
      return true;
    default:
      if (event.key.length === 1 && /[\p{L}\p{N}/?]/u.test(event.key)) {
        insertBeside(event.key === "/" ? "" : event.key);
        return true;
      }
      return false;
  }
}

export function openMenu(id: string, at?: Point): void {
  const box = document.querySelector(`.icon[data-id="${CSS.escape(id)}"]`)?.getBoundingClientRect();
  useView.setState({ menu: { icon: id, screen: at ?? (box ? [box.left + 24, box.bottom] : [innerWidth / 2, innerHeight / 2]) } });
}

