// The points of a path, until the painter has them. Both count alike, so that a count means the same to both.
import { Vector3 } from "three";

/** The pieces of a path that is full. The older half goes then. */
export const longestTrail = 40_000;

/** What is new in a path, in this order. */
export interface TrailNews {
  /** All that was there is gone. */
  cleared: boolean;
  /** x, y and z of each further point. */
  points: number[];
  /** Only the first so many pieces are seen; undefined: all. */
  upTo?: number;
}

export class Trail {
  #count = 0;
  #last: Vector3 | undefined;
  #news: TrailNews | undefined;

  get #fresh(): TrailNews {
    return (this.#news ??= { cleared: false, points: [] });
  }
  clear(): void {
    this.#count = 0;
    this.#last = undefined;
    this.#news = { cleared: true, points: [] };
  }
  /** Points nearer than half a millimetre to the last one are left out. */
  add(point: Vector3): void {
    if (this.#last && this.#last.distanceToSquared(point) < 0.25e-6) return;
    if (this.#last) this.#count = nextCount(this.#count);
    this.#last = point.clone();
    const news = this.#fresh;
    news.points.push(...point.toArray());
    // A painter that has failed takes none: of these only the pieces that it would show are kept.
    if (news.points.length > 6 * longestTrail) this.#news = { ...news, cleared: true, points: news.points.slice(-3 * (this.#count + 1)) };
  }
  /** Its pieces. */
  get count(): number {
    return this.#count;
  }
  /** Only the first so many pieces are seen. */
  upTo(count: number): void {
    this.#fresh.upTo = count;
  }
  /** What the painter has not got yet. It counts as given. */
  take(): TrailNews | undefined {
    const news = this.#news;
    this.#news = undefined;
    return news;
  }
}

/** Of the pieces, when one more comes. */
export const nextCount = (count: number): number => (count === longestTrail ? longestTrail / 2 : count) + 1;
