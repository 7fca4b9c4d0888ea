// The way that a run has taken: by the icons that acted and their codes, each once.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Way } from "../../generated/protocol";
import { byWay, type Passed } from "../../src/production/ways";

const way = (longest_s: number | null, ...icons: string[]): Way => ({ icons, end: `exit after ${icons.length}`, shortest_s: 0, longest_s, unbounded: [], declared: true, alike: 1 });
const ways = [way(10, "find (0)", "press (0)"), way(4, "find (1)"), way(null, "find (0)", "press (2)", "pause")];
const cycle = (run: number, took: number) => ({ run, begun: run, took, code: 0 });
const passed = (...icons: [string, number?][]): Passed[] => icons.map(([icon, code]) => ({ icon, code }));

test("runs are put to their ways, turns of a loop are one, and what fits none is told apart", () => {
  const steps = new Map<number, readonly Passed[]>([
    [1, passed(["find", 0], ["press", 0])], [2, passed(["find", 0], ["press", 0], ["find", 0], ["press", 0])], [3, passed(["find", 1])],
    [4, passed(["find", 0], ["press", 2], ["pause"])], [5, passed(["look", 0])],
  ]);
  const taken = byWay(ways, [cycle(1, 3), cycle(2, 7), cycle(3, 5), cycle(4, 1), cycle(5, 2), cycle(6, 9)], steps);
  assert.deepEqual(taken.map((each) => [each.way?.longest_s, each.count, each.spread.shortest, each.spread.longest]), [[10, 2, 3, 7], [4, 1, 5, 5], [null, 1, 1, 1], [undefined, 1, 2, 2]]);
});
