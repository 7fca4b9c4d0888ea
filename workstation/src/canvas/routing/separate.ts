// Pieces of different lines that would lie on each other are moved apart. Lines to the same input may share a
// piece: they meet there anyway.
import type { XY } from "./geometry";

export interface Routed {
  key: string;
  /** Lines of one group may lie on each other. */
  group: string;
  points: readonly XY[];
}

const lane = 8;

interface Piece {
  line: number;
  index: number;
  group: string;
  from: number;
  to: number;
}

/** Points with moved inner pieces; those at the ends stay, since connectors do. */
export function separated(lines: readonly Routed[]): Map<string, XY[]> {
  const points = lines.map((each) => each.points.map((p) => ({ ...p })));
  for (const axis of ["x", "y"] as const) {
    const along = axis === "x" ? "y" : "x";
    const places = new Map<number, Piece[]>();
    points.forEach((each, line) => {
      for (let i = 1; i + 2 < each.length; ++i) {
        const a = each[i]!, b = each[i + 1]!;
        if (a[axis] !== b[axis]) continue;
        const piece = { line, index: i, group: lines[line]!.group, from: Math.min(a[along], b[along]), to: Math.max(a[along], b[along]) };
        places.set(a[axis], [...(places.get(a[axis]) ?? []), piece]);
      }
    });
    for (const [place, pieces] of places) {
      if (pieces.length < 2) continue;
      assign(pieces).forEach((offset, i) => {
        const { line, index } = pieces[i]!;
        points[line]![index]![axis] = place + offset;
        points[line]![index + 1]![axis] = place + offset;
      });
    }
  }
  return new Map(lines.map((each, i) => [each.key, points[i]!]));
}

/** 0, lane, -lane, 2 lane, …: the first at which no other group lies beside it. */
function assign(pieces: readonly Piece[]): number[] {
  const offsets: number[] = [];
  pieces.forEach((piece, i) => {
    for (let n = 0; ; ++n) {
      const offset = n === 0 ? 0 : (n % 2 === 1 ? 1 : -1) * Math.ceil(n / 2) * lane;
      const taken = pieces.slice(0, i).some((other, j) =>
        offsets[j] === offset && other.group !== piece.group && other.from < piece.to + 2 && piece.from < other.to + 2);
      if (!taken) return void offsets.push(offset);
    }
  });
  return offsets;
}
