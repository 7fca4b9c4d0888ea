// What the sensors saw: charts with the limits of parameters, the range profile with what is seen in it, the gauges of
// requirements, readings. All while a real cell works.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser, BrowserContextOptions, Page } from "playwright-core";
import { noViolation } from "../browser/axe";
import { act, browser, errors, imported, openPage, shot, untilState } from "../browser/browser";
import { cell, type Cell } from "../browser/cell";

let chromium: Browser;
before(async () => void (chromium = await browser()));
after(() => chromium.close());

const example = (name: string) => readFileSync(join(process.env.WORKSTATION!, "../examples/operations", `${name}.op.json`), "utf8");

async function within(scene: string, pace: readonly string[], operation: string, options: BrowserContextOptions, what: (page: Page, served: Cell) => Promise<void>): Promise<void> {
  const served = await cell(scene, pace);
  const page = await openPage(chromium, served.url, options);
  try {
    await page.locator('[data-offer="start"]').waitFor({ state: "attached" });
    await imported(page, example(operation));
    await what(page, served);
    assert.deepEqual(errors.get(page), []);
  } catch (problem) {
    await shot(page, "failed-see");
    throw problem;
  } finally {
    await page.context().close();
    await served.end();
  }
}

async function view(page: Page, name: string): Promise<void> {
  await page.getByRole("button", { name: "Windows on the cell" }).click();
  await page.locator(".menu-item", { has: page.locator(".name", { hasText: new RegExp(`^${name}$`) }) }).click();
}

const windowOf = (page: Page, kind: string, about = "") => page.locator(`[data-window="${kind}"]${about === "" ? "" : `[data-about="${about}"]`}`);

/** What the window saves as a file. */
async function saved(page: Page, window: ReturnType<typeof windowOf>, as: string): Promise<string> {
  await window.getByRole("button", { name: "Save" }).click();
  const [file] = await Promise.all([page.waitForEvent("download"), page.getByRole("menuitem", { name: as }).click()]);
  return readFileSync((await file.path())!, "utf8");
}

/** Moves a window by its head, so that pictures show all of them. */
async function put(page: Page, window: ReturnType<typeof windowOf>, x: number, y: number): Promise<void> {
  const head = (await window.locator(".window-head h2").boundingBox())!;
  await page.mouse.move(head.x + 4, head.y + 8);
  await page.mouse.down();
  const box = (await window.boundingBox())!;
  await page.mouse.move(x + head.x + 4 - box.x, y + head.y + 8 - box.y, { steps: 2 });
  await page.mouse.up();
}

async function forces(page: Page, name: string): Promise<void> {
  await view(page, "Force");
  const force = windowOf(page, "channel", "force");
  await force.locator(".chart-tools").waitFor();
  await view(page, "Requirements");
  const gauges = windowOf(page, "gauges");
  // The newest lies on top, and may hide the other's head.
  await put(page, gauges, 720, 76);
  await put(page, force, 8, 76);
  await act(page, "run").click();
  // Rubbing presses: the chart's value of fz says so while it comes.
  await page.waitForFunction(() => Number(document.querySelector('[data-about="force"] [data-field="fz"] b')?.textContent?.replace("−", "-")) < -2);
  await force.getByRole("button", { name: "Hold still" }).click();
  await force.locator(".chart[data-held]").waitFor();
  await gauges.locator(".gauge", { hasText: "stops" }).waitFor();
  await page.waitForFunction(() => [...document.querySelectorAll('[data-window="gauges"] .gauge-now')].some((each) => /\d/.test(each.textContent ?? "")));
  await shot(page, `${name}-force-and-gauges`);
  if (name !== "tablet") await noViolation(page, `${name}, force and gauges`);
}

test("force against time with the limits that parameters set, held, zoomed, saved", () => within("touch", ["--paced", "1"], "rub_in_square", { bypassCSP: true }, async (page) => {
  await forces(page, "light");
  const force = windowOf(page, "channel", "force");
  // A stretch is drawn out with the mouse: the chart shows less time then.
  const over = (await force.locator(".u-over").first().boundingBox())!;
  const span = () => force.locator(".chart-span").textContent();
  const before = await span();
  await page.mouse.move(over.x + over.width * 0.08, over.y + 40);
  await page.mouse.down();
  await page.mouse.move(over.x + over.width * 0.98, over.y + 40, { steps: 4 });
  await page.mouse.up();
  await page.waitForFunction((was) => document.querySelector('[data-about="force"] .chart-span')?.textContent !== was, before);
  await shot(page, "light-force-zoomed");
  const svg = await saved(page, force, "Picture (SVG)");
  for (const each of ["greatest-force", "least-force", "fz"]) assert.ok(svg.includes(each), `${each} is in the picture`);
  const rows = (await saved(page, force, "Numbers (CSV)")).trim().split("\n");
  assert.equal(rows[0]!.split(",").length, 19);
  assert.ok(rows.length > 20, `${rows.length} rows`);
  for (const row of rows.slice(1)) {
    const [, ...values] = row.split(",").map(Number);
    for (let i = 0; i < 6; ++i) assert.ok(values[3 * i]! <= values[3 * i + 2]! && values[3 * i + 2]! <= values[3 * i + 1]!, row);
  }
  // The cursor's instant is written with its values.
  // Near the end: the page may know little more than the run.
  await page.mouse.move(over.x + over.width * 0.8, over.y + 40);
  await page.waitForFunction(([first, last]) => {
    const at = Number(document.querySelector('[data-about="force"] .chart-time')?.textContent?.replace(/[^\d.]/g, ""));
    return at > first! && at < last! - 0.5;
  }, [Number(rows[1]!.split(",")[0]), Number(rows.at(-1)!.split(",")[0])]);
  await force.getByRole("button", { name: "Follow again" }).click();
  await force.locator(".chart:not([data-held])").waitFor();
  await untilState(page, "Ended", 60000);
}));

