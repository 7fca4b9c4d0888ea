// Live data without a page: frames, tracks, what is exported, rows of tuning.
import assert from "node:assert/strict";
import { test } from "node:test";
import { csvOf, svgOf, ticks } from "../../src/live/export";
import { decode } from "../../src/live/frames";
import { Track } from "../../src/live/track";
import { shiftOf, spreadOf } from "../../src/production/shift";
import { difference, placesOf, wrongCorners, type Pose } from "../../src/teaching/places";
import { chosen, columnsOf, differing, sorted, sweep, type Row } from "../../src/tuning/rows";

function frame(head: Record<string, unknown>, numbers: readonly number[]): ArrayBuffer {
  let text = JSON.stringify(head);
  while ((4 + text.length) % 8 !== 0) text += " ";
  const bytes = new ArrayBuffer(4 + text.length + 8 * numbers.length);
  new DataView(bytes).setUint32(0, text.length, true);
  new Uint8Array(bytes, 4).set(new TextEncoder().encode(text));
  new Float64Array(bytes, 4 + text.length).set(numbers);
  return bytes;
}

test("frames of spans and of profiles", () => {
  const spans = decode(frame({ channel: "force", spans: 1, fields: 2, dropped: 3 }, [0, 0.02, 20, 1, 2, 3, 4, 5, 6]));
  assert.ok(spans.form === "spans" && spans.count === 1 && spans.dropped === 3);
  assert.deepEqual([...spans.numbers], [0, 0.02, 20, 1, 2, 3, 4, 5, 6]);
  const profile = decode(frame({ channel: "profile", time_s: 1.5, points: 2, scanned: 3, missing: [[1, 2]], marks: [], dropped: 0 }, [-1, 1, 200, 201]));
  assert.ok(profile.form === "profile" && profile.scanned === 3);
  assert.deepEqual([[...profile.y], [...profile.z]], [[-1, 1], [200, 201]]);
});

test("a track keeps the newest in the memory that it has, and begins anew when time does", () => {
  const track = new Track(1, 8);
  for (let i = 0; i < 21; ++i) track.put(i, [i * i]);
  assert.ok(track.size <= 8 && track.size >= 4);
  assert.equal(track.end, 20);
  for (let i = 1; i < track.size; ++i) assert.equal(track.times[i]! - track.times[i - 1]!, 1);
  assert.equal(track.last[0]![track.at(19)!], 361);
  assert.deepEqual(track.within(18, 19).map((each) => track.times[each]), [18, 20]);
  assert.equal(track.at(500), undefined);
  track.put(1, [7]);
  assert.equal(track.size, 1);
});

test("CSV and SVG have what is shown", () => {
  const track = new Track(2);
  track.take(Float64Array.of(0, 1, 5, -1, 10, 3, 12, 2, 11), 1);
  track.take(Float64Array.of(1, 2, 5, -2, 20, 4, 22, 3, 21), 1);
  const fields = [{ field: 0, name: "fx", unit: "N" }, { field: 1, name: 'a "b"', unit: "" }];
  assert.equal(csvOf(track, fields, 0, 1.5), 'time (s),fx least (N),fx greatest (N),fx last (N),"a ""b"" least","a ""b"" greatest","a ""b"" last"\n1,-1,3,2,10,12,11\n');
  const limit = { field: "fx", value: 2, kind: "stop" as const, parameter: "stop<force", begin: 0, end: undefined };
  const svg = svgOf(track, [{ unit: "N", fields: fields.slice(0, 1), range: [-3, 5], limits: [limit] }], 0, 2, "force & more", { ink: "#000", ground: "#fff", grid: "#ccc", color: () => "red", dash: () => [], limit: () => "blue" });
  assert.match(svg, /force &amp; more/);
  assert.match(svg, /stop&lt;force/);
  assert.ok(!/NaN|undefined/.test(svg));
});

test("ticks are round and within", () => {
  assert.deepEqual(ticks(0, 10), [0, 2, 4, 6, 8, 10]);
  assert.deepEqual(ticks(-0.013, 0.031), [-0.01, 0, 0.01, 0.02, 0.03]);
});

const row = (id: string, more: Partial<Row>): Row => ({ id, aside: false, icon: "rub", begun: "", run: 1, step: 1, parameters: {}, figures: {}, measured: {}, kind: "normal", code: 0, reason: "", duration: 1, ...more });

test("rows of tuning are chosen, sorted and compared", () => {
  const rows = [row("1.1", { parameters: { speed: 1, way: 5 }, figures: { force: 3 } }), row("1.2", { parameters: { speed: 2, way: 5 }, figures: { force: 1 }, code: 1 }), row("aside.1", { aside: true, parameters: { speed: 3, way: 5 }, figures: { force: 2 } })];
  const columns = columnsOf(undefined, rows);
  assert.deepEqual(columns.map((each) => each.id), ["figure:force"]);
  assert.deepEqual(sorted(rows, columns[0], true).map((each) => each.id), ["1.1", "aside.1", "1.2"]);
  assert.deepEqual(chosen(rows, { icon: "", code: 0, where: "cell" }).map((each) => each.id), ["1.1"]);
  assert.deepEqual(differing(columns, [rows[0]!, { ...rows[1]!, figures: { force: 3 } }]), []);
  assert.deepEqual(sweep(0, 1, 5), [0, 0.25, 0.5, 0.75, 1]);
  assert.deepEqual(sweep(3, 9, 1), [3]);
});

test("a shift: counts, cycles, and how long it stood", () => {
  const at = (minute: number) => new Date(Date.UTC(2026, 0, 1, 8, minute)).toISOString();
  const run = (number: number, more: object) => ({ run: number, kind: "operation" as const, name: "rub", begun: at(number), ended: at(number + 1), begin_s: 0, end_s: 10 + number, by: "", state: "ended", code: 0, reason: "", steps: 1, ...more });
  const all = [run(5, { code: 2, reason: "why" }), run(1, {}), run(2, { state: "stopped", code: null }), run(9, {}), run(3, { kind: "skill", name: "touch" }), run(0, { name: "other" })];
  const shift = shiftOf(all, "rub", Date.parse(at(1)), Date.parse(at(20)));
  assert.deepEqual([shift.runs, shift.good, shift.other, shift.broken, shift.worked], [4, 2, 1, 1, 4 * 60_000]);
  assert.deepEqual(shift.stops.map((each) => [each.run, (each.until! - each.from) / 60_000]), [[2, 0], [5, 3]]);
  assert.deepEqual(spreadOf(shift.cycles), { shortest: 11, median: 15, longest: 19 });
  assert.equal(spreadOf([]), undefined);
});

test("the places of a pallet, and corners that are none", () => {
  const corner = (x: number, y: number): Pose => [x, y, 5, 0, 90, 0];
  const pallet = { first: corner(0, 0), rowEnd: corner(100, 0), columnEnd: corner(0, 50), along: 3, across: 2 };
  assert.deepEqual(placesOf(pallet).map((each) => each.slice(0, 2)), [[0, 0], [50, 0], [100, 0], [0, 50], [50, 50], [100, 50]]);
  assert.equal(wrongCorners(pallet), undefined);
  assert.equal(wrongCorners({ ...pallet, columnEnd: corner(80, 1) }), "line");
  assert.equal(wrongCorners({ ...pallet, rowEnd: corner(1, 0) }), "same");
  assert.deepEqual(difference([0, 0, 0, 170, 0, 0], [1, 0, 0, -170, 0, 0]).map(Math.round), [1, 0, 0, 20, 0, 0]);
});
