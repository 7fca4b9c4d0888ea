// A run that is looked at again: what the server kept of it, the instant that is shown, and the icon that acted then. All
// windows look at one instant (time.ts); this keeps it within the run.
import { create } from "zustand";
import type { RecordedPage } from "../../generated/protocol";
import { call } from "../state/cell";
import { notReplayed, useReplayed } from "../state/replayed";
import { useChannels } from "./live";
import { RowTrack } from "./rowTrack";
import type { Acted } from "./steps";
import { lookAt, useInstant } from "./time";
import { Track } from "./track";

export interface KeptRun {
  run: number;
  name: string;
  begun: string;
  state: string;
  begin: number;
  end: number;
  channels: readonly string[];
}

export interface Loaded {
  kept: KeptRun;
  steps: readonly Acted[];
  /** Channels of rows; a profile, too, has y and z of each point as rows. */
  rows: ReadonlyMap<string, RowTrack>;
}

export const useReplay = create<{ loaded: Loaded | undefined; playing: boolean; pace: number; tracks: ReadonlyMap<string, Track> }>()(() => ({ loaded: undefined, playing: false, pace: 1, tracks: new Map() }));

/** The runs that can be looked at again, the newest first. */
export async function keptRuns(): Promise<KeptRun[]> {
  const [kept, { runs }] = await Promise.all([call("replay.list"), call("history.list", { limit: 200 })]);
  return kept.flatMap((each) => {
    const of = runs.find((one) => one.run === each.run);
    return of && each.end_s > each.begin_s ? [{ run: each.run, name: of.name, begun: of.begun, state: of.state, begin: each.begin_s, end: each.end_s, channels: each.channels }] : [];
  });
}

function numbersOf(page: RecordedPage): Float32Array {
  const text = atob(page.numbers), bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return new Float32Array(bytes.buffer);
}

/** Each instant of a channel of a run, page by page. */
async function read(run: number, channel: string, use: (time: number, rows: number, numbers: Float32Array) => void): Promise<void> {
  let after: number | undefined;
  for (;;) {
    const page = await call("replay.read", { run, channel, limit: 3000, ...(after === undefined ? {} : { after_s: after }) });
    const numbers = numbersOf(page), all = page.rows.reduce((sum, each) => sum + each, 0), fields = all === 0 ? 0 : numbers.length / all;
    let at = 0;
    page.times_s.forEach((time, i) => {
      const length = page.rows[i]! * fields;
      use(time, page.rows[i]!, numbers.subarray(at, at + length));
      at += length;
    });
    after = page.times_s.at(-1);
    if (!page.more || after === undefined) return;
  }
}

async function stepsOf(run: number): Promise<Acted[]> {
  const steps: Acted[] = [];
  let after = 0;
  for (;;) {
    const page = await call("history.read", { run, after, limit: 1000 });
    for (const { step, parameters } of page.steps) {
      steps.push({
        icon: step.icon ?? "", skill: step.skill ?? "", sensor: step.sensor ?? "", begin: step.begin_s, end: step.end_s, parameters: parameters as Record<string, unknown>, code: step.code, kind: step.kind,
        reading: undefined,
      });
      after = step.step;
    }
    if (!page.more) return steps;
  }
}

let wanted = 0;

/** Looks at a run from its beginning on. Gives an error if the server does not have it. */
export async function replay(kept: KeptRun): Promise<void> {
  const mine = ++wanted;
  const forms = useChannels.getState().channels ?? [];
  const rows = new Map<string, RowTrack>();
  const reads = forms.filter((each) => each.form !== "numbers" && kept.channels.includes(each.channel)).map((each) => {
    const track = new RowTrack(Infinity);
    rows.set(each.channel, track);
    return read(kept.run, each.channel, (time, count, numbers) => track.put(time, count, numbers));
  });
  const [steps] = await Promise.all([stepsOf(kept.run), ...reads]);
  if (mine !== wanted) return;
  useReplay.setState({ loaded: { kept, steps, rows }, playing: false, tracks: new Map() });
  useReplayed.setState({ run: kept.run, name: kept.name });
  show(kept.begin);
}

/** The cell is shown as it is now. */
export function endReplay(): void {
  ++wanted;
  if (!useReplay.getState().loaded) return;
  useReplay.setState({ loaded: undefined, playing: false, tracks: new Map() });
  useReplayed.setState(notReplayed);
  lookAt(undefined);
}

/** The instant that all windows look at. */
export function show(time: number): void {
  const { loaded } = useReplay.getState();
  if (!loaded) return;
  const within = Math.min(loaded.kept.end, Math.max(loaded.kept.begin, time));
  const icon = actedAt(loaded.steps, within)?.icon ?? "";
  useReplayed.setState({ time: within, icon });
  lookAt(within);
}

export const actedAt = (steps: readonly Acted[], time: number): Acted | undefined => steps.findLast((each) => each.begin <= time && time <= (each.end ?? Infinity));

// Another window may choose the instant; one that lets go of it leaves it where it was.
useInstant.subscribe(({ time }) => {
  const { loaded } = useReplay.getState();
  if (!loaded) return;
  const now = useReplayed.getState().time;
  if (time === undefined) queueMicrotask(() => useReplay.getState().loaded && useInstant.getState().time === undefined && lookAt(useReplayed.getState().time));
  else if (time !== now) show(time);
});

/** A channel of numbers as it was in the run; it is read when a chart first asks for it. */
export function replayedTrack(channel: string, fields: number): Track {
  const { loaded, tracks } = useReplay.getState();
  const there = tracks.get(channel);
  if (there) return there;
  const track = new Track(fields, 40000);
  useReplay.setState({ tracks: new Map(tracks).set(channel, track) });
  if (loaded?.kept.channels.includes(channel))
    void read(loaded.kept.run, channel, (time, _, numbers) => track.take(Float64Array.of(time, time, 1, ...numbers), 1)).catch(() => {});
  return track;
}
