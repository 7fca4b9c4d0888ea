// Where the connectors of an icon are, on the outline of its family.
import type { Icon } from "../model/operation";
import { outputs } from "../model/ports";
import { inputHeight, outputHeight, sizeOf, type Family } from "./shape";

/** How far the outline is from the right (or left) side of its box at this height. */
function indent(family: Family, width: number, height: number, y: number, side: "left" | "right"): number {
  const off = Math.abs(y - height / 2);
  if (family === "sense" || family === "end") {
    const r = height / 2;
    return r - Math.sqrt(Math.max(0, r * r - off * off));
  }
  if (family === "move" && side === "right") return (16 * off) / (height / 2);
  if (family === "grip") return Math.max(0, off - (height / 2 - 12));
  return width === 40 ? 0 : 0;
}

export interface Spot {
  name: string;
  x: number;
  y: number;
}

export function inputSpot(icon: Icon, family: Family): Spot {
  const { width, height } = sizeOf(icon);
  const y = inputHeight;
  return { name: "in", x: indent(family, width, height, y, "left"), y };
}

export function outputSpots(icon: Icon, family: Family): Spot[] {
  const { width, height } = sizeOf(icon);
  return outputs(icon).map((port, i) => {
    const y = outputHeight(icon, i);
    return { name: port.name, x: width - indent(family, width, height, y, "right"), y };
  });
}