test("a gauge shows what is measured beside what is proved, and opens its chart", () => within("touch", ["--paced", "6"], "rub_in_square", { bypassCSP: true, colorScheme: "dark" }, async (page, served) => {
  await forces(page, "dark");
  await windowOf(page, "gauges").locator(".select-button").click();
  await page.getByRole("option", { name: /^rub/ }).click();
  await page.waitForFunction(() => [...document.querySelectorAll('[data-window="gauges"] .gauge')].some((each) => /^stops.*now [\d.]+ ms.*worst so far [\d.]+ ms.*limit 45/.test(each.textContent ?? "")));
  // Proofs come while the server serves: the bound is there, or is told as being proved.
  const text = (await windowOf(page, "gauges").locator(".gauge", { hasText: "fresh-force" }).textContent())!;
  const figure = (name: string) => Number(new RegExp(`${name} ([\\d.]+) ms`).exec(text)?.[1]);
  const [now, worst, bound, limit] = ["now", "worst so far", "proved", "limit"].map(figure) as [number, number, number, number];
  assert.ok(now <= worst && worst <= limit && limit === 10, text);
  assert.ok(Number.isNaN(bound) ? text.includes("being proved") : worst <= bound && bound <= limit, text);
  await windowOf(page, "gauges").locator(".gauge", { hasText: "fresh-force" }).click();
  const chart = windowOf(page, "requirement", "rub/fresh-force");
  await chart.locator(".u-over").first().waitFor();
  await put(page, chart, 8, 300);
  await shot(page, "dark-requirement");
  await noViolation(page, "dark, requirement");
  assert.ok(served.token !== "");
}));

test("the range profile with the edge in it, and what was before", () => within("seam", ["--paced", "3"], "follow_edge_again", { bypassCSP: true }, async (page) => {
  await view(page, "Range profile");
  const profile = windowOf(page, "channel", "profile");
  await profile.locator(".nothing").waitFor();
  await act(page, "run").click();
  await profile.locator('[data-mark="edge"]').first().waitFor();
  await profile.locator(".profile-limit", { hasText: "standoff" }).waitFor();
  await page.waitForFunction(() => Number(document.querySelector<HTMLInputElement>(".profile-back input")?.max) > 20);
  await shot(page, "light-profile");
  await noViolation(page, "profile");
  await profile.getByRole("button", { name: "Hold still" }).click();
  const time = () => profile.locator(".profile-reading b").textContent();
  const held = await time();
  await profile.locator(".profile-back input").focus();
  for (let i = 0; i < 5; ++i) await page.keyboard.press("ArrowLeft");
  await page.waitForFunction((was) => document.querySelector(".profile-reading b")?.textContent !== was, held);
  assert.match(await saved(page, profile, "Picture (SVG)"), /<svg[^>]*xmlns/);
  const rows = (await saved(page, profile, "Numbers (CSV)")).trim().split("\n");
  assert.ok(rows.length > 100 && rows[0] === "y (mm),z (mm)");
  await act(page, "stop").click();
  await untilState(page, "Stopped");
  // The run again: the profile of an instant, from what the server kept, with the limit that held then.
  await view(page, "The cell in 3-D");
  await page.locator('[data-act="scene.replay"]').click();
  await profile.locator(".chart-replayed").waitFor();
  const slider = page.getByRole("slider", { name: "Instant of the run" });
  await slider.focus();
  await page.keyboard.press("End");
  for (let i = 0; i < 30; ++i) await page.keyboard.press("ArrowLeft");
  await profile.locator(".profile-reading", { hasText: "points of the run" }).waitFor();
  await profile.locator(".profile-limit", { hasText: "standoff" }).waitFor();
  assert.ok(((await profile.locator(".profile-points").getAttribute("d")) ?? "").length > 500);
  await shot(page, "light-profile-again");
}));

test("sensors that tests read, and joints, on a tablet", () => within("touch", ["--fast"], "rub_in_square", { bypassCSP: true, viewport: { width: 1024, height: 768 }, hasTouch: true, isMobile: true }, async (page) => {
  await view(page, "Sensors");
  const sensors = windowOf(page, "sensors");
  const first = sensors.locator("li").first();
  await first.getByRole("button").click();
  await page.waitForFunction(() => /\d/.test(document.querySelector(".sensor-value")?.textContent ?? ""));
  await shot(page, "tablet-sensors");
  await view(page, "Joints");
  await windowOf(page, "channel", "joints").locator(".chart-tools").waitFor();
  await act(page, "run").click();
  await untilState(page, "Ended");
  await page.waitForFunction(() => /\d/.test(document.querySelector('[data-about="joints"] [data-field="j1"] b')?.textContent ?? ""));
  await shot(page, "tablet-joints");
  await noViolation(page, "tablet");
}));
