// Rectangles and rectangular lines.
export interface XY {
  x: number;
  y: number;
}
export interface Rect {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

export const inflate = (r: Rect, by: number): Rect => ({ left: r.left - by, top: r.top - by, right: r.right + by, bottom: r.bottom + by });

/** The piece from a to b, horizontal or vertical, runs through the inside of r. */
export function crosses(a: XY, b: XY, r: Rect): boolean {
  return Math.max(a.x, b.x) > r.left && Math.min(a.x, b.x) < r.right && Math.max(a.y, b.y) > r.top && Math.min(a.y, b.y) < r.bottom;
}

export const touches = (a: Rect, b: Rect): boolean => a.left <= b.right && b.left <= a.right && a.top <= b.bottom && b.top <= a.bottom;

export function around(points: readonly XY[]): Rect {
  const xs = points.map((p) => p.x), ys = points.map((p) => p.y);
  return { left: Math.min(...xs), right: Math.max(...xs), top: Math.min(...ys), bottom: Math.max(...ys) };
}

/** Without points in the middle of a straight piece. */
export function simplified(points: readonly XY[]): XY[] {
  const out: XY[] = [];
  for (const p of points) {
    const a = out.at(-2), b = out.at(-1);
    if (b && b.x === p.x && b.y === p.y) continue;
    if (a && b && ((a.x === b.x && b.x === p.x) || (a.y === b.y && b.y === p.y))) out.pop();
    out.push(p);
  }
  return out;
}

/** An SVG path with round corners. */
export function pathOf(points: readonly XY[], radius = 8): string {
  const first = points[0];
  if (!first) return "";
  let d = `M${first.x} ${first.y}`;
  for (let i = 1; i < points.length; ++i) {
    const a = points[i - 1]!, b = points[i]!, c = points[i + 1];
    if (!c) return `${d}L${b.x} ${b.y}`;
    const before = Math.abs(a.x - b.x) + Math.abs(a.y - b.y), after = Math.abs(c.x - b.x) + Math.abs(c.y - b.y);
    const r = Math.min(radius, before / 2, after / 2);
    const p = { x: b.x - Math.sign(b.x - a.x) * r, y: b.y - Math.sign(b.y - a.y) * r };
    const q = { x: b.x + Math.sign(c.x - b.x) * r, y: b.y + Math.sign(c.y - b.y) * r };
    d += `L${p.x} ${p.y}Q${b.x} ${b.y} ${q.x} ${q.y}`;
  }
  return d;
}
