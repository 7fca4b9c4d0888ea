// The present state of the cell, kept up to date by numbered events. A plain function from state and event to
// state: whoever came late or lost the connection begins with a snapshot and goes on from its number.
import type { Event, IconState, Snapshot } from "../../generated/protocol";

export interface IconRun extends IconState {
  reason: string;
  /** When it ended last, in the cell's time. */
  ended_s?: number;
  took_s?: number;
}

export interface Present {
  snapshot: Snapshot;
  /** By path: "rub-in-square/side-1". */
  runs: ReadonlyMap<string, IconRun>;
  /** Lines that the token took, "from>to" by path. */
  taken: ReadonlySet<string>;
  /** When what runs had begun, by this machine's clock (ms), for the running time on the screen. */
  beganAt: number;
}

export function begin(snapshot: Snapshot, now: number): Present {
  const runs = new Map(snapshot.icons.map((each) => [each.icon, each]));
  const began = snapshot.running ? Date.parse(snapshot.wall) - Date.parse(snapshot.running.begin_wall) : 0;
  return { snapshot, runs, taken: new Set(), beganAt: now - Math.max(0, began) };
}

const folder = (path: string) => path.slice(0, path.lastIndexOf("/") + 1);

/** What stands in that folder and is, or holds, the icon: the token that was inside a part leaves it at the part's own output. */
const besideOf = (icon: string, within: string) => (icon.startsWith(within) ? within + icon.slice(within.length).split("/")[0] : undefined);

function came(present: Present, icon: string, time_s: number, wall: string): Present {
  const { snapshot } = present;
  const runs = new Map(present.runs);
  const before = runs.get(icon);
  runs.set(icon, { ...before, icon, visits: (before?.visits ?? 0) + 1, ends: before?.ends ?? 0, last_s: time_s, reason: "" });
  let taken = present.taken;
  const from = snapshot.here ? besideOf(snapshot.here.icon, folder(icon)) : undefined;
  if (from !== undefined) taken = new Set(taken).add(`${from}>${icon}`);
  return { ...present, runs, taken, snapshot: { ...snapshot, token: icon, here: { icon, since_s: time_s, since: wall } } };
}

type Ends = Extract<Event, { event: "ends" }>;

function ended(present: Present, event: Ends): Present {
  const runs = new Map(present.runs);
  const before = runs.get(event.icon);
  const normal = event.kind === undefined || event.kind === "normal";
  runs.set(event.icon, {
    icon: event.icon,
    visits: before?.visits ?? 1,
    ends: (before?.ends ?? 0) + (normal ? 1 : 0),
    last_s: before?.last_s ?? event.begin_s,
    ...(event.code === undefined ? {} : { code: event.code }),
    ...(event.kind === undefined ? {} : { kind: event.kind }),
    reason: event.reason ?? "",
    ended_s: event.end_s,
    took_s: event.end_s - event.begin_s,
  });
  const last_code = event.icon !== "" && event.code !== undefined ? event.code : present.snapshot.last_code;
  return { ...present, runs, snapshot: { ...present.snapshot, running: null, last_code } };
}

/** `now`: this machine's clock in ms. */
export function happened(present: Present, event: Event, now: number): Present {
  const past = present.snapshot;
  const snapshot: Snapshot = { ...past, last_event: event.number, time_s: event.time_s, wall: event.wall };
  const next = { ...present, snapshot };
  switch (event.event) {
    case "controls":
      return { ...next, snapshot: { ...snapshot, controls: event.holder, yours: event.client === snapshot.client, asking: [],
        clients: snapshot.clients.map((each) => ({ ...each, controls: each.client === event.client })) } };
    case "asked":
      return { ...next, snapshot: { ...snapshot, asking: [...snapshot.asking.filter((each) => each.client !== event.client),
        { client: event.client, name: event.name, reason: event.reason }] } };
    case "clients":
      return { ...next, snapshot: { ...snapshot, clients: event.clients,
        asking: snapshot.asking.filter((each) => event.clients.some((one) => one.client === each.client)) } };
    case "hold":
      return { ...next, snapshot: { ...snapshot, hold: event.hold } };
    case "loaded":
      return { ...next, runs: new Map(), taken: new Set(), snapshot: { ...snapshot, operation: event.operation, state: "ready",
        token: "", reason: "", steps: 0, here: null, running: null, question: null, changed: [], icons: [], breakpoints: [] } };
    case "state": {
      const begins = event.state === "running" && (past.state === "ready" || past.state === "ended" || past.state === "failed");
      const running = event.state === "running";
      return { ...next, ...(begins ? { runs: new Map(), taken: new Set() } : {}), snapshot: { ...snapshot, state: event.state,
        token: event.token, last_code: event.last_code, steps: event.steps, reason: event.reason,
        activity: running ? "operation" : "idle", ...(running ? {} : { pausing: false, stopping: false, running: null }),
        ...(begins ? { here: null } : {}) } };
    }
    case "pausing":
      return { ...next, snapshot: { ...snapshot, pausing: event.pausing, stopping: event.stopping } };
    case "icon":
      return came(next, event.icon, event.time_s, event.wall);
    case "begins":
      return { ...next, beganAt: now, snapshot: { ...snapshot, activity: event.icon === "" ? "skill" : snapshot.activity, steps: event.step,
        running: { ...event, begin_wall: event.wall, alone: event.icon === "" } } };
    case "ends":
      return ended(event.icon === "" ? { ...next, snapshot: { ...snapshot, activity: "idle" } } : next, event);
    case "set":
      return { ...next, snapshot: { ...snapshot, changed: [
        ...snapshot.changed.filter((each) => each.icon !== event.icon || each.parameter !== event.parameter),
        { icon: event.icon, parameter: event.parameter, value: event.value, before: event.before, by: event.by }] } };
    case "breakpoints":
      return { ...next, snapshot: { ...snapshot, breakpoints: event.breakpoints } };
    case "question":
      return { ...next, snapshot: { ...snapshot, question: event.question } };
    case "answered":
      return { ...next, snapshot: { ...snapshot, question: null } };
    default:
      return next;
  }
}
