// How often and how finely the picture of the cell is drawn. A machine without a graphics card takes 0.1 s for a fine
// picture: it gets a coarser one, seldom enough that the other windows go on. What rests is drawn finely.

/** How finely: the pixels of the picture for one of the screen, and of the map of shadows. */
export interface Fineness {
  ratio: number;
  shadow: number;
}

/** The finest first. `ratio` is at most that of the screen. */
export const finenesses: readonly Fineness[] = [{ ratio: 2, shadow: 2048 }, { ratio: 1, shadow: 1024 }, { ratio: 0.75, shadow: 512 }, { ratio: 0.5, shadow: 512 }];

/** A picture that takes longer is too fine; one that is there with the next frame of the screen could be finer, ms. */
const tooLong = 34, short = 20;
/** A fineness that was too much is not tried again for so long, ms. The time doubles with each failure. */
const patience = 5_000, longestPatience = 320_000;
/** What has not changed for so long is drawn finely, ms. */
const rest = 400;
/** The first pictures of a fineness also load shapes and maps: they tell nothing. */
const warming = 2;

/** Decides by the times of the pictures before. It knows no graphics: a caller tells it the instants, in ms. */
export class Pace {
  #level = 0;
  #began: number | undefined;
  #ended = -Infinity;
  #took = 0;
  #pictures = 0;
  #patience = patience / 2;
  /** When a finer picture may be tried. */
  #again = -Infinity;
  #fine = false;

  /** A picture may begin: the last one is there, and if it was slow, the others had twice its time since then. */
  may(now: number): boolean {
    return this.#began === undefined && now >= this.#ended + (this.#took > short ? 2 * this.#took : 0);
  }

  /** A picture begins now. `still`: nothing has changed for a while. */
  begin(now: number, still: boolean): Fineness {
    this.#began = now;
    this.#fine = still;
    return finenesses[still ? 0 : this.#level]!;
  }

  /** The picture is on the screen. */
  end(now: number): void {
    if (this.#began === undefined) return;
    const took = now - this.#began;
    this.#began = undefined;
    this.#ended = now;
    if (++this.#pictures <= warming || this.#fine) return;
    this.#took = this.#took === 0 ? took : this.#took * 0.7 + took * 0.3;
    if (this.#took > tooLong && this.#level + 1 < finenesses.length) {
      this.#patience = Math.min(2 * this.#patience, longestPatience);
      this.#again = now + this.#patience;
      this.#turn(this.#level + 1);
    } else if (this.#took < short && this.#level > 0 && now >= this.#again) {
      this.#turn(this.#level - 1);
    }
  }

  #turn(level: number): void {
    this.#level = level;
    this.#took = this.#pictures = 0;
  }

  /** A picture that is coarse, and has not changed since then, is to be drawn once more. */
  shouldRefine(now: number): boolean {
    return this.#level > 0 && !this.#fine && this.#began === undefined && now >= this.#ended + rest;
  }
  get drawing(): boolean {
    return this.#began !== undefined;
  }
  /** A picture, lately, ms. */
  get took(): number {
    return this.#took;
  }
}
