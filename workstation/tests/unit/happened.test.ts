// The state of the cell, kept by events.
import assert from "node:assert/strict";
import { test } from "node:test";
import type { Event } from "../../generated/protocol";
import { begin, happened, type Present } from "../../src/state/happened";
import { snapshot } from "../fake/server";

let number = 0;
const tell = (present: Present, event: Record<string, unknown>): Present =>
  happened(present, { number: ++number, time_s: number, wall: "2026-01-01T00:00:00.000Z", ...event } as unknown as Event, 1000);
const start = () => begin(snapshot({ operation: "rub" }), 1000);
const state = (value: string, token = "", reason = "") => ({ event: "state", state: value, token, last_code: 0, steps: 0, reason });

test("a run leaves marks at its icons and lines, and the next run begins without them", () => {
  let present = tell(start(), state("running"));
  present = tell(tell(present, { event: "icon", icon: "start" }), { event: "icon", icon: "a" });
  present = tell(present, { event: "begins", step: 1, icon: "a", skill: "rub", begin_s: 2 });
  assert.equal(present.snapshot.running?.icon, "a");
  present = tell(present, { event: "ends", step: 1, icon: "a", skill: "rub", begin_s: 2, end_s: 5, kind: "contingency", code: 1, reason: "The stop force was met." });
  assert.equal(present.runs.get("a")?.code, 1);
  assert.equal(present.runs.get("a")?.took_s, 3);
  assert.equal(present.snapshot.last_code, 1);
  assert.deepEqual([...present.taken], ["start>a"]);
  present = tell(present, state("failed", "a", "no way"));
  assert.equal(present.snapshot.activity, "idle");
  present = tell(present, state("running"));
  assert.equal(present.runs.size, 0);
});

test("a pause keeps the marks", () => {
  let present = tell(tell(start(), state("running")), { event: "icon", icon: "a" });
  present = tell(tell(present, state("paused", "a")), state("running", "a"));
  assert.equal(present.runs.get("a")?.visits, 1);
});

test("lines into a part are told by its own icons, lines out of it by the part", () => {
  let present = tell(start(), state("running"));
  for (const icon of ["start", "part", "part/start", "part/x", "done"]) present = tell(present, { event: "icon", icon });
  assert.deepEqual([...present.taken], ["start>part", "part/start>part/x", "part>done"]);
});

test("controls, questions, breakpoints, loading", () => {
  let present = tell(start(), { event: "controls", holder: "Anna", client: 1, reason: "" });
  assert.equal(present.snapshot.yours, true);
  present = tell(present, { event: "asked", client: 2, name: "Ben", reason: "" });
  assert.equal(present.snapshot.asking.length, 1);
  present = tell(present, { event: "question", question: { icon: "q", text: "?", answers: ["a"], since_s: 1, since: "" } });
  assert.equal(present.snapshot.question?.icon, "q");
  present = tell(present, { event: "answered", icon: "q", answer: "a", by: "Anna" });
  assert.equal(present.snapshot.question, null);
  present = tell(present, { event: "loaded", operation: "other", by: "Ben" });
  assert.equal(present.snapshot.operation, "other");
  assert.equal(present.snapshot.last_event, number);
});
