// The steps that the cell has done since this page knows it: what acted when, with which parameters. Charts show them
// under their lines, and limits where they held.
import { create } from "zustand";
import type { Channel, Event, ShownLimit, Skill } from "../../generated/protocol";
import { onEvent, useCell } from "../state/cell";

type Ends = Extract<Event, { event: "ends" }>;

export interface Acted {
  icon: string;
  skill: string;
  sensor: string;
  begin: number;
  /** Undefined: it goes on. */
  end: number | undefined;
  parameters: Readonly<Record<string, unknown>>;
  code: number | undefined;
  kind: string | undefined;
  reading: number | undefined;
}

const most = 2000;

export const useSteps = create<{ steps: readonly Acted[] }>()(() => ({ steps: [] }));

const begun = (event: { icon: string; skill?: string; sensor?: string; begin_s: number; parameters?: unknown }): Acted => ({
  icon: event.icon, skill: event.skill ?? "", sensor: event.sensor ?? "", begin: event.begin_s, end: undefined,
  parameters: (event.parameters ?? {}) as Record<string, unknown>, code: undefined, kind: undefined, reading: undefined,
});

function add(step: Acted): void {
  useSteps.setState((state) => {
    const kept = state.steps.filter((each) => each.end !== undefined && each.begin <= step.begin);
    return { steps: [...(kept.length >= most ? kept.slice(most / 4) : kept), step] };
  });
}

function close(event: Ends): void {
  const { steps } = useSteps.getState();
  const open = steps.at(-1);
  const made: Acted = {
    ...(open && open.end === undefined && open.icon === event.icon ? open : begun(event)), end: event.end_s, code: event.code, kind: event.kind ?? "normal",
    reading: event.reading ?? undefined,
  };
  useSteps.setState({ steps: [...steps.filter((each) => each.end !== undefined), made] });
}

onEvent((event) => {
  if (event.event === "begins") add(begun(event));
  if (event.event === "ends") close(event);
});
const running = useCell.getState().present?.snapshot.running;
if (running) add(begun(running));

export const stepsWithin = (begin: number, end: number): Acted[] =>
  useSteps.getState().steps.filter((each) => each.begin <= end && (each.end ?? Infinity) >= begin);

/** A limit on a field while a step acted. */
export interface LimitLine {
  field: string;
  value: number;
  kind: ShownLimit["kind"];
  parameter: string;
  begin: number;
  end: number | undefined;
}

const valueOf = (step: Acted, skill: Skill, name: string): number | undefined => {
  const value = step.parameters[name] ?? skill.parameters.find((each) => each.name === name)?.default;
  return typeof value === "number" ? value : undefined;
};

/** The limits that the parameters of a step set on the fields of a channel. */
export function limitsOf(step: Acted, channel: Channel): LimitLine[] {
  const skill = useCell.getState().skills.get(step.skill);
  if (!skill) return [];
  return channel.limits.filter((each) => each.skill === step.skill).flatMap((each) => {
    const value = valueOf(step, skill, each.parameter), around = each.around ? valueOf(step, skill, each.around.parameter) : 0;
    if (value === undefined || around === undefined) return [];
    const middle = around * (each.around?.factor ?? 1);
    return each.fields.flatMap((field) => (each.both ? [1, -1] : [1]).map((sign): LimitLine =>
      ({ field, value: middle + sign * value * each.factor, kind: each.kind, parameter: each.parameter, begin: step.begin, end: step.end })));
  });
}
