// What comes into view by itself: the icon that the keyboard is at, one that was just added, and what runs.
import { useReactFlow, type ReactFlowInstance } from "@xyflow/react";
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

/** Moves the canvas as little as it takes to see the whole icon. */
function reveal(flow: ReactFlowInstance, icon: Icon, duration: number): void {
  const box = document.querySelector(".canvas")?.getBoundingClientRect();
  if (!box) return;
  const { x, y, zoom } = flow.getViewport();
  const size = sizeOf(icon);
  const left = (icon.at?.[0] ?? 0) * zoom + x, top = (icon.at?.[1] ?? 0) * zoom + y;
  const right = left + size.width * zoom, bottom = top + size.height * zoom;
  const dx = left < 0 ? room - left : right > box.width ? box.width - room - right : 0;
  const dy = top < 0 ? room - top : bottom > box.height ? box.height - room - bottom : 0;
  if (dx !== 0 || dy !== 0) void flow.setViewport({ x: x + dx, y: y + dy, zoom }, { duration });
}

/** The smallest size at which the words of icons are read well. */
const readable = 0.6;

/** True: all icons have room at a size at which they are read, and are shown so. */
function showAll(flow: ReactFlowInstance, icons: readonly Icon[]): boolean {
  const box = document.querySelector(".canvas")?.getBoundingClientRect();
  if (!box) return false;
  const right = (icon: Icon) => (icon.at?.[0] ?? 0) + sizeOf(icon).width, bottom = (icon: Icon) => (icon.at?.[1] ?? 0) + sizeOf(icon).height;
  const width = Math.max(...icons.map(right)) - Math.min(...icons.map((icon) => icon.at?.[0] ?? 0));
  const height = Math.max(...icons.map(bottom)) - Math.min(...icons.map((icon) => icon.at?.[1] ?? 0));
  if (Math.min((box.width - 2 * room) / width, (box.height - 2 * room) / height) < readable) return false;
  void flow.fitView({ maxZoom: flow.getZoom(), padding: `${room}px`, duration: 160 });
  return true;
}

function Reveal() {
  const flow = useReactFlow();
  const focus = useDrawing((state) => state.focus);
  const count = useRef(0);
  useEffect(() => {
    const { icons } = shownOperation(useDrawing.getState());
    const added = icons.length === count.current + 1;
    count.current = icons.length;
    const icon = icons.find((each) => each.id === focus);
    if (!icon) return;
    const box = document.querySelector(".canvas")?.getBoundingClientRect();
    const { x, y, zoom } = flow.getViewport();
    const left = (icon.at?.[0] ?? 0) * zoom + x, top = (icon.at?.[1] ?? 0) * zoom + y, size = sizeOf(icon);
    const seen = box && left >= 0 && top >= 0 && left + size.width * zoom <= box.width && top + size.height * zoom <= box.height;
    if (seen || (added && showAll(flow, icons))) return;
    reveal(flow, icon, 120);
  }, [focus, flow]);
  return null;
}

export function Follow() {
  const flow = useReactFlow();
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
      reveal(flow, icon, 160);
    }
  }, [here, jump, on, running, flow]);
  return <Reveal />;
}
