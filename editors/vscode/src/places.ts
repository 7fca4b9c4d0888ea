// From a picture's places to the text and back.
import type { PlaceInPicture, Position, Range } from "./protocol";

export function before(a: Position, b: Position): boolean {
  return a.line < b.line || (a.line === b.line && a.character < b.character);
}

export function holds(range: Range, at: Position): boolean {
  return !before(at, range.start) && !before(range.end, at);
}

/** The elements whose range holds the cursor. */
export function marked(places: readonly PlaceInPicture[], uri: string, at: Position): string[] {
  return places.filter((each) => each.uri === uri && holds(each.range, at)).map((each) => each.id);
}
