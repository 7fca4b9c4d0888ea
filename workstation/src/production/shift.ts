// A shift in figures, from the runs that the cell keeps: counts, cycle times, what stood and why. Plain functions.
import type { Run } from "../../generated/protocol";

export interface Cycle {
  run: number;
  begun: number;
  /** Of the cell, s. */
  took: number;
  code: number;
}

export interface Standstill {
  run: number;
  name: string;
  /** When, ms since 1970. */
  from: number;
  /** When something was run again; undefined: not yet. */
  until: number | undefined;
  state: string;
  code: number | null;
  reason: string;
}

export interface Shift {
  runs: number;
  good: number;
  /** Ended with another code. */
  other: number;
  /** Stopped, failed, broken off. */
  broken: number;
  /** While something ran, ms on the wall. */
  worked: number;
  cycles: readonly Cycle[];
  stops: readonly Standstill[];
}

const time = (wall: string) => Date.parse(wall);
const broken = new Set(["stopped", "failed", "broken off"]);

/** `runs` in any order; those of `name` alone, unless it is empty, begun from `since` on. `now` in ms. */
export function shiftOf(all: readonly Run[], name: string, since: number, now: number): Shift {
  const later = all.filter((each) => time(each.begun) >= since).sort((a, b) => a.run - b.run);
  const runs = later.filter((each) => each.kind === "operation" && (name === "" || each.name === name));
  const ended = runs.filter((each) => each.state === "ended");
  const bad = (each: Run) => broken.has(each.state) || each.state === "paused" || (each.state === "ended" && each.code !== 0);
  const stops = runs.filter(bad).map((each): Standstill => {
    const next = later.find((one) => one.run > each.run);
    const from = each.ended === null ? time(each.begun) : time(each.ended);
    return { run: each.run, name: each.name, from, until: next ? time(next.begun) : undefined, state: each.state, code: each.code, reason: each.reason };
  });
  return {
    runs: runs.length,
    good: ended.filter((each) => each.code === 0).length,
    other: ended.filter((each) => each.code !== 0).length,
    broken: runs.filter((each) => broken.has(each.state)).length,
    worked: runs.reduce((sum, each) => sum + ((each.ended === null ? now : time(each.ended)) - time(each.begun)), 0),
    cycles: ended.flatMap((each) => (each.end_s === null ? [] : [{ run: each.run, begun: time(each.begun), took: each.end_s - each.begin_s, code: each.code ?? 0 }])),
    stops,
  };
}

export interface Spread {
  shortest: number;
  median: number;
  longest: number;
}

export function spreadOf(cycles: readonly Cycle[]): Spread | undefined {
  if (cycles.length === 0) return undefined;
  const times = cycles.map((each) => each.took).sort((a, b) => a - b), middle = times.length >> 1;
  return { shortest: times[0]!, median: times.length % 2 === 1 ? times[middle]! : (times[middle - 1]! + times[middle]!) / 2, longest: times.at(-1)! };
}
