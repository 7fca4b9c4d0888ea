// What was seen of one channel of numbers, for some minutes: the least, the greatest and the last of each span. Its
// memory is taken at the beginning and never grows; the older half goes when it is full.
export class Track {
  readonly capacity: number;
  /** Ends of spans, s of the cell. */
  readonly times: Float64Array;
  readonly low: readonly Float64Array[];
  readonly high: readonly Float64Array[];
  readonly last: readonly Float64Array[];
  size = 0;
  /** Changes with each span. */
  version = 0;

  constructor(readonly fields: number, capacity = 8192) {
    this.capacity = capacity;
    this.times = new Float64Array(capacity);
    const rows = () => Array.from({ length: fields }, () => new Float64Array(capacity));
    this.low = rows();
    this.high = rows();
    this.last = rows();
  }

  clear(): void {
    this.size = 0;
    ++this.version;
  }

  /** `numbers` as a frame of the protocol has them. A time before the last one is of another run of the server. */
  take(numbers: Float64Array, spans: number): void {
    const width = 3 + 3 * this.fields;
    for (let i = 0; i < spans; ++i) {
      const at = i * width, time = numbers[at + 1]!;
      if (this.size > 0 && time < this.times[this.size - 1]!) this.clear();
      if (this.size === this.capacity) this.#drop();
      this.times[this.size] = time;
      for (let field = 0; field < this.fields; ++field) {
        this.low[field]![this.size] = numbers[at + 3 + field]!;
        this.high[field]![this.size] = numbers[at + 3 + this.fields + field]!;
        this.last[field]![this.size] = numbers[at + 3 + 2 * this.fields + field]!;
      }
      ++this.size;
    }
    ++this.version;
  }

  /** One value of each field at an instant. */
  put(time: number, values: readonly number[]): void {
    this.take(Float64Array.of(time, time, 1, ...values, ...values, ...values), 1);
  }

  get end(): number | undefined {
    return this.size > 0 ? this.times[this.size - 1] : undefined;
  }

  /** The spans [from, to) that end within these times. */
  within(begin: number, end: number): [number, number] {
    return [this.#first(begin), this.#first(end + 1e-9)];
  }

  /** The span that holds at this time; undefined: none does. */
  at(time: number): number | undefined {
    if (this.size === 0 || time < this.times[0]! - 1 || time > this.end! + 1) return undefined;
    return Math.min(this.size - 1, this.#first(time));
  }

  #first(time: number): number {
    let low = 0, high = this.size;
    while (low < high) {
      const middle = (low + high) >> 1;
      if (this.times[middle]! < time) low = middle + 1;
      else high = middle;
    }
    return low;
  }

  #drop(): void {
    const half = this.capacity >> 1;
    for (const each of [this.times, ...this.low, ...this.high, ...this.last]) each.copyWithin(0, half, this.size);
    this.size -= half;
  }
}
