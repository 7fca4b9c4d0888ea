// What comes into view by itself: the icon that the keyboard is at, one that was just added, and what runs.
import { useReactFlow, useStoreApi, type ReactFlowInstance } from "@xyflow/react";
import { useEffect, useRef } from "react";
import { create } from "zustand";
import type { Icon } from "../model/operation";
import { culprit } from "../state/cause";
import { useCell } from "../state/cell";
import { enter, shownOperation, useDrawing } from "../state/drawing";
import { isLoaded } from "./runState";
import { sizeOf } from "./shape";

export const useFollow = create<{ on: boolean; jump: number }>()(() => ({ on: true, jump: 0 }));

const room = 40;
type Store = ReturnType<typeof useStoreApi>;

/** Where an icon lies on the screen, and how large the canvas is: from what React Flow knows, so that nothing is laid out for it. */
function seenAt(store: Store, icon: Icon) {
  const { width, height, transform: [x, y, zoom] } = store.getState();
  const size = sizeOf(icon);
  const left = (icon.at?.[0] ?? 0) * zoom + x, top = (icon.at?.[1] ?? 0) * zoom + y;
  return { width, height, x, y, zoom, left, top, right: left + size.width * zoom, bottom: top + size.height * zoom };
}

/** Moves the canvas as little as it takes to see the whole icon. */
function reveal(flow: ReactFlowInstance, store: Store, icon: Icon, duration: number): void {
  const { width, height, x, y, zoom, left, top, right, bottom } = seenAt(store, icon);
  const dx = left < 0 ? room - left : right > width ? width - room - right : 0;
  const dy = top < 0 ? room - top : bottom > height ? height - room - bottom : 0;
  if (dx !== 0 || dy !== 0) void flow.setViewport({ x: x + dx, y: y + dy, zoom }, { duration });
}

/** The smallest size at which the words of icons are read well. */
export const readable = 0.6;

/** True: all icons have room at a size at which they are read, and are shown so. */
function showAll(flow: ReactFlowInstance, box: { width: number; height: number }, icons: readonly Icon[]): boolean {
  const right = (icon: Icon) => (icon.at?.[0] ?? 0) + sizeOf(icon).width, bottom = (icon: Icon) => (icon.at?.[1] ?? 0) + sizeOf(icon).height;
  const width = Math.max(...icons.map(right)) - Math.min(...icons.map((icon) => icon.at?.[0] ?? 0));
  const height = Math.max(...icons.map(bottom)) - Math.min(...icons.map((icon) => icon.at?.[1] ?? 0));
  if (Math.min((box.width - 2 * room) / width, (box.height - 2 * room) / height) < readable) return false;
  void flow.fitView({ maxZoom: flow.getZoom(), padding: `${room}px`, duration: 160 });
  return true;
}

function Reveal() {
  const flow = useReactFlow(), store = useStoreApi();
  const focus = useDrawing((state) => state.focus);
  const count = useRef(0);
  useEffect(() => {
    const { icons } = shownOperation(useDrawing.getState());
    const added = icons.length === count.current + 1;
    count.current = icons.length;
    const icon = icons.find((each) => each.id === focus);
    if (!icon) return;
    const { width, height, left, top, right, bottom } = seenAt(store, icon);
    const seen = left >= 0 && top >= 0 && right <= width && bottom <= height;
    if (seen || (added && showAll(flow, { width, height }, icons))) return;
    reveal(flow, store, icon, 120);
  }, [focus, flow, store]);
  return null;
}

export function Follow() {
  const flow = useReactFlow(), store = useStoreApi();
  const { on, jump } = useFollow();
  const name = useDrawing((state) => state.drawing.name);
  const here = useCell((cell) => {
    if (!isLoaded(cell, name) || cell.present?.snapshot.state === "ready") return undefined;
    return culprit(cell.present) ?? cell.present?.snapshot.here?.icon;
  });
  const running = useCell((cell) => cell.present?.snapshot.state === "running");
  useEffect(() => {
    if (here === undefined || (jump === 0 && !(on && running))) return;
    const parts = here.split("/"), id = parts.at(-1)!;
    const state = useDrawing.getState();
    if (parts.slice(0, -1).join("/") !== state.trail.join("/")) enter(parts.slice(0, -1));
    const icon = shownOperation(useDrawing.getState()).icons.find((each) => each.id === id);
    if (!icon) return;
    if (jump > 0) {
      const size = sizeOf(icon), { zoom } = flow.getViewport();
      void flow.setCenter((icon.at?.[0] ?? 0) + size.width / 2, (icon.at?.[1] ?? 0) + size.height / 2, { zoom: Math.max(zoom, readable), duration: 160 });
      useFollow.setState({ jump: 0 });
    } else {
      reveal(flow, store, icon, 160);
    }
  }, [here, jump, on, running, flow, store]);
  return <Reveal />;
}
