// The model: history, ports, edits, clipboard.
import assert from "node:assert/strict";
import { test } from "node:test";
import { copy, paste } from "../../src/model/clipboard";
import { addIcon, connect, newIcon, openPort, removeIcons, renameIcon, setParameter } from "../../src/model/edit";
import { noHistory, record, redo, undo, type History } from "../../src/model/history";
import { empty, freeName, iconOf, operationNamed, withOperation, type Drawing, type Icon, type Operation } from "../../src/model/operation";
import { lead, lines, outputs, reached } from "../../src/model/ports";
import { randomEdit, randomOf } from "./random";

const icon = (id: string, kind: Icon["kind"], more: Partial<Icon> = {}): Icon => newIcon(kind, id, [0, 0], more);
const place = { path: [], selected: [] };
const op = (...icons: Icon[]): Operation => ({ name: "main", icons });
const drawingOf = (operation: Operation, ...operations: Operation[]): Drawing => ({ ...withOperation(empty("main"), "main", operation), ...(operations.length ? { operations } : {}) }) as Drawing;

test("undo of a hundred random edits gives the first bytes, redo the last", () => {
  for (let seed = 1; seed <= 20; ++seed) {
    const random = randomOf(seed);
    let drawing = drawingOf(op(icon("start", "start"), icon("touch", "skill", { skill: "touch" })));
    const first = JSON.stringify(drawing);
    let history: History = noHistory;
    for (let i = 0; i < 100; ++i) {
      const after = withOperation(drawing, "main", randomEdit(random, operationNamed(drawing, "main")!));
      history = record(history, { label: "edit.add", before: drawing, after, placeBefore: place, placeAfter: place });
      drawing = after;
    }
    const last = JSON.stringify(drawing);
    assert.equal(history.past.length, 100, `seed ${seed}`);
    for (let step = undo(history); step; step = undo(history)) ({ history, entry: { before: drawing } } = step);
    assert.equal(JSON.stringify(drawing), first, `seed ${seed}`);
    for (let step = redo(history); step; step = redo(history)) ({ history, entry: { after: drawing } } = step);
    assert.equal(JSON.stringify(drawing), last, `seed ${seed}`);
  }
});

test("entries of one run are one, and an edit forgets what was undone", () => {
  const [a, b, c, d] = [1, 2, 3, 4].map((i) => drawingOf(op(icon(`i${i}`, "merge")))) as [Drawing, Drawing, Drawing, Drawing];
  const entry = (before: Drawing, after: Drawing, run?: string) => ({ label: "edit.field", before, after, placeBefore: place, placeAfter: place, ...(run ? { run } : {}) });
  let history = record(record(record(noHistory, entry(a, b, "r")), entry(b, c, "r")), entry(c, d));
  assert.equal(history.past.length, 2);
  ({ history } = undo(history)!);
  const back = undo(history)!;
  assert.equal(back.entry.before, a);
  history = record(back.history, entry(a, d));
  assert.equal(history.future.length, 0);
  assert.equal(record(history, entry(d, d)), history);
});

test("outputs by kind, from top to bottom", () => {
  assert.deepEqual(outputs(icon("c", "case")).map((each) => each.name), ["way:0", "way:1", "default"]);
  assert.deepEqual(outputs(icon("q", "question")).map((each) => each.name), ["answer:0", "error"]);
  assert.deepEqual(outputs(icon("s", "skill")).map((each) => each.name), ["next", "error"]);
  assert.deepEqual(outputs(icon("e", "exit")), []);
  assert.deepEqual(outputs(icon("r", "restart")), []);
});

test("a line is put and taken away without a trace", () => {
  const before = icon("c", "case");
  const led = lead(lead(before, "way:1", "a"), "default", "b");
  assert.deepEqual(outputs(led).map((each) => each.to), [undefined, "a", "b"]);
  assert.deepEqual(lead(lead(led, "way:1", undefined), "default", undefined), before);
});

test("what goes takes its lines along, and a new name reaches lines and counts", () => {
  let operation = op(icon("start", "start", { next: "a" }), icon("a", "skill", { skill: "rub", next: "b" }), icon("b", "delay", { seconds: { "count-of": "a" }, next: "a" }));
  operation = renameIcon(operation, "a", "first");
  assert.deepEqual(lines(operation).map((line) => `${line.from}>${line.to}`), ["start>first", "first>b", "b>first"]);
  assert.deepEqual(iconOf(operation, "b")!.seconds, { "count-of": "first" });
  assert.equal(renameIcon(operation, "first", "b").icons[1]!.id, "b-2");
  assert.deepEqual(lines(removeIcons(operation, new Set(["first"]))), []);
});

test("icons that START does not lead to are not reached", () => {
  const operation = connect(op(icon("start", "start"), icon("a", "merge"), icon("b", "merge", { next: "a" })), "start", "next", "a");
  assert.deepEqual([...reached(operation)].sort(), ["a", "start"]);
});

test("the first open output takes a new line", () => {
  assert.equal(openPort(icon("s", "skill")), "next");
  assert.equal(openPort(icon("s", "skill", { next: "x" })), "error");
  assert.equal(openPort(icon("s", "skill", { next: "x", error: "y" })), "next");
});

test("a parameter that is set to nothing leaves no empty object", () => {
  const set = setParameter(icon("s", "skill"), "force", 5);
  assert.deepEqual(set.parameters, { force: 5 });
  assert.equal("parameters" in setParameter(set, "force", undefined), false);
});

test("names become free", () => {
  assert.equal(freeName("a/b", []), "a-b");
  assert.equal(freeName("side-2", ["side", "side-2"]), "side-3");
});

test("paste keeps lines among the icons, brings sub-operations, and no second START", () => {
  const part: Operation = { name: "part", icons: [icon("start", "start", { next: "x" }), icon("x", "exit")] };
  const from = drawingOf(op(icon("start", "start", { next: "a" }), icon("a", "skill", { skill: "rub", next: "p", error: "out" }), icon("p", "operation", { operation: "part" }), icon("out", "exit")), part);
  const clip = copy(from, operationNamed(from, "main")!, new Set(["start", "a", "p"]));
  const other: Operation = { name: "part", icons: [icon("start", "start")] };
  const into = drawingOf(op(icon("start", "start"), icon("a", "merge")), other);
  const { drawing, ids } = paste(into, "main", clip, [10, 20]);
  assert.deepEqual(ids, ["a-2", "p"]);
  const main = operationNamed(drawing, "main")!;
  assert.equal(iconOf(main, "a-2")!.next, "p");
  assert.equal(iconOf(main, "a-2")!.error, undefined);
  assert.equal(iconOf(main, "p")!.operation, "part-2");
  assert.equal(operationNamed(drawing, "part-2")!.icons.length, 2);
  assert.deepEqual(iconOf(main, "p")!.at, [10, 20]);
});

test("the main operation keeps its sub-operations when it changes", () => {
  const part: Operation = { name: "part", icons: [] };
  const drawing = drawingOf(op(), part);
  const changed = withOperation(drawing, "main", addIcon(operationNamed(drawing, "main")!, icon("a", "merge")));
  assert.equal(changed.operations?.length, 1);
  assert.equal(changed["operation-format"], 1);
});
