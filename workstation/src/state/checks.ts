// What the server finds in the drawing while it is drawn, and the proved times of its icons.
import { create } from "zustand";
import type { Finding, IconTimes } from "../../generated/protocol";
import type { Drawing } from "../model/operation";
import { Broken, Refused, type Result } from "../protocol/connection";
import { beginCall, useCell } from "./cell";
import { edit, useDrawing } from "./drawing";

export type Checked = Result<"operation.check">;

interface Checks {
  /** Of which drawing. */
  of: Drawing | undefined;
  text: string;
  result: Checked | undefined;
  pending: boolean;
  /** By "operation/icon"; by "operation/" what lies in no icon. */
  findings: ReadonlyMap<string, readonly Finding[]>;
  times: ReadonlyMap<string, IconTimes>;
}

export const useChecks = create<Checks>()(() => ({
  of: undefined, text: "", result: undefined, pending: false, findings: new Map(), times: new Map(),
}));

export const mainFile = "drawing.op.json";
export const textOf = (drawing: Drawing): string => JSON.stringify(drawing);
const place = (operation: string | undefined, icon: string | undefined) => `${operation ?? ""}/${icon ?? ""}`;

function keep(drawing: Drawing, text: string, result: Checked): void {
  const findings = new Map<string, Finding[]>();
  for (const each of result.findings) {
    const key = place(each.operation ?? drawing.name, each.icon);
    findings.set(key, [...(findings.get(key) ?? []), each]);
  }
  const times = new Map(result.icons.map((each) => [place(each.operation, each.icon), each]));
  useChecks.setState({ of: drawing, text, result, pending: false, findings, times });
}

let running: { cancel(): void } | undefined;
let timer: ReturnType<typeof setTimeout> | undefined;

async function check(drawing: Drawing): Promise<void> {
  running?.cancel();
  const text = textOf(drawing);
  const asked = beginCall("operation.check", { main: mainFile, files: { [mainFile]: text } });
  running = asked;
  useChecks.setState({ pending: true });
  try {
    const result = await asked.answer;
    if (useDrawing.getState().drawing === drawing) keep(drawing, text, result);
  } catch (problem) {
    if (!(problem instanceof Refused || problem instanceof Broken)) throw problem;
    if (problem instanceof Refused && problem.why !== "cancelled") useChecks.setState({ pending: false });
  }
}

/** Checks the drawing whenever it has not changed for a moment. */
export function keepChecking(): void {
  const soon = (wait: number) => {
    clearTimeout(timer);
    timer = setTimeout(() => {
      if (useCell.getState().link === "ready") void check(useDrawing.getState().drawing);
    }, wait);
  };
  useDrawing.subscribe((now, before) => {
    if (now.drawing !== before.drawing) soon(120);
  });
  useCell.subscribe((now, before) => {
    if (now.link === "ready" && before.link !== "ready") soon(0);
    if (now.locations !== before.locations || now.stored !== before.stored) soon(50);
  });
  soon(0);
}

/** Puts a finding's cure into the drawing. False: the drawing is another one by now. */
export function mend(finding: Finding): boolean {
  const { of, text } = useChecks.getState();
  if (of !== useDrawing.getState().drawing || finding.edits.length === 0) return false;
  let mended = text;
  for (const each of [...finding.edits].sort((a, b) => b.begin - a.begin)) {
    if (each.file !== mainFile) return false;
    mended = mended.slice(0, each.begin) + each.text + mended.slice(each.end);
  }
  const drawing = JSON.parse(mended) as Drawing;
  edit("edit.mend", () => drawing);
  return true;
}
