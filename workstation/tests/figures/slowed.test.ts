// Prints what open pages and trials cost the simulation, and asserts nothing: a figure depends on the machine. The cell has one processor,
// everything else the other. Runs without and with pages alternate in one cell, so that the machine's moods meet both.
// ROUNDS=N: pairs of runs of a replayed line; --only chooses lines. Quiet machines need some 40 pairs for a figure of 1 %.
import { spawn, spawnSync, type ChildProcess } from "node:child_process";
import { readFileSync } from "node:fs";
import { cpus, loadavg } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import { browser, openPage } from "../browser/browser";
import { cell, type Cell } from "../browser/cell";
import { lightClient, type LightClient } from "./client";

const rounds = Number(process.env.ROUNDS ?? 12);
const example = readFileSync(join(process.env.WORKSTATION!, "../examples/operations/rub_in_square.op.json"), "utf8");
const sleep = (ms: number) => new Promise((resolve) => setTimeout(resolve, ms));
const pin = (pid: number, processors: number | string) => void spawnSync("taskset", ["-acp", String(processors), String(pid)]);
const median = (values: readonly number[]) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)]!;

/** What a page sends: when it opens, and, by the time since the run's begin, while it looks at a run. */
interface Sent {
  opening: string[];
  running: { after: number; text: string }[];
}

interface Driver {
  client: LightClient;
  ask(method: string, params?: unknown): Promise<void>;
  /** The number of the event that it heard last. */
  last(): number;
}

async function driver(served: Cell): Promise<Driver> {
  const client = await lightClient(served.port, true);
  let id = 0, last = 0;
  void client.next(({ params }) => ((last = params?.number ?? last), false));
  const ask = async (method: string, params: unknown = {}) => {
    const mine = ++id, answer = client.next((message) => message.id === mine);
    client.send(JSON.stringify({ jsonrpc: "2.0", id: mine, method, params }));
    const { error } = await answer;
    if (error) throw new Error(`${method}: ${error.message}`);
  };
  await ask("hello", { token: served.token, name: "driver" });
  await ask("watch");
  await ask("controls.take");
  await ask("operation.load", { main: "drawing.op.json", files: { "drawing.op.json": example } });
  return { client, ask, last: () => last };
}

/** Processor time of the simulation's thread, of the whole program, and time on the wall, for one run: in seconds. */
async function run({ client, ask }: Driver, served: Cell): Promise<[number, number, number]> {
  const before = served.processorTime(), all = served.allProcessorTime(), began = performance.now();
  const ended = client.next((message) => message.params?.event === "state" && message.params.state === "ended");
  await ask("operation.run");
  await ended;
  const wall = (performance.now() - began) / 1000;
  return [served.processorTime() - before, served.allProcessorTime() - all, wall];
}

async function page(from: Browser, served: Cell, windows: readonly string[], sends: (text: string) => void = () => {}): Promise<Page> {
  const opened = await openPage(from, "about:blank");
  opened.on("websocket", (socket) => socket.on("framesent", ({ payload }) => sends(String(payload))));
  await opened.goto(served.url);
  await opened.locator('[data-offer="skill:touch"]').waitFor({ state: "attached" });
  for (const name of windows) {
    await opened.getByRole("button", { name: "Windows on the cell" }).click();
    await opened.locator(".menu-item", { has: opened.locator(".name", { hasText: new RegExp(`^${name}$`) }) }).click();
  }
  await opened.waitForTimeout(500);
  return opened;
}

/** What a page sends while it opens and looks at one run. */
async function recorded(from: Browser, served: Cell, by: Driver, windows: readonly string[]): Promise<Sent> {
  const sent: Sent = { opening: [], running: [] };
  let began = 0;
  const opened = await page(from, served, windows, (text) => void (began === 0 ? sent.opening.push(text) : sent.running.push({ after: performance.now() - began, text })));
  began = performance.now();
  await run(by, served);
  await opened.context().close();
  return sent;
}

interface Guests {
  /** Comes, and is settled when it resolves. */
  come(): Promise<void>;
  begun(): void;
  go(): Promise<number>;
}

/** A page asks for what it has not heard, which is nothing when it opens. */
const present = (text: string) => (text.includes('"method":"watch"') ? text.replace(/"since":\d+/, `"since":${by.last()}`) : text);

const replayed = (served: Cell, sent: Sent): Guests => {
  let clients: LightClient[] = [];
  return {
    come: async () => {
      clients = await Promise.all([lightClient(served.port), lightClient(served.port)]);
      for (const each of clients) for (const text of sent.opening) each.send(present(text));
      await sleep(250);
    },
    begun: () => {
      for (const each of clients) for (const { after, text } of sent.running) setTimeout(() => each.send(text), after);
    },
    go: async () => {
      const bytes = clients.reduce((sum, each) => sum + each.bytes(), 0);
      await Promise.all(clients.map((each) => each.close()));
      return bytes;
    },
  };
};

const real = (from: Browser, served: Cell, windows: readonly string[]): Guests => {
  let pages: Page[] = [];
  return {
    come: async () => void (pages = [await page(from, served, windows), await page(from, served, windows)]),
    begun: () => {},
    go: async () => {
      for (const each of pages) await each.context().close();
      return 0;
    },
  };
};

