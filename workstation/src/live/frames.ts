// Binary messages of live data, as `x-binary` of the protocol's schema has them.
import type { ProfileMark } from "../../generated/protocol";

export interface SpanFrame {
  form: "spans";
  channel: string;
  count: number;
  fields: number;
  dropped: number;
  /** For each span begin, end, count; then low, high and last of each field. */
  numbers: Float64Array;
}

export interface ProfileFrame {
  form: "profile";
  channel: string;
  time_s: number;
  /** mm, in the order of the scan. */
  y: Float64Array;
  z: Float64Array;
  /** Of the scan: its points, and the stretches [from, to) of them that had no range. */
  scanned: number;
  missing: readonly [number, number][];
  /** What the logical sensors see in it. */
  marks: readonly ProfileMark[];
  dropped: number;
}

/** One instant of a channel of rows. */
export interface RowsFrame {
  form: "rows";
  channel: string;
  time_s: number;
  rows: number;
  fields: number;
  dropped: number;
  numbers: Float32Array;
}

export function decode(bytes: ArrayBuffer): SpanFrame | ProfileFrame | RowsFrame {
  const length = new DataView(bytes).getUint32(0, true);
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 4, length)));
  if (head.rows !== undefined)
    return { form: "rows", channel: head.channel, time_s: head.time_s, rows: head.rows, fields: head.fields, dropped: head.dropped, numbers: new Float32Array(bytes, 4 + length, head.rows * head.fields) };
  const numbers = new Float64Array(bytes, 4 + length);
  if (head.points === undefined)
    return { form: "spans", channel: head.channel, count: head.spans, fields: head.fields, dropped: head.dropped, numbers };
  return {
    form: "profile", channel: head.channel, time_s: head.time_s, y: numbers.subarray(0, head.points), z: numbers.subarray(head.points, 2 * head.points),
    scanned: head.scanned, missing: head.missing, marks: head.marks, dropped: head.dropped,
  };
}
