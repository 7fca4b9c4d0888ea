// Why a run came to nothing, told in the order in which a person asks: which icon, what happened, where in its program.
import type { Present } from "./happened";

export interface Cause {
  /** "the surface has ended: nothing was felt for 140 ms". */
  what: string;
  /** Of the skill's program, for whoever writes skills: "SM1.2 at slide (rub.pal:82)"; empty: it does not say. */
  where: string;
}

/** The server's sentence begins with where it was; what happened comes last. */
export function causeOf(reason: string): Cause {
  const found = /(?:^|: )([A-Za-z]\w*(?:\.\d+)* at .+? \([^()]*:\d+\)): (.+)$/s.exec(reason);
  return found ? { what: found[2]!, where: found[1]! } : { what: reason, where: "" };
}

/** The icon at which it failed, or whose code led to an exit with a code other than 0, by its path. */
export function culprit(present: Present | undefined): string | undefined {
  if (!present) return undefined;
  const { state, token, last_code } = present.snapshot;
  if (state === "failed") return token;
  if (state !== "ended" || last_code === 0) return undefined;
  let last: { icon: string; at: number } | undefined;
  for (const each of present.runs.values()) {
    const at = each.ended_s ?? each.last_s;
    if (each.kind !== undefined && each.kind !== "normal" && (!last || at >= last.at)) last = { icon: each.icon, at };
  }
  return last?.icon;
}
