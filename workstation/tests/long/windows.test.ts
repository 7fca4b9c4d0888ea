// Every window in light and dark, at 1280×800 with a mouse and at a tablet's 1024×768 by touch: axe-core finds nothing in it, and
// with PICTURES=FOLDER a picture of each is kept, for people to look at. Windows of a drawing at 1280×800 are in tests/browser/look.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser, BrowserContextOptions, Page } from "playwright-core";
import { noViolation } from "../browser/axe";
import { act, browser, errors, icon, imported, openPage, shot, untilState } from "../browser/browser";
import { cell, type Cell } from "../browser/cell";
import { tour } from "../browser/tour";

let chromium: Browser;
before(async () => void (chromium = await browser()));
after(() => chromium.close());

const example = (name: string) => readFileSync(join(process.env.WORKSTATION!, "../examples/operations", `${name}.op.json`), "utf8");
const desk: BrowserContextOptions = { viewport: { width: 1280, height: 800 } };
const tablet: BrowserContextOptions = { viewport: { width: 1024, height: 768 }, hasTouch: true, isMobile: true };

async function within(name: string, options: BrowserContextOptions, scene: string, pace: readonly string[], what: (page: Page, served: Cell) => Promise<void>): Promise<void> {
  const served = await cell(scene, pace);
  const page = await openPage(chromium, served.url, { bypassCSP: true, ...options });
  try {
    await page.locator('[data-offer="start"]').waitFor({ state: "attached" });
    await what(page, served);
    assert.deepEqual(errors.get(page), []);
  } catch (problem) {
    await shot(page, `failed-windows-${name}`);
    throw problem;
  } finally {
    await page.context().close();
    await served.end();
  }
}

async function seen(page: Page, name: string, part = ".window"): Promise<void> {
  await shot(page, name);
  await noViolation(page, name, part);
}

async function view(page: Page, name: string): Promise<void> {
  await page.getByRole("button", { name: "Windows on the cell" }).click();
  await page.locator(".menu-item", { has: page.locator(".name", { hasText: new RegExp(`^${name}$`) }) }).click();
}

const close = (page: Page) => page.locator(".window .window-head button").last().click();

/** The cell touch: what stands while it runs, after a stop, after a fault, and all windows on the cell. */
async function touching(page: Page, name: string, served: Cell): Promise<void> {
  await seen(page, `${name}-empty`, "body");
  await imported(page, example("rub_in_square"));
  await page.getByRole("button", { name: "Settings" }).click();
  await seen(page, `${name}-settings`, ".popover");
  await page.keyboard.press("Escape");
  await page.locator(".controls").click();
  await seen(page, `${name}-controls`, ".popover");
  await page.keyboard.press("Escape");
  await page.getByRole("button", { name: "Windows on the cell" }).click();
  await seen(page, `${name}-views`, ".popover");
  await page.keyboard.press("Escape");
  for (const window of ["Requirements", "Sensors", "Locations", "Production"]) {
    await view(page, window);
    await page.locator(".window").last().waitFor();
    await seen(page, `${name}-${window.toLowerCase()}-first`);
    await close(page);
  }
  await act(page, "run").click();
  await page.locator('.icon[data-run="acting"]').first().waitFor();
  await seen(page, `${name}-running`, "body");
  await act(page, "pause").click();
  await untilState(page, "Paused", 60000);
  await seen(page, `${name}-paused`, "body");
  await act(page, "resume").click();
  await untilState(page, "Ended", 60000);
  for (const window of ["Requirements", "Force", "Joints", "Sensors", "Production"]) {
    await view(page, window);
    await page.locator(".window").last().waitFor();
    await page.waitForTimeout(400);
    await seen(page, `${name}-${window.toLowerCase()}`);
    if (window === "Requirements") {
      await page.locator(".gauge button, button.gauge").first().click();
      await page.locator('[data-window="requirement"] .chart-tools').waitFor();
      await seen(page, `${name}-requirement`);
      await close(page);
    }
    await close(page);
  }
  await imported(page, example("rub_in_square").replaceAll('"distance": 2', '"distance": 30'));
  await act(page, "run").click();
  await page.locator(".go-on .choices li").first().waitFor({ timeout: 60000 });
  await seen(page, `${name}-fault`, "body");
  await served.kill();
  await untilState(page, "Connection lost");
  await seen(page, `${name}-away`, "body");
}

async function others(page: Page, name: string): Promise<void> {
  await imported(page, example("follow_edge_again"));
  await view(page, "Range profile");
  await seen(page, `${name}-profile-first`);
  await act(page, "run").click();
  await page.locator('[data-about="profile"] [data-mark="edge"]').first().waitFor();
  await page.getByRole("button", { name: "Hold still" }).click();
  await seen(page, `${name}-profile`);
  await act(page, "stop").click();
  await untilState(page, "Stopped");
  await close(page);
  await seen(page, `${name}-stopped`, "body");
  await page.locator(".go-on-head button").click();
  await icon(page, "follow").click({ button: "right", position: { x: 60, y: 10 } });
  await page.getByRole("menuitem", { name: "Tune…" }).click();
  await page.locator('[data-window="tuning"] table').first().waitFor();
  await seen(page, `${name}-tuning`);
}

for (const [name, options] of [["desk-light", desk], ["desk-dark", { ...desk, colorScheme: "dark" }], ["tablet-light", tablet], ["tablet-dark", { ...tablet, colorScheme: "dark" }]] as const) {
  test(`${name}: the windows on the cell`, () => within(name, options, "touch", ["--paced", "8"], (page, served) => touching(page, name, served)));
  test(`${name}: the range profile, a stop, tuning`, () => within(name, options, "seam", ["--paced", "3"], (page) => others(page, name)));
  if (name.startsWith("tablet"))
    test(`${name}: the windows of a drawing`, () => within(name, options, "touch", ["--fast"], async (page) => {
      await imported(page, example("rub_in_square"));
      await tour(page, name);
    }));
}
