// Which windows are open, in what order they lie, and which panels are shown.
import { create } from "zustand";

export type WindowKind = "icon" | "skill" | "findings" | "store" | "breakpoints" | "explain" | "keys" | "versions" | "difference" | "ways" | "storyboard"
  | "channel" | "scene" | "sensors" | "gauges" | "requirement" | "tuning" | "locations" | "jog" | "production";

export interface OpenWindow {
  id: string;
  /** Stays the same when the window comes to be about something else. */
  key: number;
  kind: WindowKind;
  /** What it is about: "operation/icon", a skill, a code. */
  about: string;
  x: number;
  y: number;
}

interface Windows {
  /** The last one lies on top. */
  open: readonly OpenWindow[];
  /** Of the panels at the sides; on a narrow screen they are sheets. */
  palette: boolean;
  inspector: boolean;
}

const wide = typeof innerWidth === "undefined" || innerWidth >= 1400;

export const useWindows = create<Windows>()(() => ({ open: [], palette: typeof innerWidth === "undefined" || innerWidth >= 900, inspector: wide }));

let opened = 0;

/** Opens a window, or brings it to the front. */
export function openWindow(kind: WindowKind, about = ""): void {
  const { open } = useWindows.getState();
  const id = `${kind}:${about}`;
  const there = open.find((each) => each.id === id);
  if (there) return raise(id);
  const shift = (opened++ % 6) * 28;
  const [x, y] = (kind === "icon" ? besideIcon(about) : beyondTop(kind)) ?? [Math.max(12, Math.min(innerWidth - 480, 320 + shift)), 96 + shift];
  useWindows.setState({ open: [...open, { id, key: opened, kind, about, x, y }] });
}

/** A wide window hides not all of the one below it. */
function beyondTop(kind: WindowKind): [number, number] | undefined {
  const top = useWindows.getState().open.at(-1);
  if (kind === "findings" || innerWidth < 1100) return undefined;
  // The cell in 3-D stands at the right, so that what is looked at beside it has the rest.
  if (kind === "scene") return [Math.max(16, innerWidth - 776), 96];
  if (!top) return undefined;
  return [top.x >= 300 ? 16 : Math.min(innerWidth - 696, top.x + 140), 96];
}

const room = 424;

/** A dialog hides neither its icon nor what is said of a fault, where there is room beside them. */
function besideIcon(about: string): [number, number] | undefined {
  const id = about.slice(about.lastIndexOf("/") + 1);
  const box = document.querySelector(`.icon[data-id="${CSS.escape(id)}"]`)?.getBoundingClientRect();
  const told = document.querySelector(".go-on")?.getBoundingClientRect();
  const top = box ? Math.max(80, Math.min(box.top - 64, innerHeight - 640)) : 96;
  const taken = useWindows.getState().open;
  const free = (x: number) => x >= 8 && x + room <= innerWidth && !(told && x < told.right && top < told.bottom) && !taken.some((each) => Math.abs(each.x - x) < 16 && Math.abs(each.y - top) < 16);
  const places = [...(box ? [box.right + 24, box.left - room] : []), ...(told ? [told.right + 12] : [])];
  // No room: at the edge, where the least of it is hidden.
  const x = places.find(free) ?? (told ? innerWidth - room : undefined);
  return x === undefined ? undefined : [x, top];
}

/** The icon has another name now. */
export function retarget(id: string, about: string): void {
  useWindows.setState((state) => ({ open: state.open.map((each) => (each.id === id ? { ...each, id: `${each.kind}:${about}`, about } : each)) }));
}

export function raise(id: string): void {
  const { open } = useWindows.getState();
  const there = open.find((each) => each.id === id);
  if (there && open.at(-1) !== there) useWindows.setState({ open: [...open.filter((each) => each !== there), there] });
}

export function moveWindow(id: string, x: number, y: number): void {
  useWindows.setState((state) => ({ open: state.open.map((each) => (each.id === id ? { ...each, x, y } : each)) }));
}

export function closeWindow(id: string): void {
  useWindows.setState((state) => ({ open: state.open.filter((each) => each.id !== id) }));
}

export const openFindings = (operation: string, icon: string): void => openWindow("findings", `${operation}/${icon}`);
export const openIcon = (operation: string, icon: string): void => openWindow("icon", `${operation}/${icon}`);
