// The way of one line from an output, which it leaves to the right, to an input, which it meets from the left,
// around all icons. Simple ways are tried first; else A* over the lines that the icons' borders span.
import { crosses, inflate, simplified, type Rect, type XY } from "./geometry";
import { Heap } from "./heap";

/** Between a line and an icon. */
export const margin = 16;
const bend = 60;
const region = 240;

const free = (points: readonly XY[], blocked: readonly Rect[]): boolean => {
  for (let i = 1; i < points.length; ++i)
    for (const each of blocked) if (crosses(points[i - 1]!, points[i]!, each)) return false;
  return true;
};

/** `blocked` has the icons at both ends, too: the pieces at the connectors are left out. */
function simple(from: XY, to: XY, blocked: readonly Rect[]): XY[] | undefined {
  const gap = to.x - from.x;
  if (gap < 2 * margin) return undefined;
  const out = { x: from.x + margin - 2, y: from.y }, into = { x: to.x - margin + 2, y: to.y };
  if (Math.abs(from.y - to.y) < 1) return free([out, into], blocked) ? [from, to] : undefined;
  // The turn is near the source: lines that leave one icon part at once, and those that meet run together.
  const ways = [to.x - margin, from.x + margin, from.x + gap / 2].map((x) => [{ x, y: from.y }, { x, y: to.y }]).filter((turn) => free([out, ...turn, into], blocked));
  const turn = ways.find(([corner]) => !misleads(corner!, to, blocked)) ?? ways[0];
  return turn && [from, ...turn, to];
}

/** A corner just before another icon looks as if the line led there. */
function misleads(corner: XY, to: XY, blocked: readonly Rect[]): boolean {
  return blocked.some((each) => corner.y > each.top && corner.y < each.bottom && each.left > corner.x - margin && each.left - corner.x < 2 * margin && !(to.y > each.top && to.y < each.bottom));
}

/** Where the line at a connector passes the side of its icon: an arrow's head has connectors inside its rectangle. */
function atSide(point: XY, icons: readonly Rect[], side: "left" | "right"): XY {
  const own = icons.find((each) => point.x > each.left && point.x < each.right && point.y > each.top && point.y < each.bottom);
  return own ? { x: own[side], y: point.y } : point;
}

export function route(output: XY, input: XY, icons: readonly Rect[]): XY[] {
  const from = atSide(output, icons, "right"), to = atSide(input, icons, "left");
  return simplified([output, ...between(from, to, icons), input]);
}

function between(from: XY, to: XY, icons: readonly Rect[]): XY[] {
  const tight = icons.map((each) => inflate(each, 6));
  const quick = simple(from, to, tight);
  if (quick) return simplified(quick);
  const start = { x: from.x + margin, y: from.y }, end = { x: to.x - margin, y: to.y };
  const box = inflate({ left: Math.min(start.x, end.x), right: Math.max(start.x, end.x), top: Math.min(start.y, end.y), bottom: Math.max(start.y, end.y) }, region);
  const near = icons.filter((each) => each.left < box.right && each.right > box.left && each.top < box.bottom && each.bottom > box.top);
  const found = search(start, end, near);
  return simplified(found ? [from, ...found, to] : detour(from, start, end, to, near));
}

/** Below everything: where no way was found, as from an icon that lies in another. */
function detour(from: XY, start: XY, end: XY, to: XY, icons: readonly Rect[]): XY[] {
  const y = Math.max(start.y, end.y, ...icons.map((each) => each.bottom)) + margin;
  return [from, start, { x: start.x, y }, { x: end.x, y }, end, to];
}

const sorted = (values: Iterable<number>): number[] => [...new Set(values)].sort((a, b) => a - b);

function search(start: XY, end: XY, icons: readonly Rect[]): XY[] | undefined {
  const wide = icons.map((each) => inflate(each, margin));
  const blocked = icons.map((each) => inflate(each, margin - 1));
  const xs = sorted([start.x, end.x, ...wide.flatMap((each) => [each.left, each.right])]);
  const ys = sorted([start.y, end.y, ...wide.flatMap((each) => [each.top, each.bottom])]);
  const columns = xs.length, rows = ys.length;
  const at = (node: number): XY => ({ x: xs[(node >> 1) % columns]!, y: ys[Math.floor((node >> 1) / columns)]! });
  // A node is a crossing and the direction in which it was reached: 0 horizontal, 1 vertical.
  const id = (column: number, row: number, vertical: number) => ((row * columns + column) << 1) | vertical;
  const first = id(xs.indexOf(start.x), ys.indexOf(start.y), 0);
  const goal = id(xs.indexOf(end.x), ys.indexOf(end.y), 0);
  const cost = new Map<number, number>([[first, 0]]);
  const came = new Map<number, number>();
  const heap = new Heap();
  const guess = (p: XY) => Math.abs(p.x - end.x) + Math.abs(p.y - end.y);
  heap.push(guess(start), first);
  for (let node = heap.pop(); node !== undefined; node = heap.pop()) {
    if (node === goal) return back(came, node).map(at);
    const vertical = node & 1, column = (node >> 1) % columns, row = Math.floor((node >> 1) / columns);
    const here = at(node), so_far = cost.get(node)!;
    for (const [dc, dr] of [[1, 0], [-1, 0], [0, 1], [0, -1]] as const) {
      const c = column + dc, r = row + dr;
      if (c < 0 || r < 0 || c >= columns || r >= rows) continue;
      const turned = dr === 0 ? 0 : 1;
      const next = id(c, r, turned), there = at(next);
      const length = Math.abs(there.x - here.x) + Math.abs(there.y - here.y);
      // The first and the last piece go on to the right.
      const wrong = (node === first && dc === -1) || ((next >> 1) === (goal >> 1) && dc === -1);
      const total = so_far + length + (turned === vertical ? 0 : bend) + (wrong ? 4 * bend : 0);
      if (total >= (cost.get(next) ?? Infinity) || blocked.some((each) => crosses(here, there, each))) continue;
      cost.set(next, total);
      came.set(next, node);
      heap.push(total + guess(there), next);
      if ((next >> 1) === (goal >> 1) && turned === 1) {
        const arrive = total + bend;
        if (arrive < (cost.get(goal) ?? Infinity)) {
          cost.set(goal, arrive);
          came.set(goal, next);
          heap.push(arrive, goal);
        }
      }
    }
  }
  return undefined;
}

function back(came: ReadonlyMap<number, number>, node: number): number[] {
  const path = [node];
  for (let each = came.get(node); each !== undefined; each = came.get(each)) path.push(each);
  return path.reverse();
}
