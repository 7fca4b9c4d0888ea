// The path of the tool: the page counts its pieces as the painter does, also when the path is full.
import assert from "node:assert/strict";
import { test } from "node:test";
import { Vector3 } from "three";
import { Path } from "../../src/scene/marks";
import { longestTrail, Trail } from "../../src/scene/trail";

const seen = (path: Path): number => path.object.geometry.instanceCount;
const end = (path: Path): number[] => {
  const at = (seen(path) - 1) * 6, { array } = (path.object.geometry.getAttribute("instanceEnd") as unknown as { data: { array: Float32Array } }).data;
  return [...array.slice(at, at + 6)];
};

test("points that are too near are left out, and the painter sees what the page has counted", () => {
  const trail = new Trail(), path = new Path(1);
  for (const x of [0, 0.0001, 0.001, 0.0011, 0.5]) trail.add(new Vector3(x, 0, 0));
  path.take(trail.take()!);
  assert.equal(trail.count, 2);
  assert.equal(seen(path), 2);
  assert.equal(trail.take(), undefined);
  trail.upTo(1);
  path.take(trail.take()!);
  assert.equal(seen(path), 1);
  trail.clear();
  trail.add(new Vector3(2, 0, 0));
  trail.add(new Vector3(3, 0, 0));
  path.take(trail.take()!);
  assert.equal(seen(path), 1);
  assert.deepEqual(end(path), [2, 0, 0, 3, 0, 0]);
});

test("a path that is full loses its older half", () => {
  const trail = new Trail(), path = new Path(1);
  for (let i = 0; i <= longestTrail + 2; ++i) {
    trail.add(new Vector3(i, 0, 0));
    if (i % 1000 === 0) path.take(trail.take()!);
  }
  path.take(trail.take()!);
  assert.equal(trail.count, longestTrail / 2 + 2);
  assert.equal(seen(path), trail.count);
  assert.deepEqual(end(path), [longestTrail + 1, 0, 0, longestTrail + 2, 0, 0]);
});

test("points that nobody takes are as many as the painter shows, at most twice", () => {
  const trail = new Trail(), path = new Path(1);
  for (let i = 0; i <= 3 * longestTrail; ++i) trail.add(new Vector3(i, 0, 0));
  const news = trail.take()!;
  assert.ok(news.points.length <= 6 * longestTrail);
  path.take(news);
  assert.equal(seen(path), trail.count);
  assert.deepEqual(end(path), [3 * longestTrail - 1, 0, 0, 3 * longestTrail, 0, 0]);
});
