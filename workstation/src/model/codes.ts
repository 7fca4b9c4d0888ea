// Which completion codes a CASE may see, and what they mean in words. Skills say it in their templates; other icons
// by a key of the words catalogue.
import type { Skill } from "../../generated/protocol";
import { iconOf, isSource, operationNamed, type Drawing, type Icon, type Operation } from "./operation";
import { outputs } from "./ports";

export interface CodeMeaning {
  code: number;
  /** In words, as a template or a note has it … */
  text?: string;
  /** … or a key of the catalogue, with values. */
  word?: "code.shown" | "code.timeOver" | "code.below" | "code.from" | "code.last" | "code.met" | "code.notMet" | "code.exit" | "code.zeroed";
  values?: Record<string, string | number>;
  kind: "normal" | "contingency" | "error";
  /** The icon that ends with it. */
  from: string;
}

/** The icons that act last before the token comes here: backwards over MERGEs and delays. */
export function actorsBefore(operation: Operation, id: string): Icon[] {
  const into = new Map<string, Icon[]>();
  for (const icon of operation.icons)
    for (const port of outputs(icon)) if (port.to !== undefined) into.set(port.to, [...(into.get(port.to) ?? []), icon]);
  const found = new Map<string, Icon>();
  const seen = new Set<string>();
  const todo = [id];
  for (let each = todo.pop(); each !== undefined; each = todo.pop()) {
    if (seen.has(each)) continue;
    seen.add(each);
    for (const icon of into.get(each) ?? []) {
      if (["merge", "delay", "case"].includes(icon.kind)) todo.push(icon.id);
      else if (icon.kind !== "start") found.set(icon.id, icon);
    }
  }
  return [...found.values()];
}

const amount = (value: unknown): string => (isSource(value) ? Object.values(value).join(" ") : String(value));

function testMeanings(icon: Icon): CodeMeaning[] {
  const from = icon.id;
  if (icon.all || icon.any) return [
    { code: 0, word: "code.notMet", kind: "normal", from }, { code: 1, word: "code.met", kind: "normal", from }];
  const limits = (icon.limits ?? [icon["at-least"] ?? icon["at-most"] ?? 0]).map(amount);
  return [
    { code: 0, word: "code.below", values: { limit: limits[0] ?? "" }, kind: "normal", from },
    ...limits.map((low, i): CodeMeaning => {
      const high = limits[i + 1];
      return high === undefined
        ? { code: i + 1, word: "code.last", values: { limit: low }, kind: "normal", from }
        : { code: i + 1, word: "code.from", values: { low, high }, kind: "normal", from };
    }),
  ];
}

/** With which codes a hierarchical icon ends: those of its EXITs; an EXIT without one passes the last code on. */
function exitMeanings(drawing: Drawing, icon: Icon, skills: ReadonlyMap<string, Skill>, around: ReadonlySet<string>): CodeMeaning[] {
  const operation = icon.file ? undefined : operationNamed(drawing, icon.operation ?? "");
  if (!operation || around.has(operation.name)) return [];
  const within = new Set(around).add(operation.name);
  return operation.icons.filter((each) => each.kind === "exit").flatMap((each): CodeMeaning[] => {
    if (each.code === undefined) return passedOn(drawing, operation, each.id, skills, within).map((one) => ({ ...one, from: icon.id }));
    if (typeof each.code !== "number") return [];
    return [{
      code: each.code, kind: each.code === 0 ? "normal" : "error", from: icon.id,
      ...(each.note ? { text: each.note } : { word: "code.exit" as const, values: { name: each.id } }),
    }];
  });
}

/** The codes that reach an EXIT: of the lines that lead there, those that such a line carries. */
function passedOn(drawing: Drawing, operation: Operation, exit: string, skills: ReadonlyMap<string, Skill>, around: ReadonlySet<string>): CodeMeaning[] {
  return operation.icons.flatMap((icon) => outputs(icon).filter((port) => port.to === exit).flatMap((port): CodeMeaning[] => {
    if (icon.kind === "case") {
      const codes = icon.ways?.[Number(port.name.split(":")[1])]?.codes;
      const all = actorsBefore(operation, icon.id).flatMap((each) => meaningsOf(drawing, each, skills, around));
      const named = new Set(icon.ways?.flatMap((way) => way.codes));
      return all.filter((each) => (port.name === "default" ? !named.has(each.code) : codes?.includes(each.code)));
    }
    if (icon.kind === "merge" || icon.kind === "delay") return actorsBefore(operation, icon.id).flatMap((each) => meaningsOf(drawing, each, skills, around));
    if (icon.kind === "start") return [];
    return meaningsOf(drawing, icon, skills, around).filter((each) => (port.name === "error") === (each.kind !== "normal"));
  }));
}

export function meaningsOf(drawing: Drawing, icon: Icon, skills: ReadonlyMap<string, Skill>, around: ReadonlySet<string> = new Set()): CodeMeaning[] {
  const from = icon.id;
  switch (icon.kind) {
    case "skill":
      return (skills.get(icon.skill ?? "")?.completions ?? []).map((each) => ({ code: each.code, text: each.description, kind: each.kind, from }));
    case "test": return testMeanings(icon);
    case "wait": return [{ code: 0, word: "code.shown", kind: "normal", from }, { code: 1, word: "code.timeOver", kind: "contingency", from }];
    case "zero": return [{ code: 0, word: "code.zeroed", kind: "normal", from }];
    case "planned": return (icon.codes ?? []).map((each) => ({ code: each.code, text: each.text, kind: each.code === 0 ? "normal" : "contingency", from }));
    case "question": return (icon.answers ?? []).map((each, code) => ({ code, text: each.text, kind: "normal", from }));
    case "operation": return exitMeanings(drawing, icon, skills, around);
    default: return [];
  }
}

/** For a CASE, all codes that may come, in ascending order; two icons may give one code two meanings. */
export function meaningsBefore(drawing: Drawing, operation: Operation, id: string, skills: ReadonlyMap<string, Skill>): CodeMeaning[] {
  if (!iconOf(operation, id)) return [];
  const all = actorsBefore(operation, id).flatMap((icon) => meaningsOf(drawing, icon, skills)).sort((a, b) => a.code - b.code);
  const said = (each: CodeMeaning) => JSON.stringify([each.code, each.text, each.word, each.values, each.from]);
  return [...new Map(all.map((each) => [said(each), each])).values()];
}
