// Why a run came to nothing: the cause without its place in the program, and the icon at which it failed. Where new icons go.
import assert from "node:assert/strict";
import { test } from "node:test";
import { besides } from "../../src/canvas/keys";
import { newIcon } from "../../src/model/edit";
import { causeOf, culprit } from "../../src/state/cause";
import { begin, type IconRun } from "../../src/state/happened";
import { snapshot } from "../fake/server";

test("what happened comes first, and where in the program apart", () => {
  assert.deepEqual(causeOf("SM1.2 at slide (rub.pal:82): the surface has ended: nothing was felt for 140 ms"),
    { what: "the surface has ended: nothing was felt for 140 ms", where: "SM1.2 at slide (rub.pal:82)" });
  assert.deepEqual(causeOf("'rub' ended with code 2, which no icon handles: SM1 at TXM( motion to MC1 ) (rub.pal:9): it slipped"),
    { what: "it slipped", where: "SM1 at TXM( motion to MC1 ) (rub.pal:9)" });
  assert.deepEqual(causeOf("force-torque: no record came within 20 ms; is it switched on?"), { what: "force-torque: no record came within 20 ms; is it switched on?", where: "" });
  assert.deepEqual(causeOf(""), { what: "", where: "" });
});

test("the culprit is where it failed, or what led to an exit with another code than 0", () => {
  const run = (icon: string, kind: IconRun["kind"], ended_s: number): [string, IconRun] => [icon, { icon, visits: 1, ends: 0, last_s: 0, reason: "", ended_s, ...(kind ? { kind } : {}) }];
  const present = (state: "failed" | "ended", last_code: number) => ({ ...begin(snapshot({ operation: "rub", state, token: "done", last_code }), 0), runs: new Map([run("a", "contingency", 3), run("b", "error", 5), run("c", "normal", 6)]) });
  assert.equal(culprit(present("failed", 2)), "done");
  assert.equal(culprit(present("ended", 2)), "b");
  assert.equal(culprit(present("ended", 0)), undefined);
  assert.equal(culprit(undefined), undefined);
});

test("a dropped icon touches no other", () => {
  const operation = { name: "main", icons: [newIcon("start", "start", [0, 0]), newIcon("skill", "a", [168, 0])] };
  assert.deepEqual(besides(operation, [600, 0]), [600, 0]);
  // Upon one: beside it, on the nearer side that is free.
  assert.deepEqual(besides(operation, [300, 8]), [384, 8]);
  assert.deepEqual(besides(operation, [-40, 0]), [-216, 0]);
  // Between the two there is no room, and none at the same height nearer than beyond them.
  assert.deepEqual(besides(operation, [60, 0]), [-216, 0]);
});
