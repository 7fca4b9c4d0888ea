// Prints the figures of the page, with the machine: npm run figures -- --page FOLDER --workcell PROGRAM. It asserts nothing:
// a figure depends on the machine, and on what else it does.
import { readFileSync, readdirSync } from "node:fs";
import { cpus, loadavg } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { gzipSync } from "node:zlib";
import type { Browser, Page } from "playwright-core";
import { act, browser, imported, openPage, state } from "../browser/browser";
import { cell, type Cell } from "../browser/cell";
import { noHistory, record, undo, type History } from "../../src/model/history";
import { operationNamed, withOperation } from "../../src/model/operation";
import { randomDrawing, randomEdit, randomOf } from "../unit/random";

const example = readFileSync(join(process.env.WORKSTATION!, "../examples/operations/rub_in_square.op.json"), "utf8");
const say = (what: string, value: string, wanted: string) => console.log(`${what.padEnd(52)} ${value.padStart(20)}   wanted: ${wanted}`);
const at = (sorted: number[], part: number) => sorted[Math.min(sorted.length - 1, Math.floor(sorted.length * part))] ?? NaN;

function bundle(): void {
  const folder = process.env.WORKSTATION_PAGE!, html = readFileSync(join(folder, "index.html"), "utf8");
  const first = [...html.matchAll(/(?:src|href)="([^"]+\.(?:js|css))"/g)].map((each) => each[1]!);
  const size = first.reduce((sum, each) => sum + gzipSync(readFileSync(join(folder, each)), { level: 9 }).length, 0);
  const later = readdirSync(folder).filter((each) => /\.(js|css)$/.test(each) && !first.includes(each)).length;
  say("first bundle, compressed", `${Math.round(size / 1000)} kB, ${later} later`, "under 400 kB");
}

async function ready(from: Browser, served: Cell, when: string): Promise<void> {
  const times: number[] = [];
  for (let i = 0; i < 5; ++i) {
    const page = await openPage(from, "about:blank");
    await page.addInitScript(() => new MutationObserver((_, it) => {
      if (!document.querySelector('[data-offer="skill:touch"]')) return;
      it.disconnect();
      requestAnimationFrame(() => ((window as unknown as { ready: number }).ready = performance.now()));
    }).observe(document, { childList: true, subtree: true }));
    await page.goto(served.url);
    await page.waitForFunction(() => (window as unknown as { ready?: number }).ready !== undefined);
    times.push(await page.evaluate(() => (window as unknown as { ready: number }).ready));
    await page.context().close();
  }
  say(`page ready, ${when}, median of 5`, `${Math.round(at(times.sort((a, b) => a - b), 0.5))} ms`, "under 1000 ms");
}

/** Asked seldom, so that the asking does not count. */
async function untilState(page: Page, wanted: string, longest: number): Promise<void> {
  for (const end = Date.now() + longest; (await state(page).textContent()) !== wanted; await page.waitForTimeout(100)) if (Date.now() > end) throw new Error(`not ${wanted}`);
}

/** From the message with the event to the first frame after the canvas has changed. */
async function colours(from: Browser, served: Cell): Promise<void> {
  const page = await openPage(from, "about:blank");
  await page.addInitScript(() => {
    const scope = window as unknown as { delays: number[]; came?: number | undefined };
    scope.delays = [];
    const Socket = WebSocket;
    window.WebSocket = class extends Socket {
      constructor(address: string | URL) {
        super(address);
        this.addEventListener("message", (message) => {
          if (/"event":\s*"icon"/.test(String(message.data))) scope.came ??= performance.now();
        });
      }
    };
    addEventListener("DOMContentLoaded", () => new MutationObserver(() => {
      const { came } = scope;
      scope.came = undefined;
      if (came !== undefined) requestAnimationFrame(() => scope.delays.push(performance.now() - came));
    }).observe(document.body, { subtree: true, attributes: true, attributeFilter: ["data-run"] }));
  });
  await page.goto(served.url);
  await imported(page, example);
  for (let i = 0; i < 5; ++i) {
    await act(page, "run").click();
    await page.waitForTimeout(300);
    await untilState(page, "Ended", 60000);
  }
  const delays = (await page.evaluate(() => (window as unknown as { delays: number[] }).delays)).sort((a, b) => a - b);
  say(`event → colour, median of ${delays.length}`, `${at(delays, 0.5).toFixed(1)} ms`, "under 30 ms");
  say("event → colour, 99 %", `${at(delays, 0.99).toFixed(1)} ms`, "under 100 ms");
  await page.context().close();
}

