// The contacts of a row, as few as tell the same.
import { Vector3 } from "three";

/** Contacts that are near one another and press the same way count as one: it has their sum. */
export interface Press {
  position: Vector3;
  force: Vector3;
}

export function presses(rows: Float32Array): Press[] {
  const near = 0.03, all: (Press & { weight: number })[] = [];
  for (let at = 0; at + 6 <= rows.length; at += 6) {
    const position = new Vector3().fromArray(rows, at), force = new Vector3().fromArray(rows, at + 3), weight = force.length();
    if (weight < 0.05) continue;
    const with_it = all.find((each) => each.position.distanceTo(position) < near && each.force.dot(force) > 0);
    if (!with_it) {
      all.push({ position, force, weight });
      continue;
    }
    with_it.position.lerp(position, weight / (weight + with_it.weight));
    with_it.force.add(force);
    with_it.weight += weight;
  }
  return all;
}
