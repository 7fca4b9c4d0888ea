// The families of icons: their outlines, sizes and where their connectors sit. A shape tells the family without
// colour; all lengths are pixels at zoom 1, on the grid of 8.
import type { Icon } from "../model/operation";
import { outputs } from "../model/ports";

export type Family = "move" | "sense" | "grip" | "other" | "flow" | "end" | "super";

export interface Size {
  width: number;
  height: number;
}

const row = 24;

export function sizeOf(icon: Icon): Size {
  switch (icon.kind) {
    case "start": return { width: 104, height: 40 };
    case "exit": return { width: exitWidth(icon), height: 40 };
    case "restart": return { width: 120, height: 40 };
    case "merge": return { width: 40, height: 40 };
    case "case": return { width: 192, height: 40 + row * outputs(icon).length + 8 };
    case "question": return { width: 192, height: 48 + row * outputs(icon).length + 8 };
    default: return { width: 184, height: 56 };
  }
}

/** An exit is as wide as its name asks for: names such as "no-part-found" are what one looks for at the end of a line. */
function exitWidth(icon: Icon): number {
  const wanted = 56 + 8.2 * icon.id.length + (icon.code === undefined ? 0 : 32);
  return Math.min(232, Math.max(136, Math.ceil(wanted / 8) * 8));
}

/** From the icon's top to the connector of its output. */
export function outputHeight(icon: Icon, index: number): number {
  const count = outputs(icon).length;
  if (icon.kind === "case") return 40 + row * index + row / 2;
  if (icon.kind === "question") return 48 + row * index + row / 2;
  if (count === 2) return index === 0 ? 20 : 44;
  return 20;
}

/** All at one height, so that icons that stand in a row are joined by straight lines. */
export const inputHeight = 20;

/** The outline as an SVG path, from (0, 0) to the size. */
export function outline(family: Family, { width: w, height: h }: Size): string {
  const r = 6;
  switch (family) {
    case "move": // an arrow's head at the right
      return `M${r} 0H${w - 16}L${w} ${h / 2}L${w - 16} ${h}H${r}Q0 ${h} 0 ${h - r}V${r}Q0 0 ${r} 0Z`;
    case "sense": // round ends
      return `M${h / 2} 0H${w - h / 2}A${h / 2} ${h / 2} 0 0 1 ${w - h / 2} ${h}H${h / 2}A${h / 2} ${h / 2} 0 0 1 ${h / 2} 0Z`;
    case "grip": // cut corners
      return `M12 0H${w - 12}L${w} 12V${h - 12}L${w - 12} ${h}H12L0 ${h - 12}V12Z`;
    case "flow": // slanted sides
      return `M10 0H${w - 2}Q${w} 0 ${w} 2V${h - 10}L${w - 10} ${h}H2Q0 ${h} 0 ${h - 2}V10Z`;
    case "end": // a capsule
      return `M${h / 2} 0H${w - h / 2}A${h / 2} ${h / 2} 0 0 1 ${w - h / 2} ${h}H${h / 2}A${h / 2} ${h / 2} 0 0 1 ${h / 2} 0Z`;
    default:
      return `M${r} 0H${w - r}Q${w} 0 ${w} ${r}V${h - r}Q${w} ${h} ${w - r} ${h}H${r}Q0 ${h} 0 ${h - r}V${r}Q0 0 ${r} 0Z`;
  }
}
