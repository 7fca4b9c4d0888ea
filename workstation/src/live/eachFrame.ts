// The windows of live data take turns: a frame of the screen has a budget, and who did not draw in it draws first in the next.

/** Script for live windows in one frame, ms. The rest of its 16 ms is for drawing and for messages. */
const budget_ms = 5;

/** Calls a list in turns. `clock` tells the time, ms. */
export class Turns {
  #looks: (() => void)[] = [];
  #next = 0;
  constructor(readonly clock: () => number) {}

  add(look: () => void): () => void {
    this.#looks.push(look);
    return () => {
      const at = this.#looks.indexOf(look);
      if (at < 0) return;
      this.#looks.splice(at, 1);
      if (at < this.#next) --this.#next;
    };
  }
  get empty(): boolean {
    return this.#looks.length === 0;
  }

  /** Each is called at most once, and at least one is called. */
  frame(): void {
    const end = this.clock() + budget_ms;
    for (let left = this.#looks.length; left > 0 && !this.empty; --left) {
      this.#next %= this.#looks.length;
      this.#looks[this.#next++]!();
      if (this.clock() >= end) return;
    }
  }
}

const turns = new Turns(() => performance.now());
let handle: number | undefined;

function again(): void {
  handle = requestAnimationFrame(again);
  turns.frame();
}

/** Calls back with each frame of the screen that has time for it, while the page can be seen. Gives the end of it. */
export function eachFrame(look: () => void): () => void {
  const end = turns.add(look);
  handle ??= requestAnimationFrame(again);
  return () => {
    end();
    if (!turns.empty || handle === undefined) return;
    cancelAnimationFrame(handle);
    handle = undefined;
  };
}
