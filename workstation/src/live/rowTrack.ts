// What was seen of a channel of rows: at each instant some rows of numbers. Instants are in the order of time; the older
// half goes when there are too many.
export class RowTrack {
  times: number[] = [];
  /** Of each instant: its rows, and their numbers. */
  rows: number[] = [];
  numbers: Float32Array[] = [];
  /** Changes with each instant. */
  version = 0;

  constructor(readonly capacity = 6000) {}

  clear(): void {
    this.times = [];
    this.rows = [];
    this.numbers = [];
    ++this.version;
  }

  /** A time before the last one is of another run of the server. */
  put(time: number, rows: number, numbers: Float32Array): void {
    if (this.times.length > 0 && time < this.times.at(-1)!) this.clear();
    if (this.times.length >= this.capacity) {
      const half = this.capacity >> 1;
      this.times = this.times.slice(half);
      this.rows = this.rows.slice(half);
      this.numbers = this.numbers.slice(half);
    }
    this.times.push(time);
    this.rows.push(rows);
    this.numbers.push(numbers);
    ++this.version;
  }

  get size(): number {
    return this.times.length;
  }

  /** The last instant at or before this time; -1: all are later. */
  at(time: number): number {
    let low = 0, high = this.times.length;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.times[middle]! <= time) low = middle + 1;
      else high = middle;
    }
    return low - 1;
  }
}
