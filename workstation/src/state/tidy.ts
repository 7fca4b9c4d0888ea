// Places for the icons of the operation that is shown, laid out by the server.
import type { Drawing, Operation, Point } from "../model/operation";
import { moveIcons } from "../model/edit";
import { operationsOf, withOperation } from "../model/operation";
import { sizeOf } from "../canvas/shape";
import { Broken, Refused } from "../protocol/connection";
import { t } from "../words/words";
import { call } from "./cell";
import { mainFile, textOf } from "./checks";
import { editShown, say, shownOperation, useDrawing } from "./drawing";

const apart: [number, number] = [72, 48];

async function places(drawing: Drawing, operation?: string): Promise<Map<string, Map<string, Point>>> {
  const sizes: Record<string, [number, number]> = {};
  // By kind: the greatest there is.
  for (const each of operationsOf(drawing))
    for (const icon of each.icons) {
      const { width, height } = sizeOf(icon), before = sizes[icon.kind] ?? [0, 0];
      sizes[icon.kind] = [Math.max(width, before[0]), Math.max(height, before[1])];
    }
  const result = await call("operation.tidy", { main: mainFile, files: { [mainFile]: textOf(drawing) }, sizes, apart, ...(operation === undefined ? {} : { operation }) });
  const found = new Map<string, Map<string, Point>>();
  for (const each of result.places) {
    const of = found.get(each.operation) ?? new Map<string, Point>();
    of.set(each.icon, [Math.round(each.at[0] / 8) * 8, Math.round(each.at[1] / 8) * 8]);
    found.set(each.operation, of);
  }
  return found;
}

export async function tidy(): Promise<void> {
  const { drawing } = useDrawing.getState();
  const operation = shownOperation(useDrawing.getState());
  try {
    const found = (await places(drawing, operation.name)).get(operation.name);
    if (found && useDrawing.getState().drawing === drawing) editShown("edit.tidy", (now) => moveIcons(now, found));
  } catch (problem) {
    if (!(problem instanceof Refused || problem instanceof Broken)) throw problem;
    say(problem instanceof Refused ? problem.message : t("said.away"));
  }
}

const crowded = (operation: Operation): boolean =>
  operation.icons.some((icon, i) => !icon.at || operation.icons.slice(0, i).some((other) => {
    if (!other.at || !icon.at) return true;
    const a = sizeOf(icon), b = sizeOf(other);
    return icon.at[0] < other.at[0] + b.width + 24 && other.at[0] < icon.at[0] + a.width + 24 && icon.at[1] < other.at[1] + b.height && other.at[1] < icon.at[1] + a.height;
  }));

/** A drawing from elsewhere whose icons have no places, or lie on each other, gets places. */
export async function readable(drawing: Drawing): Promise<Drawing> {
  if (!operationsOf(drawing).some(crowded)) return drawing;
  try {
    const found = await places(drawing);
    return operationsOf(drawing).filter(crowded).reduce((result, each) => {
      const of = found.get(each.name);
      return of ? withOperation(result, each.name, moveIcons(each, of)) : result;
    }, drawing);
  } catch (problem) {
    if (problem instanceof Refused || problem instanceof Broken) return drawing;
    throw problem;
  }
}
