// Prints what live windows cost, and asserts nothing: a figure depends on the machine. All windows on the cell are open while
// an operation runs at the cell's own pace. MINUTES=N: how long memory is watched (the test "memory"), in time of the cell. PACE=N: the cell is
// N times as quick, and so is what it sends; MINUTES=60 PACE=3 shows an hour in twenty minutes.
import { readFileSync } from "node:fs";
import { cpus, loadavg } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser, CDPSession, Page } from "playwright-core";
import { act, browser, imported, openPage, state } from "../browser/browser";
import { cell, type Cell } from "../browser/cell";

const minutes = Number(process.env.MINUTES ?? 2), pace = Number(process.env.PACE ?? 1);
const example = readFileSync(join(process.env.WORKSTATION!, "../examples/operations/rub_in_square.op.json"), "utf8");
const flat = ["Force", "Position of the tool", "Joints", "Requirements", "Sensors"], windows = [...flat, "The cell in 3-D"];
const say = (what: string, value: string, wanted: string) => console.log(`${what.padEnd(58)} ${value.padStart(24)}   wanted: ${wanted}`);
const at = (values: readonly number[], part: number) => [...values].sort((a, b) => a - b)[Math.min(values.length - 1, Math.floor(values.length * part))] ?? NaN;

interface Seen {
  /** Of each message with forces: from its coming, and from its last sample, to the frame that shows it; ms. */
  came: number[];
  sampled: number[];
  /** Messages of poses. */
  poses: { count: number; bytes: number };
  frames: number;
}

/** Notes in the page when messages come and when the frame after them is there. */
function listen(): void {
  const scope = window as unknown as { seen: Seen };
  const seen: Seen = (scope.seen = { came: [], sampled: [], poses: { count: 0, bytes: 0 }, frames: 0 });
  /** Of the wall clock when the cell's time was 0, ms. A cell at its own pace is never early, so the least is the best. */
  let began = Infinity;
  const shown = (then: () => void) => requestAnimationFrame(() => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = then;
    port2.postMessage(0);
  });
  const Socket = WebSocket;
  window.WebSocket = class extends Socket {
    constructor(address: string | URL) {
      super(address);
      this.addEventListener("message", ({ data }) => {
        if (typeof data === "string") {
          const { params } = JSON.parse(data);
          if (params?.wall && typeof params.time_s === "number") began = Math.min(began, Date.parse(params.wall) - params.time_s * 1000);
          return;
        }
        const now = performance.now(), length = new DataView(data).getUint32(0, true);
        const head = JSON.parse(new TextDecoder().decode(new Uint8Array(data, 4, length)));
        if (head.channel === "poses") (++seen.poses.count, (seen.poses.bytes += data.byteLength));
        if (head.channel !== "force" || !head.spans) return;
        const numbers = new Float64Array(data, 4 + length), last = numbers[(head.spans - 1) * (3 + 3 * head.fields) + 1]!;
        shown(() => {
          const then = performance.now();
          seen.came.push(then - now);
          if (began < Infinity) seen.sampled.push(performance.timeOrigin + then - began - last * 1000);
        });
      });
    }
  };
  const count = () => (++seen.frames, requestAnimationFrame(count));
  requestAnimationFrame(count);
}

async function opened(from: Browser, served: Cell, shown: readonly string[]): Promise<Page> {
  const page = await openPage(from, "about:blank");
  await page.addInitScript(listen);
  await page.goto(served.url);
  await imported(page, example);
  for (const name of shown) {
    await page.getByRole("button", { name: "Windows on the cell" }).click();
    await page.locator(".menu-item", { has: page.locator(".name", { hasText: new RegExp(`^${name}$`) }) }).click();
  }
  await page.waitForTimeout(2000);
  return page;
}

const seen = (page: Page) => page.evaluate(() => (window as unknown as { seen: Seen }).seen);

