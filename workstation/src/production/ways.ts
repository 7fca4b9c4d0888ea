// Which way each run has taken through the operation, and how long it took beside what is proved or declared for that way.
// Plain functions.
import type { Way } from "../../generated/protocol";
import { spreadOf, type Cycle, type Spread } from "./shift";

export interface Passed {
  icon: string;
  code: number | undefined;
}

export interface WayTaken {
  /** Undefined: runs whose way is none of those that are known. */
  way: Way | undefined;
  count: number;
  spread: Spread;
}

/** Each once, in the order in which they came first: turns of a loop are one way. */
const once = (icons: readonly string[]): string => [...new Set(icons)].join("\n");

/** As the server names the icons of a way: "side-1 (0)". */
export const passedText = ({ icon, code }: Passed): string => (code === undefined ? icon : `${icon} (${code})`);

/** The ways that were taken, the most frequent first. `steps`: of each run what acted, in its order; runs without steps are left out. */
export function byWay(ways: readonly Way[], cycles: readonly Cycle[], steps: ReadonlyMap<number, readonly Passed[]>): WayTaken[] {
  const known = new Map(ways.map((each) => [once(each.icons), each]));
  const found = new Map<Way | undefined, Cycle[]>();
  for (const cycle of cycles) {
    const passed = steps.get(cycle.run);
    if (!passed) continue;
    const way = known.get(once(passed.map(passedText)));
    found.set(way, [...(found.get(way) ?? []), cycle]);
  }
  return [...found].map(([way, taken]) => ({ way, count: taken.length, spread: spreadOf(taken)! })).sort((a, b) => b.count - a.count);
}

/** A way in few words: how it ended, and the last icon that acted. */
export const lastOf = (way: Way): string => (way.icons.at(-1) ?? "").replaceAll("/", " › ");
