// A binary heap: the least key first.
export class Heap {
  #keys: number[] = [];
  #values: number[] = [];

  push(key: number, value: number): void {
    let i = this.#keys.length;
    this.#keys.push(key);
    this.#values.push(value);
    while (i > 0) {
      const parent = (i - 1) >> 1;
      if (this.#keys[parent]! <= key) break;
      this.#swap(i, parent);
      i = parent;
    }
  }

  pop(): number | undefined {
    const least = this.#values[0];
    const key = this.#keys.pop(), value = this.#values.pop();
    if (key === undefined || value === undefined || this.#keys.length === 0) return least;
    this.#keys[0] = key;
    this.#values[0] = value;
    for (let i = 0; ;) {
      const left = 2 * i + 1, right = left + 1;
      let small = i;
      if (left < this.#keys.length && this.#keys[left]! < this.#keys[small]!) small = left;
      if (right < this.#keys.length && this.#keys[right]! < this.#keys[small]!) small = right;
      if (small === i) return least;
      this.#swap(i, small);
      i = small;
    }
  }

  #swap(a: number, b: number): void {
    [this.#keys[a], this.#keys[b]] = [this.#keys[b]!, this.#keys[a]!];
    [this.#values[a], this.#values[b]] = [this.#values[b]!, this.#values[a]!];
  }
}