async function until(page: Page, wanted: string): Promise<void> {
  for (let i = 0; i < 1200 && (await state(page).textContent()) !== wanted; ++i) await page.waitForTimeout(100);
}

async function metric(client: CDPSession, name: string): Promise<number> {
  return (await client.send("Performance.getMetrics")).metrics.find((each) => each.name === name)!.value;
}

const resident = (pid: number) => Number(/VmRSS:\s+(\d+)/.exec(readFileSync(`/proc/${pid}/status`, "utf8"))![1]) / 1024;

let chromium: Browser, served: Cell;
before(async () => {
  console.log(`${cpus()[0]?.model ?? "?"}, ${cpus().length} processors, load ${loadavg()[0]!.toFixed(1)}`);
  [chromium, served] = await Promise.all([browser(), cell("touch", ["--paced", String(pace)])]);
  // A cell that has just begun still proves its skills.
  await new Promise((resolve) => setTimeout(resolve, 30_000));
});
after(async () => {
  await chromium.close();
  await served.end();
});

for (const shown of [["Force"], flat, windows])
  test(shown.length === 1 ? "a chart alone" : shown === flat ? "all windows but the cell in 3-D" : "all windows", async (about) => {
    const page = await opened(chromium, served, shown), client = await page.context().newCDPSession(page);
    await client.send("Performance.enable");
    await act(page, "run").click();
    await until(page, "Running");
    const before = await seen(page), script = await metric(client, "ScriptDuration"), began = Date.now();
    await page.waitForTimeout(8000);
    const scripting = (await metric(client, "ScriptDuration")) - script, { came, sampled, poses, frames } = await seen(page), seconds = (Date.now() - began) / 1000;
    console.log(`${about.name} (${shown.join(", ")}):`);
    say(`a message with forces → pixel, median of ${came.length - before.came.length}`, `${at(came.slice(before.came.length), 0.5).toFixed(0)} ms`, "");
    say("the last sample in it → pixel, median", `${at(sampled.slice(before.sampled.length), 0.5).toFixed(0)} ms`, "under 50 ms");
    say(`scripting for a frame, ${(((frames - before.frames)) / seconds).toFixed(0)} frames a second`, `${((scripting / (frames - before.frames)) * 1000).toFixed(1)} ms`, "under 8 ms");
    if (poses.count > before.poses.count) say(`poses of all bodies, ${((poses.count - before.poses.count) / seconds).toFixed(0)} a second`, `${((poses.bytes - before.poses.bytes) / seconds / 1000).toFixed(1)} kB/s`, "under 100 kB/s at 30 a second");
    if (shown === windows) console.log(`  the cell in 3-D: pixels for one of the screen, and ms a picture: ${await page.locator(".scene-frame").getAttribute("data-fineness")}`);
    await until(page, "Ended");
    await page.context().close();
  });

test("memory", async () => {
  const page = await opened(chromium, served, windows), client = await page.context().newCDPSession(page);
  await client.send("Performance.enable");
  const heap = async () => {
    await client.send("HeapProfiler.collectGarbage");
    return (await metric(client, "JSHeapUsedSize")) / 1e6;
  };
  const told: string[] = [];
  for (let minute = 0; minute <= minutes; ++minute) {
    if (minute % Math.max(1, Math.floor(minutes / 12)) === 0) told.push(`${minute} min: page ${(await heap()).toFixed(1)} MB, server ${resident(served.pid).toFixed(0)} MiB`);
    for (const end = Date.now() + 60_000 / pace; minute < minutes && Date.now() < end; await page.waitForTimeout(500))
      // By script: a busy computer may take longer to bring a click by the mouse than the run takes.
      if (/^(Ended|Ready|Idle)/.test((await state(page).textContent()) ?? "")) await act(page, "run").evaluate((button: HTMLElement) => button.click());
  }
  console.log(`all windows at full rate while rub in a square runs again and again:\n  ${told.join("\n  ")}`);
  await page.context().close();
});
