// The cell as this page knows it: the connection, what happens there, and what it has.
import { create } from "zustand";
import type { Event, Location, Sensor, Skill, Stored } from "../../generated/protocol";
import { Broken, Connection, Refused, type MethodName, type Params, type Result } from "../protocol/connection";
import { takeToken, webSocketAddress } from "../protocol/token";
import { begin, happened, type Present } from "./happened";

export type Link = "connecting" | "ready" | "away" | "no-token" | "ended";

export interface Cell {
  link: Link;
  /** When the next attempt is made, by this machine's clock in ms. */
  again: number;
  present: Present | undefined;
  skills: ReadonlyMap<string, Skill>;
  sensors: readonly Sensor[];
  locations: readonly Location[] | undefined;
  stored: readonly Stored[] | undefined;
}

export const useCell = create<Cell>()(() => ({
  link: "connecting",
  again: 0,
  present: undefined,
  skills: new Map(),
  sensors: [],
  locations: undefined,
  stored: undefined,
}));

type Seen = (event: Event) => void;
const seen = new Set<Seen>();
/** Told of each event after the state has it. */
export function onEvent(listener: Seen): () => void {
  seen.add(listener);
  return () => seen.delete(listener);
}

/** Live data, of whoever asked for it; nobody does before its windows are opened. */
let framed: ((bytes: ArrayBuffer) => void) | undefined;
export function onFrame(listener: (bytes: ArrayBuffer) => void): void {
  framed = listener;
}

let connection: Connection | undefined;
let token = "";

export function call<M extends MethodName>(method: M, params?: Params<M>): Promise<Result<M>> {
  return connection ? connection.call(method, params) : Promise.reject(new Broken("not connected"));
}

/** A request that can be given up: what it answers then is `cancelled`. */
export function beginCall<M extends MethodName>(method: M, params: Params<M>): { answer: Promise<Result<M>>; cancel(): void } {
  if (!connection) return { answer: Promise.reject(new Broken("not connected")), cancel: () => {} };
  const { id, answer } = connection.begin(method, params);
  return { answer, cancel: () => void connection?.call("cancel", { request: id }).catch(() => {}) };
}

const name = () => {
  const browser = /Firefox|Edg|Chrom|Safari/.exec(navigator.userAgent)?.[0] ?? "browser";
  return sessionStorage.getItem("workcell-name") ?? `${browser === "Edg" ? "Edge" : browser === "Chrom" ? "Chrome" : browser}`;
};

async function welcome(): Promise<void> {
  if (!connection) return;
  const patience = setTimeout(() => connection?.drop(), 8000);
  const former = useCell.getState().present?.snapshot;
  try {
    const greeted = connection.call("hello", { token, name: name() });
    // Asked in the same breath: the page has them one round sooner. Without a token they are refused, and give nothing.
    const read = Promise.all([readSkills(), readSensors(), readLocations(), readStore()]);
    const snapshot = await greeted;
    // What this page saw stays (the ways that the token took), if nothing was missed.
    const watched = await connection.call("watch", { since: snapshot.last_event, epoch: snapshot.epoch });
    const present = begin(watched.snapshot ?? snapshot, Date.now());
    const before = useCell.getState().present;
    const same = former?.epoch === snapshot.epoch && former.operation === snapshot.operation;
    clearTimeout(patience);
    connection.settled();
    useCell.setState({ link: "ready", present: same && before ? { ...present, taken: before.taken } : present });
    await read;
  } catch (problem) {
    clearTimeout(patience);
    if (problem instanceof Refused && problem.code === 1) {
      connection.end();
      useCell.setState({ link: "no-token" });
    } else if (!(problem instanceof Broken)) {
      throw problem;
    }
  }
}

/** Methods that this server does not offer give nothing. */
async function offered<T>(answer: Promise<T>): Promise<T | undefined> {
  try {
    return await answer;
  } catch (problem) {
    if (problem instanceof Broken || problem instanceof Refused) return undefined;
    throw problem;
  }
}

async function readSkills(): Promise<void> {
  const skills = await offered(call("skills"));
  if (skills) useCell.setState({ skills: new Map(skills.map((each) => [each.skill, each])) });
}
async function readSensors(): Promise<void> {
  const sensors = await offered(call("sensors"));
  if (sensors) useCell.setState({ sensors });
}
export async function readLocations(): Promise<void> {
  useCell.setState({ locations: await offered(call("locations.list")) });
}
export async function readStore(): Promise<void> {
  useCell.setState({ stored: await offered(call("store.list")) });
}

function notified(method: string, params: unknown): void {
  if (method !== "event") return;
  const event = params as Event;
  const { present } = useCell.getState();
  if (present && event.number > present.snapshot.last_event)
    useCell.setState({ present: happened(present, event, Date.now()) });
  if (event.event === "stored") void readStore();
  if (event.event === "location") void readLocations();
  if (event.event === "loaded") void refreshLoaded();
  for (const each of seen) each(event);
}

/** The files of what somebody has loaded are in the snapshot alone. */
async function refreshLoaded(): Promise<void> {
  const snapshot = await offered(call("snapshot"));
  const { present } = useCell.getState();
  if (snapshot && present) useCell.setState({ present: { ...present, snapshot: { ...present.snapshot, loaded: snapshot.loaded } } });
}

export function connect(): void {
  token = takeToken();
  if (token === "") return useCell.setState({ link: "no-token" });
  connection?.end();
  connection = new Connection(webSocketAddress(), {
    opened: () => void welcome(),
    closed: (again) => {
      if (useCell.getState().link !== "no-token") useCell.setState({ link: "away", again: Date.now() + again });
    },
    notified,
    bytes: (bytes) => framed?.(bytes),
  });
  connection.open();
}
