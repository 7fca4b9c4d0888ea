// Lines: they leave to the right, arrive from the left, go around icons, and do not lie on each other.
import assert from "node:assert/strict";
import { test } from "node:test";
import { crosses, type Rect, type XY } from "../../src/canvas/routing/geometry";
import { route } from "../../src/canvas/routing/route";
import { Router } from "../../src/canvas/routing/router";
import { separated } from "../../src/canvas/routing/separate";
import { randomOf } from "./random";

const rect = (left: number, top: number, width = 184, height = 56): Rect => ({ left, top, right: left + width, bottom: top + height });

function check(points: readonly XY[], icons: readonly Rect[], what: string): void {
  for (let i = 1; i < points.length; ++i) {
    const a = points[i - 1]!, b = points[i]!;
    assert.ok(a.x === b.x || a.y === b.y, `${what}: slanted`);
    for (const each of icons) assert.ok(!crosses(a, b, each), `${what}: through an icon, ${JSON.stringify(points)}`);
  }
  assert.ok(points[1]!.x > points[0]!.x, `${what}: leaves to the left`);
  assert.ok(points.at(-2)!.x < points.at(-1)!.x, `${what}: arrives from the right`);
}

test("icons in a row are joined by a straight line", () => {
  const a = rect(0, 0), b = rect(256, 0);
  assert.equal(route({ x: 184, y: 20 }, { x: 256, y: 20 }, [a, b]).length, 2);
});

test("back to an icon at the left, around both", () => {
  const a = rect(0, 0), b = rect(256, 0);
  check(route({ x: 440, y: 20 }, { x: 0, y: 20 }, [a, b]), [a, b], "back");
});

test("a connector inside its icon's rectangle, as at an arrow's head, needs no detour", () => {
  const lift = rect(0, 0), failed = rect(256, 160);
  assert.deepEqual(route({ x: 172, y: 44 }, { x: 256, y: 180 }, [lift, failed]), [{ x: 172, y: 44 }, { x: 240, y: 44 }, { x: 240, y: 180 }, { x: 256, y: 180 }]);
});

test("a line does not turn just before the input of another icon", () => {
  const last = rect(0, 0), done = rect(256, 24, 136, 40), failed = rect(256, 160, 136, 40);
  const points = route({ x: 184, y: 44 }, { x: 256, y: 180 }, [last, done, failed]);
  check(points, [last, done, failed], "past done");
  assert.equal(points[1]!.x, 200);
});

test("five hundred random pairs among random icons", () => {
  for (let seed = 1; seed <= 25; ++seed) {
    const random = randomOf(seed);
    // On a raster, with gaps that a line fits through.
    const icons: Rect[] = [];
    for (let column = 0; column < 6; ++column) for (let row = 0; row < 6; ++row) if (random(3) > 0) icons.push(rect(column * 264 + random(3) * 8, row * 120 + random(3) * 8));
    for (let i = 0; i < 20; ++i) {
      const from = icons[random(icons.length)]!, to = icons[random(icons.length)]!;
      check(route({ x: from.right, y: from.top + 20 }, { x: to.left, y: to.top + 20 }, icons), icons, `seed ${seed}, pair ${i}`);
    }
  }
});

test("pieces of lines to different icons are moved apart, those to one icon may meet", () => {
  const line = (key: string, group: string) => ({ key, group, points: [{ x: 0, y: 0 }, { x: 50, y: 0 }, { x: 50, y: 100 }, { x: 90, y: 100 }] });
  const moved = separated([line("a", "x"), line("b", "y"), line("c", "x")]);
  assert.notEqual(moved.get("a")![1]!.x, moved.get("b")![1]!.x);
  assert.equal(moved.get("a")![1]!.x, moved.get("c")![1]!.x);
  assert.deepEqual(moved.get("b")![0], { x: 0, y: 0 });
});

test("a way is kept until something comes near it", () => {
  const router = new Router();
  const icons = new Map([["a", rect(0, 0)], ["b", rect(400, 0)], ["c", rect(200, 400)]]);
  const wanted = [{ key: "a/next", group: "b", from: { x: 184, y: 20 }, to: { x: 400, y: 20 } }];
  assert.equal(router.routes(wanted, icons).get("a/next")!.length, 2);
  icons.set("c", rect(220, 0, 100));
  assert.ok(router.routes(wanted, icons).get("a/next")!.length > 2);
  icons.set("c", rect(200, 400));
  assert.equal(router.routes(wanted, icons).get("a/next")!.length, 2);
});

test("600 lines among 500 icons within seconds of the processor", () => {
  const icons = new Map<string, Rect>();
  for (let i = 0; i < 500; ++i) icons.set(`i${i}`, rect((i % 25) * 264, Math.floor(i / 25) * 120));
  const ids = [...icons.keys()], random = randomOf(7);
  const wanted = Array.from({ length: 600 }, (_, i) => {
    const from = i % 500, near = Math.max(0, Math.min(499, from + random(60) - 20));
    const a = icons.get(ids[from]!)!, b = icons.get(ids[near]!)!;
    return { key: `l${i}`, group: ids[near]!, from: { x: a.right, y: a.top + 20 }, to: { x: b.left, y: b.top + 20 } };
  });
  // Time of the processor: others may work on this machine.
  const began = process.cpuUsage();
  new Router().routes(wanted, icons);
  const took = process.cpuUsage(began).user / 1000;
  console.log(`600 lines: ${Math.round(took)} ms`);
  assert.ok(took < 3000);
});
