// A jog as this page holds it: begun when a person holds something, kept alive while they do, ended when they let go.
// That the arm stops without this page is the server's and the skill's part.
import { create } from "zustand";
import type { Methods } from "../../generated/protocol";
import { Refused, Broken } from "../protocol/connection";
import { notice } from "../state/acts";
import { call } from "../state/cell";
import { t } from "../words/words";

export type Axes = [number, number, number, number, number, number];
export type Frame = "joints" | "world" | "tool";
export type Start = Methods["jog.start"]["params"];
export type Ended = Methods["jog.start"]["result"];

export const keepEach = 50; // ms

interface Jog {
  /** What the person wants now; undefined: nothing is held. */
  held: Axes | undefined;
  /** From its beginning until the arm is at rest. */
  moves: boolean;
  /** How the last one ended. */
  ended: Ended | undefined;
}

export const useJog = create<Jog>()(() => ({ held: undefined, moves: false, ended: undefined }));

/** What holds: a button, a key, the gamepad. Each has its own share of the axes. */
const holders = new Map<string, Axes>();
let settings: Start = { frame: "tool" };
let timer: ReturnType<typeof setInterval> | undefined;
/** The step is made, or it was stopped: nothing begins anew before all is let go. */
let spent = false;

export function set(next: Start): void {
  settings = next;
}

function sum(): Axes {
  const axes: Axes = [0, 0, 0, 0, 0, 0];
  for (const each of holders.values()) for (let i = 0; i < 6; ++i) axes[i] = Math.max(-1, Math.min(1, axes[i]! + each[i]!));
  return axes;
}

export function hold(holder: string, axes: Axes): void {
  holders.set(holder, axes);
  useJog.setState({ held: sum() });
  if (!useJog.getState().moves && !spent) void begin();
}

export function letGo(holder: string): void {
  if (!holders.delete(holder)) return;
  if (holders.size > 0) return useJog.setState({ held: sum() });
  useJog.setState({ held: undefined });
  spent = false;
  clearInterval(timer);
  if (useJog.getState().moves) quiet(call("jog.stop"));
}

/** The page is left, hidden, or has lost the focus. */
export function letAllGo(): void {
  for (const each of [...holders.keys()]) letGo(each);
}

/** What is refused here is told by jog.start. */
function quiet(answer: Promise<unknown>): void {
  answer.catch(() => {});
}

async function begin(): Promise<void> {
  useJog.setState({ moves: true, ended: undefined });
  const keep = () => void (holders.size > 0 && quiet(call("jog.keep", { axes: sum() })));
  clearInterval(timer);
  try {
    const ends = call("jog.start", settings);
    keep();
    timer = setInterval(keep, keepEach);
    useJog.setState({ ended: await ends });
  } catch (problem) {
    if (problem instanceof Refused) notice("error", problem.message, problem.data.hint ?? "");
    else if (problem instanceof Broken) notice("error", t("said.away"));
    else throw problem;
  } finally {
    clearInterval(timer);
    spent = holders.size > 0;
    useJog.setState({ moves: false });
  }
}

for (const event of ["blur", "pagehide"] as const) addEventListener(event, letAllGo);
document.addEventListener("visibilitychange", () => document.hidden && letAllGo());
