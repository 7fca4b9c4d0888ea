// What a person does to the operation that is shown. Each is one entry of the history and says what happened.
import * as model from "../model/edit";
import { copy, paste, type Clip } from "../model/clipboard";
import { collapse, expand } from "../model/hierarchy";
import { addOperation, freeName, iconOf, operationNamed, operationsOf, withOperation, type Drawing, type Icon, type Kind, type Operation, type Point } from "../model/operation";
import { outputs, type PortName } from "../model/ports";
import { t, type Word } from "../words/words";
import { edit, editShown, enter, redo, say, select, shownOperation, undo, useDrawing } from "./drawing";

const shown = (): Operation => shownOperation(useDrawing.getState());

/** What the palette offers: a kind of icon, a skill, or an operation. */
export interface Offer {
  kind: Kind;
  skill?: string;
  operation?: string;
  file?: string;
}

function partsOf(offer: Offer): Partial<Icon> {
  return {
    ...(offer.skill === undefined ? {} : { skill: offer.skill }),
    ...(offer.operation === undefined ? {} : { operation: offer.operation }),
    ...(offer.file === undefined ? {} : { file: offer.file }),
    ...(offer.kind === "planned" ? { codes: [{ code: 0, text: t("planned.done") }, { code: 1, text: t("planned.notDone") }] } : {}),
  };
}

const nameFor = (offer: Offer): string => offer.skill ?? offer.operation ?? offer.file?.replace(/\.op\.json$/, "") ?? (offer.kind === "exit" ? "done" : offer.kind === "planned" ? "new-skill" : offer.kind);

/** Puts a new icon on the canvas, at the end of a line if one is given. Its id; undefined: a second START. */
export function insertIcon(offer: Offer, at: Point, from?: { icon: string; port: PortName }): string | undefined {
  const operation = shown();
  if (offer.kind === "start" && operation.icons.some((icon) => icon.kind === "start")) {
    say(t("said.oneStart"));
    return undefined;
  }
  const fresh = offer.kind === "operation" && !offer.operation && !offer.file;
  const part = fresh ? freeName("part", operationsOf(useDrawing.getState().drawing).map((each) => each.name)) : undefined;
  const what = part === undefined ? offer : { ...offer, operation: part };
  const id = freeName(nameFor(what), operation.icons.map((icon) => icon.id));
  const place: Point = [Math.round(at[0] / 8) * 8, Math.round(at[1] / 8) * 8];
  edit("edit.add", (drawing) => {
    const changed = changeIn(drawing, operation.name, (now) => {
      const added = model.addIcon(now, model.newIcon(what.kind, id, place, partsOf(what)));
      return from && what.kind !== "start" ? model.connect(added, from.icon, from.port, id) : added;
    });
    return part === undefined ? changed : addOperation(changed, emptyPart(part));
  }, { select: [id] });
  say(t("said.added", { name: id }));
  return id;
}

/** What a new hierarchical icon stands for, until it is drawn. */
function emptyPart(name: string): Operation {
  return { name, icons: [model.newIcon("start", "start", [0, 0], { next: "done" }), model.newIcon("exit", "done", [240, 0], { code: 0 })] };
}

export function removeSelected(next?: string): void {
  const { selected } = useDrawing.getState();
  if (selected.size === 0) return;
  const ids = new Set(selected);
  editShown("edit.remove", (now) => model.removeIcons(now, ids), { select: next ? [next] : [] });
  say(t("said.removed", { count: ids.size }));
}

export function connectIcons(from: string, port: PortName, to: string): void {
  const source = iconOf(shown(), from), target = iconOf(shown(), to);
  if (!source || !target || target.kind === "start") return say(t("said.noInput", { name: to }));
  editShown("edit.connect", (now) => model.connect(now, from, port, to));
  say(t("said.connected", { from, to }));
}

export function disconnect(from: string, port: PortName): void {
  editShown("edit.disconnect", (now) => model.connect(now, from, port, undefined));
  say(t("said.disconnected", { from }));
}

export function moveTo(places: ReadonlyMap<string, Point>): void {
  editShown("edit.move", (now) => model.moveIcons(now, places));
}

