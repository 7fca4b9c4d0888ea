// Collapse and expand: what the drawing does stays the same. Both drawings are walked with the same codes.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import { caseBehind, collapse, expand } from "../../src/model/hierarchy";
import { iconOf, operationNamed, type Drawing, type Icon, type Operation } from "../../src/model/operation";
import { randomOf } from "./random";

const example = (name: string) => JSON.parse(readFileSync(join(process.env.WORKSTATION!, "../examples/operations", `${name}.op.json`), "utf8")) as Drawing;

/** Where the token goes from an icon that ended with the code (docs/reference/operations.md). */
function goesTo(operation: Operation, icon: Icon, code: number): string | undefined {
  const branch = caseBehind(operation, icon.next);
  const way = branch?.ways?.find((each) => each.codes.includes(code));
  const normal = icon.kind === "test" ? code !== -1 : code === 0;
  if (way?.to) return way.to;
  if (!normal && icon.error) return icon.error;
  if (branch) return branch.default;
  return normal ? icon.next : icon.error;
}

/** The skills that run and how it ends, with codes out of `codes`; an end with a code. */
function walked(drawing: Drawing, codes: (icon: Icon) => number): string[] {
  const log: string[] = [];
  const run = (name: string): number | undefined => {
    const operation = operationNamed(drawing, name)!;
    let at = operation.icons.find((each) => each.kind === "start"), code = 0;
    at = iconOf(operation, at?.next ?? "");
    while (at && log.length < 60) {
      let to: string | undefined;
      if (at.kind === "exit") return typeof at.code === "number" ? at.code : code;
      if (at.kind === "merge" || at.kind === "delay") to = at.next;
      else if (at.kind === "case") to = at.ways?.find((each) => each.codes.includes(code))?.to ?? at.default;
      else {
        if (at.kind === "operation") {
          const ended = run(at.operation!);
          if (ended === undefined) return undefined;
          code = ended;
        } else {
          code = codes(at);
          log.push(`${at.skill ?? at.sensor}=${code}`);
        }
        to = goesTo(operation, at, code);
      }
      at = iconOf(operation, to ?? "");
    }
    return undefined;
  };
  return [...log, `end ${run(drawing.name)}`, ...log];
}

function sameRuns(a: Drawing, b: Drawing): void {
  for (let seed = 1; seed <= 60; ++seed) {
    const [first, second] = [a, b].map((drawing) => {
      const random = randomOf(seed);
      return walked(drawing, (icon) => (icon.kind === "test" ? random(3) : random(4) === 0 ? random(3) : 0));
    });
    assert.deepEqual(first, second, `seed ${seed}`);
  }
}

const collapsed = (drawing: Drawing, ids: string[]) => {
  const outcome = collapse(drawing, drawing.name, new Set(ids), "part");
  assert.ok("drawing" in outcome, JSON.stringify(outcome));
  return outcome;
};
const refused = (drawing: Drawing, ids: string[]) => {
  const outcome = collapse(drawing, drawing.name, new Set(ids), "part");
  return "refused" in outcome ? outcome.refused : "done";
};

test("the selective pick of figure 4.14 becomes one icon, and is the same when it is expanded", () => {
  const before = example("pick_by_identity");
  const { drawing, id } = collapsed(before, ["which-part", "kind-seen", "pick-high", "pick-middle", "pick-low", "picked"]);
  sameRuns(before, drawing);
  const back = expand(drawing, drawing.name, id);
  assert.ok("drawing" in back, JSON.stringify(back));
  sameRuns(before, back.drawing);
  assert.equal(back.drawing.operations, undefined);
});

test("a skill before a CASE outside keeps its code", () => {
  const before = example("rub_in_square");
  const { drawing, id } = collapsed(before, ["find"]);
  sameRuns(before, drawing);
  const back = expand(drawing, drawing.name, id);
  assert.ok("drawing" in back, JSON.stringify(back));
  sameRuns(before, back.drawing);
});

test("the hierarchical icon of an example is expanded", () => {
  const before = example("rub_in_square");
  const back = expand(before, before.name, "rub-in-square");
  assert.ok("drawing" in back, JSON.stringify(back));
  sameRuns(before, back.drawing);
});

test("what cannot be kept is refused with its reason", () => {
  const identity = example("pick_by_identity");
  assert.equal(refused(identity, ["start", "go-home"]), "collapse.ends");
  assert.equal(refused(identity, ["kind-seen", "pick-high"]), "collapse.case");
  assert.equal(refused(identity, ["pick-high", "pick-low"]), "collapse.entries");
  assert.equal(refused(identity, []), "collapse.nothing");
});
