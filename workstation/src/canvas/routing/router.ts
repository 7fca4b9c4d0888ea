// The ways of all lines of an operation. A way is kept until one of its ends moves or an icon comes near it.
import { around, inflate, touches, type Rect, type XY } from "./geometry";
import { margin, route } from "./route";
import { separated } from "./separate";

export interface Wanted {
  key: string;
  /** The icon and the input at which it ends. */
  group: string;
  from: XY;
  to: XY;
}

interface Kept {
  from: XY;
  to: XY;
  points: XY[];
  box: Rect;
}

const same = (a: Rect | undefined, b: Rect | undefined) =>
  a === b || (a && b && a.left === b.left && a.top === b.top && a.right === b.right && a.bottom === b.bottom);

export class Router {
  #kept = new Map<string, Kept>();
  #icons = new Map<string, Rect>();

  /** `loose`: icons that are being dragged; lines may run through them meanwhile. */
  routes(wanted: readonly Wanted[], icons: ReadonlyMap<string, Rect>, loose: ReadonlySet<string> = new Set()): Map<string, XY[]> {
    const solid = new Map([...icons].filter(([id]) => !loose.has(id)));
    const changed: Rect[] = [];
    for (const [id, rect] of solid) {
      const before = this.#icons.get(id);
      if (!same(before, rect)) changed.push(rect, ...(before ? [before] : []));
    }
    for (const [id, rect] of this.#icons) if (!solid.has(id)) changed.push(rect);
    this.#icons = solid;
    const rects = [...solid.values()];
    const kept = new Map<string, Kept>();
    for (const { key, from, to } of wanted) {
      const old = this.#kept.get(key);
      const stays = old && old.from.x === from.x && old.from.y === from.y && old.to.x === to.x && old.to.y === to.y &&
        !changed.some((rect) => touches(rect, old.box));
      if (stays) {
        kept.set(key, old);
        continue;
      }
      const points = route(from, to, rects);
      kept.set(key, { from, to, points, box: inflate(around(points), margin) });
    }
    this.#kept = kept;
    return separated(wanted.map((each) => ({ key: each.key, group: each.group, points: kept.get(each.key)!.points })));
  }
}