export function nudge(dx: number, dy: number): void {
  const { selected } = useDrawing.getState();
  const places = new Map(shown().icons.filter((icon) => selected.has(icon.id)).map((icon) => [icon.id, [(icon.at?.[0] ?? 0) + dx, (icon.at?.[1] ?? 0) + dy] as Point]));
  if (places.size > 0) editShown("edit.move", (now) => model.moveIcons(now, places), { run: `nudge:${[...selected].join()}` });
}

export function change(operation: string, id: string, label: Word, how: (icon: Icon) => Icon, run?: string): void {
  edit(label, (drawing) => changeIn(drawing, operation, (now) => model.changeIcon(now, id, how)), run === undefined ? {} : { run });
}

function changeIn(drawing: Drawing, name: string, how: (operation: Operation) => Operation): Drawing {
  const operation = operationNamed(drawing, name);
  if (!operation) return drawing;
  const changed = how(operation);
  return changed === operation ? drawing : withOperation(drawing, name, changed);
}

export function rename(operation: string, from: string, to: string): string {
  const { selected, focus } = useDrawing.getState();
  const before = new Set(shown().icons.map((icon) => icon.id));
  edit("edit.rename", (drawing) => changeIn(drawing, operation, (now) => model.renameIcon(now, from, to)));
  const named = shown().icons.find((icon) => !before.has(icon.id))?.id ?? from;
  select([...selected].map((id) => (id === from ? named : id)), focus === from ? named : focus);
  return named;
}

let clip: Clip | undefined;
const clipKey = "workcell-clip";
let pasted = 0;

/** The clip is kept for other tabs of the same server, too. */
export function copySelected(): void {
  const { drawing, selected } = useDrawing.getState();
  if (selected.size === 0) return;
  clip = copy(drawing, shown(), selected);
  pasted = 0;
  localStorage.setItem(clipKey, JSON.stringify(clip));
  say(t("said.copied", { count: selected.size }));
}

export function pasteClip(): void {
  const text = localStorage.getItem(clipKey);
  const what = text ? (JSON.parse(text) as Clip) : clip;
  if (!what || what.icons.length === 0) return;
  const by = 32 * ++pasted;
  const result = paste(useDrawing.getState().drawing, shown().name, what, [by, by]);
  edit("edit.paste", () => result.drawing, { select: result.ids });
  say(t("said.pasted", { count: result.ids.length }));
}

const refuse = (key: string): string => {
  const text = t(`refused.${key}` as Word);
  say(text);
  return text;
};

/** A sentence if it was refused. */
export function collapseSelected(name: string): string | undefined {
  const { drawing, selected } = useDrawing.getState();
  const outcome = collapse(drawing, shown().name, selected, name);
  if ("refused" in outcome) return refuse(outcome.refused);
  edit("edit.collapse", () => outcome.drawing, { select: [outcome.id] });
  say(t("said.collapsed", { name: outcome.name }));
  return undefined;
}

export function expandIcon(id: string): string | undefined {
  const { drawing } = useDrawing.getState();
  const outcome = expand(drawing, shown().name, id);
  if ("refused" in outcome) return refuse(outcome.refused);
  edit("edit.expand", () => outcome.drawing, { select: [outcome.id] });
  say(t("said.expanded", { name: outcome.name }));
  return undefined;
}

export function undoSaid(): void {
  const entry = undo();
  say(entry ? t("said.undone", { what: t(entry.label as Word) }) : t("said.nothingToUndo"));
}
export function redoSaid(): void {
  const entry = redo();
  say(entry ? t("said.redone", { what: t(entry.label as Word) }) : t("said.nothingToRedo"));
}

/** The output that a new line from this icon takes. */
export function portFor(id: string): PortName | undefined {
  const icon = iconOf(shown(), id);
  return icon && outputs(icon).length > 0 ? model.openPort(icon) : undefined;
}

/** Opens a hierarchical icon; a new one gets an operation of its own. */
export function popOpen(id: string): void {
  const state = useDrawing.getState();
  const icon = iconOf(shown(), id);
  if (icon?.kind !== "operation" || icon.file) return;
  enter([...state.trail, id]);
  say(t("said.entered", { name: icon.operation ?? id }));
}
