// Locations as numbers: how two differ, which names an operation needs, the places of a pallet. No page, no server.
import type { Location, Skill } from "../../generated/protocol";
import { operationsOf, type Drawing } from "../model/operation";

export type Pose = readonly [number, number, number, number, number, number];

/** mm from one tip to the other. */
export const apart = (a: readonly number[], b: readonly number[]): number => Math.hypot(a[0]! - b[0]!, a[1]! - b[1]!, a[2]! - b[2]!);

/** Of each figure; of angles the shorter way, degrees. */
export function difference(a: readonly number[], b: readonly number[]): number[] {
  return a.map((each, i) => {
    const more = b[i]! - each;
    return i < 3 ? more : ((((more + 180) % 360) + 360) % 360) - 180;
  });
}

/** The names of locations in a drawing, each with the icons that need it. */
export function needed(drawing: Drawing, skills: ReadonlyMap<string, Skill>): Map<string, string[]> {
  const found = new Map<string, string[]>();
  for (const operation of operationsOf(drawing))
    for (const icon of operation.icons) {
      if (icon.kind !== "skill") continue;
      for (const parameter of skills.get(icon.skill ?? "")?.parameters ?? []) {
        if (!parameter.location) continue;
        const value = icon.parameters?.[parameter.name] ?? parameter.default;
        if (typeof value === "string") found.set(value, [...(found.get(value) ?? []), icon.id]);
      }
    }
  return found;
}

export interface Pallet {
  /** The first place, the last of its row, the last of its column. */
  first: Pose;
  rowEnd: Pose;
  columnEnd: Pose;
  /** Places along the row and along the column. */
  along: number;
  across: number;
}

/** All places, row by row; the tool stands as at the first one. */
export function placesOf({ first, rowEnd, columnEnd, along, across }: Pallet): Pose[] {
  const part = (count: number, i: number) => (count > 1 ? i / (count - 1) : 0);
  const places: Pose[] = [];
  for (let j = 0; j < across; ++j)
    for (let i = 0; i < along; ++i) {
      const at = (axis: 0 | 1 | 2) => first[axis] + (rowEnd[axis] - first[axis]) * part(along, i) + (columnEnd[axis] - first[axis]) * part(across, j);
      places.push([at(0), at(1), at(2), first[3], first[4], first[5]]);
    }
  return places;
}

/** Why the three corners are none of a pallet; undefined: they are. */
export function wrongCorners({ first, rowEnd, columnEnd, along, across }: Pallet): "same" | "line" | undefined {
  const least = 5;
  if ((along > 1 && apart(first, rowEnd) < least) || (across > 1 && apart(first, columnEnd) < least)) return "same";
  if (along === 1 || across === 1) return undefined;
  const a = [0, 1, 2].map((i) => rowEnd[i]! - first[i]!), b = [0, 1, 2].map((i) => columnEnd[i]! - first[i]!);
  const cross = Math.hypot(a[1]! * b[2]! - a[2]! * b[1]!, a[2]! * b[0]! - a[0]! * b[2]!, a[0]! * b[1]! - a[1]! * b[0]!);
  // Under ten degrees apart they are one line.
  return cross / (Math.hypot(...a) * Math.hypot(...b)) < 0.17 ? "line" : undefined;
}

/** "P3": the first that is not taught. */
export function freeLocation(locations: readonly Location[], stem = "P"): string {
  const taken = new Set(locations.map((each) => each.location));
  for (let i = 1; ; ++i) if (!taken.has(`${stem}${i}`)) return `${stem}${i}`;
}
