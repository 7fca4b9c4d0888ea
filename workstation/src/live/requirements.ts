// What is proved and what is measured of the requirements, asked for while a window shows it, and kept against time.
import { create } from "zustand";
import type { Methods, Requirement } from "../../generated/protocol";
import { Broken, Refused } from "../protocol/connection";
import { call, useCell } from "../state/cell";
import { Track } from "./track";

export type OfSkill = Methods["requirements"]["result"][number];

export const useRequirements = create<{ all: readonly OfSkill[] | undefined }>()(() => ({ all: undefined }));

const tracks = new Map<string, Track>();
/** Now and worst, in the unit that is shown. */
export function trackOfRequirement(skill: string, name: string): Track {
  const key = `${skill}/${name}`;
  let track = tracks.get(key);
  if (!track) tracks.set(key, (track = new Track(2, 4096)));
  return track;
}

let lookers = 0;
let timer: ReturnType<typeof setTimeout> | undefined;
const often = 100, seldom = 1000;

async function read(): Promise<void> {
  clearTimeout(timer);
  const before = useCell.getState().present?.snapshot.activity;
  try {
    const all = await call("requirements");
    useRequirements.setState({ all });
    for (const each of all) for (const one of each.requirements) note(each, one);
  } catch (problem) {
    if (!(problem instanceof Broken) && !(problem instanceof Refused)) throw problem;
  }
  if (lookers > 0) timer = setTimeout(() => void read(), before === "idle" ? seldom : often);
}

function note({ skill, time_s }: OfSkill, one: Requirement): void {
  if (typeof one.now !== "number" || typeof one.measured !== "number") return;
  const track = trackOfRequirement(skill, one.name), at = track.size - 1;
  if (at >= 0 && track.times[at] === time_s) return;
  const { factor } = shownUnit(one.unit);
  track.put(time_s, [one.now * factor, one.measured * factor]);
}

export function watchRequirements(): () => void {
  if (lookers++ === 0) void read();
  return () => {
    if (--lookers === 0) clearTimeout(timer);
  };
}

/** In units that people read: ms of times. */
export const shownUnit = (unit: string): { unit: string; factor: number } => (unit === "s" ? { unit: "ms", factor: 1000 } : { unit, factor: 1 });
