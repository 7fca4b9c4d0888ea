// The canvas follows what runs, if that is wished, and can jump there.
import { useReactFlow } from "@xyflow/react";
import { useEffect } from "react";
import { create } from "zustand";
import { useCell } from "../state/cell";
import { enter, shownOperation, useDrawing } from "../state/drawing";
import { isLoaded } from "./runState";
import { sizeOf } from "./shape";

export const useFollow = create<{ on: boolean; jump: number }>()(() => ({ on: true, jump: 0 }));

/** The icon that the keyboard has come to, or that was just added, comes into view. */
function Reveal() {
  const flow = useReactFlow();
  const focus = useDrawing((state) => state.focus);
  useEffect(() => {
    const icon = shownOperation(useDrawing.getState()).icons.find((each) => each.id === focus);
    const box = document.querySelector(".canvas")?.getBoundingClientRect();
    if (!icon || !box) return;
    const { x, y, zoom } = flow.getViewport();
    const size = sizeOf(icon), room = 40;
    const left = (icon.at?.[0] ?? 0) * zoom + x, top = (icon.at?.[1] ?? 0) * zoom + y;
    const right = left + size.width * zoom, bottom = top + size.height * zoom;
    const dx = left < 0 ? room - left : right > box.width ? box.width - room - right : 0;
    const dy = top < 0 ? room - top : bottom > box.height ? box.height - room - bottom : 0;
    if (dx !== 0 || dy !== 0) void flow.setViewport({ x: x + dx, y: y + dy, zoom }, { duration: 120 });
  }, [focus, flow]);
  return null;
}

export function Follow() {
  const flow = useReactFlow();
  const { on, jump } = useFollow();
  const name = useDrawing((state) => state.drawing.name);
  const here = useCell((cell) => (isLoaded(cell, name) && cell.present?.snapshot.state !== "ready" ? cell.present?.snapshot.here?.icon : undefined));
  const running = useCell((cell) => cell.present?.snapshot.state === "running");
  useEffect(() => {
    if (here === undefined || (jump === 0 && !(on && running))) return;
    const parts = here.split("/"), id = parts.at(-1)!;
    const state = useDrawing.getState();
    if (parts.slice(0, -1).join("/") !== state.trail.join("/")) enter(parts.slice(0, -1));
    const icon = shownOperation(useDrawing.getState()).icons.find((each) => each.id === id);
    if (!icon) return;
    const size = sizeOf(icon);
    const x = (icon.at?.[0] ?? 0) + size.width / 2, y = (icon.at?.[1] ?? 0) + size.height / 2;
    const { x: left, y: top, zoom } = flow.getViewport();
    const box = document.querySelector(".canvas")?.getBoundingClientRect();
    const sx = x * zoom + left, sy = y * zoom + top;
    const seen = box && sx > 100 && sy > 60 && sx < box.width - 100 && sy < box.height - 60;
    if (!seen || jump > 0) void flow.setCenter(x, y, { zoom, duration: 160 });
    if (jump > 0) useFollow.setState({ jump: 0 });
  }, [here, jump, on, running, flow]);
  return <Reveal />;
}