async function panning(from: Browser, served: Cell): Promise<void> {
  const icons: Record<string, unknown>[] = [{ id: "start", kind: "start", next: "i0", at: [-160, 0] }];
  for (let i = 0; i < 499; ++i) icons.push({ id: `i${i}`, kind: "skill", skill: "touch", ...(i < 498 ? { next: `i${i + 1}` } : {}), at: [(i % 25) * 264, Math.floor(i / 25) * 136] });
  const page = await openPage(from, served.url);
  await imported(page, JSON.stringify({ "operation-format": 1, name: "many", icons }));
  await page.waitForTimeout(1500);
  const client = await page.context().newCDPSession(page);
  await client.send("Performance.enable");
  const scripting = async () => (await client.send("Performance.getMetrics")).metrics.find((each) => each.name === "ScriptDuration")!.value;
  const gap = await page.evaluate(() => {
    for (let y = 200; y < 700; y += 3) for (let x = 400; x < 900; x += 3) if (document.elementFromPoint(x, y)?.classList.contains("react-flow__pane")) return [x, y] as const;
    return [400, 200] as const;
  });
  const rounds: number[] = [];
  for (let round = 0; round < 3; ++round) {
    await page.mouse.move(...gap);
    await page.mouse.down();
    const began = await scripting();
    for (let i = 1; i <= 40; ++i) await page.mouse.move(gap[0] - i * 4, gap[1] - i * 2);
    rounds.push(((await scripting()) - began) / 40 * 1000);
    await page.mouse.up();
    await page.mouse.move(gap[0] - 160, gap[1] - 80);
    await page.mouse.down();
    await page.mouse.move(...gap, { steps: 10 });
    await page.mouse.up();
  }
  say("500 icons: scripting for a frame of panning", `${at(rounds.sort((a, b) => a - b), 0.5).toFixed(1)} ms`, "under 8 ms");
  await page.context().close();
}

/** A hundred random edits from each of twenty seeds, taken back one by one. */
function undone(): void {
  const seeds = 20;
  let whole = 0;
  for (let seed = 1; seed <= seeds; ++seed) {
    const random = randomOf(seed), place = { path: [], selected: [] };
    const first = randomDrawing(random);
    let drawing = first, history: History = noHistory;
    for (let i = 0; i < 100; ++i) {
      const after = withOperation(drawing, drawing.name, randomEdit(random, operationNamed(drawing, drawing.name)!));
      history = record(history, { label: "edit.add", before: drawing, after, placeBefore: place, placeAfter: place });
      drawing = after;
    }
    for (let step = undo(history); step; step = undo(history)) ({ history, entry: { before: drawing } } = step);
    if (JSON.stringify(drawing) === JSON.stringify(first)) ++whole;
  }
  say("undo of 100 random edits gives the first bytes", `${whole} of ${seeds}`, "all");
}

test("figures", async () => {
  console.log(`${cpus()[0]?.model ?? "?"}, ${cpus().length} processors, load ${loadavg()[0]!.toFixed(1)}, node ${process.version}`);
  const [chromium, served] = await Promise.all([browser(), cell("touch")]);
  console.log(`chromium ${chromium.version()}`);
  try {
    bundle();
    undone();
    // A cell that has just begun still proves its skills: once meanwhile, and once when it has rested.
    await ready(chromium, served, "while the cell proves");
    await new Promise((resolve) => setTimeout(resolve, 30_000));
    await ready(chromium, served, "afterwards");
    await colours(chromium, served);
    await panning(chromium, served);
  } finally {
    await chromium.close();
    await served.end();
  }
});
