// Breakpoints. They stand at their icons in the drawing, so the file keeps them; a cell that has the drawing loaded is
// told of each change. Another client may have set more of them in the cell alone.
import type { Breakpoint } from "../../generated/protocol";
import { setField } from "../model/edit";
import { iconOf, operationNamed, operationsOf, type Drawing, type Icon } from "../model/operation";
import { pathsTo } from "./acts";
import { call, useCell } from "./cell";
import { walk, useDrawing } from "./drawing";
import { change } from "./edits";

export type KeptBreakpoint = NonNullable<Icon["break"]>;

export function setBreakpoint(operation: string, icon: string, kept: KeptBreakpoint | undefined, run?: string): void {
  change(operation, icon, "edit.break", (each) => setField(each, "break", kept), run);
}

/** At an icon of what is shown, by its path. One that the cell alone has goes, too. */
export function toggleBreakpoint(path: string): void {
  const { drawing } = useDrawing.getState();
  const parts = path.split("/"), id = parts.at(-1)!;
  const { operation } = walk(drawing, parts.slice(0, -1));
  const icon = iconOf(operation, id);
  if (!icon) return;
  const alone = icon.break ? [] : inCell(drawing).filter((each) => each.icon === path);
  for (const each of alone) void call("operation.unbreak", { breakpoint: each.breakpoint }).catch(() => {});
  if (alone.length === 0) setBreakpoint(operation.name, id, icon.break ? undefined : {});
}

/** Those that the cell has, if it has this operation loaded. */
export function inCell(drawing: Drawing): readonly Breakpoint[] {
  const snapshot = useCell.getState().present?.snapshot;
  return snapshot?.operation === drawing.name ? snapshot.breakpoints : [];
}

/** As the protocol has it. */
function asked(kept: KeptBreakpoint): Omit<Breakpoint, "breakpoint" | "icon" | "hits"> {
  const { value, "at-least": low, "at-most": high, enabled, ...rest } = kept;
  const condition = value ? { condition: { ...value, ...(low === undefined ? {} : { "at-least": low }), ...(high === undefined ? {} : { "at-most": high }) } } : {};
  return { ...rest, ...condition, enabled: enabled ?? true };
}

async function tellCell(drawing: Drawing, operation: string, icon: string, kept: KeptBreakpoint | undefined): Promise<void> {
  for (const prefix of pathsTo(drawing, operation)) {
    const path = prefix + icon;
    const there = inCell(drawing).filter((each) => each.icon === path);
    if (kept) await call("operation.break", { icon: path, ...asked(kept), ...(there[0] ? { breakpoint: there[0].breakpoint } : {}) });
    else for (const each of there) await call("operation.unbreak", { breakpoint: each.breakpoint });
  }
}

/** A change of the drawing reaches a cell that has it loaded, undo too. What the cell refuses is there at the next load. */
export function keepBreakpoints(): void {
  useDrawing.subscribe((now, before) => {
    if (now.drawing === before.drawing || now.opened !== before.opened || useCell.getState().link !== "ready") return;
    if (useCell.getState().present?.snapshot.operation !== now.drawing.name) return;
    for (const operation of operationsOf(now.drawing)) {
      const old = operationNamed(before.drawing, operation.name);
      if (!old || old.icons === operation.icons) continue;
      const was = new Map(old.icons.map((each) => [each.id, each]));
      for (const icon of operation.icons)
        if (was.get(icon.id) !== icon && JSON.stringify(was.get(icon.id)?.break) !== JSON.stringify(icon.break))
          tellCell(now.drawing, operation.name, icon.id, icon.break).catch(() => {});
    }
  });
}
