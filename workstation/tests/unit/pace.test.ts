// How live windows share a frame, and how finely the cell is drawn by the time that pictures take.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Turns } from "../../src/live/eachFrame";
import { finenesses, Pace } from "../../src/scene/pace";

test("windows that do not fit into a frame take turns, and one that is closed leaves no gap", () => {
  let now = 0, drawn = "";
  const turns = new Turns(() => now), look = (name: string, takes: number) => () => ((now += takes), (drawn += name));
  turns.add(look("a", 3));
  const end = turns.add(look("b", 3));
  turns.add(look("c", 3));
  const frames = (count: number) => {
    const seen: string[] = [];
    for (let i = 0; i < count; ++i) (drawn = "", turns.frame(), seen.push(drawn));
    return seen;
  };
  assert.deepEqual(frames(3), ["ab", "ca", "bc"]);
  end();
  assert.deepEqual(frames(2), ["ac", "ac"]);
  turns.add(look("long", 40));
  assert.deepEqual(frames(4), ["long", "ac", "long", "ac"]);
});

/** Draws pictures whose time is by their pixels, for so many ms; what was drawn last, and when each began. */
function drive(pace: Pace, forRatio: (ratio: number) => number, from: number, duration: number): { ratio: number; begun: number[] } {
  const begun: number[] = [];
  let ratio = NaN, ends = -1;
  for (let now = from; now < from + duration; now += 16) {
    if (pace.drawing && now >= ends) pace.end(now);
    if (!pace.may(now)) continue;
    ({ ratio } = pace.begin(now, false));
    ends = now + forRatio(ratio);
    begun.push(now);
  }
  return { ratio, begun };
}

test("a quick machine draws finely with each frame", () => {
  const { ratio, begun } = drive(new Pace(), () => 3, 0, 2000);
  assert.equal(ratio, finenesses[0]!.ratio);
  assert.ok(begun.length > 100, `${begun.length}`);
});

test("a slow machine draws coarsely, and at most a third of the time", () => {
  const pace = new Pace(), slow = (ratio: number) => 130 * ratio * ratio;
  const { ratio, begun } = drive(pace, slow, 0, 6000);
  assert.ok(ratio < 1 && slow(ratio) < 80, `${ratio}`);
  const late = begun.slice(-10), each = (late.at(-1)! - late[0]!) / 9;
  assert.ok(each >= 3 * slow(ratio) - 16, `${each}`);
  // Never while the last one is not there.
  assert.ok(begun.every((at, i) => i === 0 || at - begun[i - 1]! >= 16));
});

test("what rests is drawn finely once, and a machine that has become quick draws finely again", () => {
  const pace = new Pace();
  drive(pace, (ratio) => 130 * ratio * ratio, 0, 6000);
  for (let now = 6000; pace.drawing; now += 16) pace.end(now);
  assert.ok(!pace.shouldRefine(6010));
  assert.ok(pace.shouldRefine(7000));
  assert.equal(pace.begin(7000, true).ratio, finenesses[0]!.ratio);
  pace.end(7200);
  assert.ok(!pace.shouldRefine(9000));
  assert.equal(drive(pace, () => 3, 9000, 60_000).ratio, finenesses[0]!.ratio);
});