/** Pages of another cell, which does the same at the same time: what a browser takes from this machine, and not from the cell. */
const elsewhere = (from: Browser): Guests => {
  let other: Cell, there: Driver, pages: Page[] = [];
  return {
    come: async () => {
      if (!other) {
        other = await cell("touch");
        pin(other.pid, 1);
        there = await driver(other);
      }
      pages = [await page(from, other, []), await page(from, other, [])];
    },
    begun: () => void run(there, other),
    go: async () => {
      for (const each of pages) await each.context().close();
      return 0;
    },
  };
};

const busy = (): Guests => {
  let spinning: ChildProcess | undefined;
  return {
    come: async () => {
      spinning = spawn(process.execPath, ["-e", "for (const many = new Float64Array(1 << 20); ;) for (let i = 0; i < many.length; ++i) many[i] += i"]);
      await sleep(200);
    },
    begun: () => {},
    go: async () => {
      spinning?.kill("SIGKILL");
      return 0;
    },
  };
};

/** Trials aside, one after the other. */
const trials = (): Guests => {
  let client: LightClient, ends = Promise.resolve(), gone = false, made = 0;
  const tryAgain = async () => {
    for (let id = 2; !gone; ++id, ++made) {
      const answer = client.next((message) => message.id === id);
      client.send(JSON.stringify({ jsonrpc: "2.0", id, method: "study.try", params: { skill: "touch" } }));
      const { error } = await answer;
      if (error) throw new Error(error.message);
    }
  };
  return {
    come: async () => {
      gone = false;
      client = await lightClient(served.port, true);
      client.send(JSON.stringify({ jsonrpc: "2.0", id: 1, method: "hello", params: { token: served.token, name: "trials" } }));
      ends = tryAgain();
      await sleep(200);
    },
    begun: () => {},
    go: async () => {
      gone = true;
      await ends;
      await client.close();
      if (made === 0) throw new Error("no trial was made");
      return 0;
    },
  };
};

async function compared(what: string, guests: Guests, times: number): Promise<void> {
  const without: [number, number, number][] = [], together: [number, number, number][] = [];
  let bytes = 0;
  const alone = async () => {
    await sleep(100);
    without.push(await run(by, served));
  };
  const watched = async () => {
    await guests.come();
    const going = run(by, served);
    guests.begun();
    together.push(await going);
    bytes = await guests.go();
  };
  // Both orders by turns.
  for (let i = 0; i < times; ++i) for (const each of i % 2 === 0 ? [alone, watched] : [watched, alone]) await each();
  /** How much more each run with guests took than its neighbour without: the median, and the middle half in brackets. */
  const more = (k: 0 | 1 | 2) => {
    const all = together.map((each, i) => (each[k] / without[i]![k] - 1) * 100).sort((a, b) => a - b), at = (part: number) => all[Math.floor((all.length - 1) * part)]!.toFixed(1);
    return `${at(0.5)} % (${at(0.25)} to ${at(0.75)})`;
  };
  console.log(`${what}, ${times} pairs of runs, each of ${median(without.map((each) => each[0])).toFixed(2)} s${bytes > 0 ? `, ${Math.round(bytes / 2000)} kB to each page` : ""}
  simulation's thread ${more(0)}; whole program ${more(1)}; time on the wall ${more(2)}`);
}

let chromium: Browser, served: Cell, by: Driver;
before(async () => {
  pin(process.pid, 1);
  console.log(`${cpus()[0]?.model ?? "?"}, ${cpus().length} processors, load ${loadavg()[0]!.toFixed(1)}, wanted: under 1 %`);
  [chromium, served] = await Promise.all([browser(), cell("touch")]);
  pin(served.pid, 0);
  by = await driver(served);
  await run(by, served);
  // A cell that has just begun still proves its skills.
  await sleep(30_000);
});
after(async () => {
  await by.client.close();
  await chromium.close();
  await served.end();
});

for (const [name, windows] of [
  ["two pages", []],
  ["two pages with force and requirements", ["Force", "Requirements"]],
  ["two pages with all windows", ["Force", "Position of the tool", "Joints", "Requirements", "Sensors", "The cell in 3-D"]],
] as const) {
  test(`${name}, replayed by light clients`, async (about) => compared(about.name, replayed(served, await recorded(chromium, served, by, windows)), rounds));
  test(`${name}, in a browser`, (about) => compared(about.name, real(chromium, served, windows), Math.ceil(rounds / 4)));
}
test("two pages of another cell, in a browser", (about) => compared(about.name, elsewhere(chromium), Math.ceil(rounds / 4)));
// What the machine itself does: the other processor is busy, and nobody talks with the cell.
test("no page, the other processor is busy", (about) => compared(about.name, busy(), Math.ceil(rounds / 2)));
test("trials aside, one after the other; the cell has both processors", async (about) => {
  pin(served.pid, "0,1");
  await compared(about.name, trials(), rounds);
  pin(served.pid, 0);
});
