// Live data for the windows that are open. Each says what it shows and how finely; the server is asked for the finest
// of these and for nothing else. What no window shows is not sent.
import { create } from "zustand";
import type { Channel } from "../../generated/protocol";
import { call, onFrame, useCell } from "../state/cell";
import { decode, type ProfileFrame } from "./frames";
import { RowTrack } from "./rowTrack";
import { Track } from "./track";

export const useChannels = create<{ channels: readonly Channel[] | undefined }>()(() => ({ channels: undefined }));

interface Wish {
  channel: string;
  period: number;
}

const wishes = new Set<Wish>();
const tracks = new Map<string, Track>();
/** Kept for looking back, the newest last. */
export const profiles: ProfileFrame[] = [];
const most_profiles = 600;
/** Changes with each profile. */
export const profileVersion = { count: 0 };
let dropped = 0;
export const droppedSamples = (): number => dropped;

export function trackOf(channel: string, fields: number): Track {
  let track = tracks.get(channel);
  if (!track || track.fields !== fields) tracks.set(channel, (track = new Track(fields)));
  return track;
}

const rowTracks = new Map<string, RowTrack>();
/** What was seen of a channel of rows, for some minutes. */
export function rowsOf(channel: string): RowTrack {
  let track = rowTracks.get(channel);
  if (!track) rowTracks.set(channel, (track = new RowTrack()));
  return track;
}

/** Begins to watch a channel, and gives the end of it. `period`: of a span, s of the cell. */
export function watch(channel: string, period: number): () => void {
  const wish = { channel, period };
  wishes.add(wish);
  tell();
  return () => {
    wishes.delete(wish);
    tell();
  };
}

let told = "", waiting = false;

/** Windows that open and close at once are told of once. */
function tell(): void {
  if (waiting) return;
  waiting = true;
  queueMicrotask(() => {
    waiting = false;
    if (useCell.getState().link !== "ready") return;
    const finest = new Map<string, number>();
    for (const each of wishes) finest.set(each.channel, Math.min(each.period, finest.get(each.channel) ?? Infinity));
    const channels = [...finest].map(([channel, period_s]) => ({ channel, period_s, binary: true }));
    const text = JSON.stringify(channels);
    if (text === told) return;
    told = text;
    call("channels.watch", { channels }).catch(() => (told = ""));
  });
}

async function readChannels(): Promise<void> {
  try {
    useChannels.setState({ channels: await call("channels.list") });
  } catch {
    // It is asked again when the connection is back.
  }
}

onFrame((bytes) => {
  const frame = decode(bytes);
  dropped = frame.dropped;
  if (frame.form === "rows") return rowsOf(frame.channel).put(frame.time_s, frame.rows, frame.numbers);
  if (frame.form === "spans") return trackOf(frame.channel, frame.fields).take(frame.numbers, frame.count);
  if (profiles.length > 0 && frame.time_s < profiles.at(-1)!.time_s) profiles.length = 0;
  if (profiles.length >= most_profiles) profiles.splice(0, most_profiles / 4);
  profiles.push(frame);
  ++profileVersion.count;
});

let epoch = useCell.getState().present?.snapshot.epoch;
useCell.subscribe((state, before) => {
  if (state.link !== "ready" || before.link === "ready") return;
  // Another start of the server: its time begins anew.
  const now = state.present?.snapshot.epoch;
  if (now !== epoch) {
    for (const each of [...tracks.values(), ...rowTracks.values()]) each.clear();
    profiles.length = 0;
    ++profileVersion.count;
    epoch = now;
  }
  told = "";
  void readChannels();
  if (wishes.size > 0) tell();
});
if (useCell.getState().link === "ready") void readChannels();
