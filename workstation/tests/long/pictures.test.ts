// The pictures of docs/workstation/figures.md: PICTURES=FOLDER npm run test:long -- pictures, with --page and --workcell.
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser, Locator, Page } from "playwright-core";
import { act, browser, icon, imported, openPage, shot, untilState } from "../browser/browser";
import { cell, type Cell } from "../browser/cell";

let chromium: Browser;
before(async () => void (chromium = await browser()));
after(() => chromium.close());

const example = (name: string) => readFileSync(join(process.env.WORKSTATION!, "../examples/operations", `${name}.op.json`), "utf8");
const folder = process.env.PICTURES;
const part = async (of: Locator, name: string) => void (folder && (await of.screenshot({ path: join(folder, `${name}.png`) })));

async function at(scene: string, options: readonly string[], what: (page: Page, served: Cell) => Promise<void>): Promise<void> {
  const served = await cell(scene, options);
  const page = await openPage(chromium, served.url, { viewport: { width: 1280, height: 800 } });
  try {
    await page.locator('[data-offer="start"]').waitFor();
    await what(page, served);
  } finally {
    await page.context().close();
    await served.end();
  }
}

test("the cell touch", () => at("touch", ["--paced", "2"], async (page) => {
  await imported(page, example("rub_in_square"));
  await shot(page, "figure-5-7-operation");
  await part(page.locator(".palette"), "figure-4-9-palette");
  await icon(page, "found").dblclick({ position: { x: 60, y: 8 } });
  await part(page.locator('[data-window="icon"]'), "figure-4-6-case");
  await page.locator('[data-window="icon"] .window-head button').click();
  await icon(page, "rub-in-square").click();
  await page.keyboard.press("Control+ArrowDown");
  await icon(page, "side-1").waitFor();
  await page.waitForTimeout(400);
  await shot(page, "figure-5-8-inside");
  await part(icon(page, "side-2"), "figure-4-3-icon");
  await icon(page, "side-1").locator('.connector.out[data-handleid="next"]').hover();
  await icon(page, "side-1").dblclick({ position: { x: 60, y: 8 } });
  await part(page.locator('[data-window="icon"]'), "figure-4-7-dialog");
  await page.locator('[data-window="icon"] .window-foot button').first().click();
  await page.locator('[data-window="skill"] table').first().waitFor();
  await shot(page, "figure-5-9-stacked");
  await part(page.locator('[data-window="skill"]'), "figure-4-8-help");
  await page.keyboard.press("Escape");
  await page.locator('[data-window="icon"] .window-head button').click();
  await act(page, "run").click();
  await untilState(page, "Running");
  await page.waitForFunction(() => document.querySelector('.icon[data-id="side-2"]')?.getAttribute("data-run") === "acting", undefined, { timeout: 60000 });
  await shot(page, "figure-4-16-running");
  await act(page, "stop").click();
  await untilState(page, "Stopped");
  await page.locator(".go-on .choices li").first().waitFor();
  await shot(page, "stopped");
}));

test("a fault", () => at("touch", ["--fast"], async (page) => {
  const side = (id: string, direction: number, distance: number, next: string, x: number) => ({ id, kind: "skill", skill: "rub", parameters: { direction, distance }, next, at: [x, 0] });
  await imported(page, JSON.stringify({ "operation-format": 1, name: "rub-in-square", icons: [
    { id: "start", kind: "start", next: "find", at: [0, 0] }, { id: "find", kind: "skill", skill: "touch", next: "side-1", at: [168, 0] },
    side("side-1", 0, 20, "side-2", 416), side("side-2", 90, 2, "done", 664), { id: "done", kind: "exit", at: [912, 0] },
  ] }));
  await act(page, "run").click();
  await untilState(page, "Failed");
  await page.locator(".go-on .choices li").first().waitFor();
  await page.waitForTimeout(400);
  await shot(page, "fault");
}));

test("the cell delivery", () => at("delivery-middle", ["--fast"], async (page) => {
  await page.getByRole("button", { name: "Show or hide the palette" }).click();
  await imported(page, example("pick_by_identity"));
  await shot(page, "figure-4-14-pick-by-identity");
  await imported(page, example("pick_and_place"));
  await shot(page, "figure-4-13-pick-and-place");
}));

const view = async (page: Page, name: string): Promise<void> => {
  await page.getByRole("button", { name: "Windows on the cell" }).click();
  await page.getByRole("menuitem", { name }).click();
};

test("what the sensors see", () => at("seam", ["--paced", "3"], async (page) => {
  await imported(page, example("follow_edge_again"));
  await shot(page, "figure-5-29-follow-edge");
  await icon(page, "follow").dblclick({ position: { x: 60, y: 8 } });
  await part(page.locator('[data-window="icon"]'), "figure-5-28-dialog");
  await page.locator('[data-window="icon"] .window-head button').click();
  await view(page, "Range profile");
  const profile = page.locator('[data-about="profile"]');
  await act(page, "run").click();
  await profile.locator('[data-mark="edge"]').first().waitFor();
  await profile.getByRole("button", { name: "Hold still" }).click();
  await part(profile, "figure-5-22-profile");
  await act(page, "stop").click();
  await untilState(page, "Stopped");
}));

test("the cell in three dimensions", () => at("pallet", ["--paced", "3"], async (page) => {
  await imported(page, JSON.stringify({
    "operation-format": 1, name: "pick one", icons: [
      { id: "start", kind: "start", next: "pick" }, { id: "pick", kind: "skill", skill: "pick-at-location", parameters: { location: "PART1" }, next: "end", error: "end" }, { id: "end", kind: "exit" }],
  }));
  await view(page, "The cell in 3-D");
  await page.waitForFunction(() => document.querySelector<HTMLElement>(".scene-frame")?.dataset["tip"] !== undefined);
  await act(page, "run").click();
  await untilState(page, "Ended", 60000);
  await page.waitForTimeout(500);
  const scene = page.locator('[data-window="scene"]');
  await part(scene, "cell-scene");
  await page.locator('[data-act="scene.replay"]').click();
  const slider = page.getByRole("slider", { name: "Instant of the run" });
  await slider.focus();
  await page.keyboard.press("End");
  await page.keyboard.press("PageDown");
  await page.locator('[data-act="scene.follow"]').click();
  await page.waitForTimeout(800);
  await part(scene, "cell-scene-replay");
}));
