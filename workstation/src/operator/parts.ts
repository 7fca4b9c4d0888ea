// What an operator sees of the operation that is loaded: its icons with parameters, those set free and those locked.
import type { Icon, Operation } from "../model/operation";
import { operationNamed, type Drawing } from "../model/operation";

export interface Part {
  /** "rub-in-square/side-1". */
  path: string;
  icon: Icon;
  /** It lets an operator set something. */
  free: boolean;
}

/** All skills and sub-operations with parameters, in the order of the file, those inside others behind them. */
export function partsOf(drawing: Drawing): Part[] {
  const found: Part[] = [];
  const walk = (operation: Operation | undefined, prefix: string, depth: number) => {
    for (const icon of operation?.icons ?? []) {
      if (icon.kind !== "skill" && icon.kind !== "operation") continue;
      const path = prefix + icon.id, free = Object.keys(icon.operator ?? {}).length > 0;
      if (icon.kind === "skill" || free) found.push({ path, icon, free });
      if (icon.kind === "operation" && !icon.file && icon.operation && depth < 16) walk(operationNamed(drawing, icon.operation), `${path}/`, depth + 1);
    }
  };
  walk(drawing as Operation, "", 0);
  return found;
}
