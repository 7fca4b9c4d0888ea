// Icons that stand for others: collapse, show what is inside, expand, copies between operations; run from an icon; what the
// cell lacks and what a skill refuses, at the icon.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import { browser, drawing, errors, field, icon, imported, openPage, shot, untilState } from "./browser";
import { cell, type Cell } from "./cell";

let chromium: Browser, served: Cell, page: Page;
before(async () => {
  [chromium, served] = await Promise.all([browser(), cell("touch")]);
  page = await openPage(chromium, served.url);
  await page.locator('[data-offer="skill:touch"]').waitFor();
});
after(async () => {
  assert.deepEqual(errors.get(page), []);
  await chromium.close();
  await served.end();
});

const text = readFileSync(join(process.env.WORKSTATION!, "../examples/operations/rub_in_square.op.json"), "utf8");
const menu = async (id: string, entry: string) => {
  await icon(page, id).click({ button: "right", position: { x: 60, y: 10 } });
  await page.getByRole("menuitem", { name: entry }).click();
};
const shown = () => page.locator(".icon").evaluateAll((all) => all.map((each) => (each as HTMLElement).dataset.id));

test("a selection becomes one icon with a shadow, is opened, and expanded again", async () => {
  await imported(page, text);
  const before = await drawing(page);
  await icon(page, "rub-in-square").click({ position: { x: 60, y: 10 } });
  await icon(page, "lift").click({ position: { x: 60, y: 10 }, modifiers: ["Shift"] });
  await menu("lift", "Collapse into one icon");
  await icon(page, "part").locator(".behind").waitFor();
  await page.locator(".state-findings").waitFor({ state: "detached" });
  await shot(page, "collapsed");
  await menu("part", "Show what is inside");
  await icon(page, "rub-in-square").waitFor();
  assert.ok((await shown()).includes("lift"));
  assert.equal(await page.locator(".trail [aria-current]").textContent(), "part");
  await shot(page, "opened");
  await page.keyboard.press("Control+ArrowUp");
  await icon(page, "part").waitFor();
  await menu("part", "Expand into its icons");
  await icon(page, "lift").waitFor();
  // Undo takes back both, one by one, wherever one looks.
  await page.keyboard.press("Control+z");
  await icon(page, "part").waitFor();
  await page.keyboard.press("Control+z");
  await icon(page, "lift").waitFor();
  assert.deepEqual(await drawing(page), before);
});

test("icons are copied from one operation into another", async () => {
  await icon(page, "lift").click({ position: { x: 60, y: 10 } });
  await page.keyboard.press("Control+c");
  await menu("rub-in-square", "Show what is inside");
  await icon(page, "side-1").waitFor();
  await page.keyboard.press("Control+v");
  await icon(page, "lift").waitFor();
  await page.keyboard.press("Control+z");
  await icon(page, "lift").waitFor({ state: "detached" });
  await page.keyboard.press("Control+ArrowUp");
  await icon(page, "rub-in-square").waitFor();
});

test("run from here begins at the icon", async () => {
  await menu("lift", "Run from here");
  await untilState(page, "Ended");
  assert.equal(await icon(page, "lift").getAttribute("data-run"), "passed");
  assert.equal(await icon(page, "find").getAttribute("data-run"), "none");
});

const only = (skill: string, parameters?: Record<string, number>) => JSON.stringify({
  "operation-format": 1, name: "wrong",
  icons: [{ id: "start", kind: "start", next: "it", at: [0, 0] }, { id: "it", kind: "skill", skill, ...(parameters ? { parameters } : {}), next: "end", error: "end", at: [200, 0] }, { id: "end", kind: "exit", at: [480, 0] }],
});

test("what the cell lacks is told at the icon", async () => {
  await imported(page, only("align"));
  await icon(page, "it").locator(".mark-finding[data-error]").click();
  await page.locator('[data-window="findings"]', { hasText: "it needs the tool range-finder, and the tool of this scene is pad" }).waitFor();
  await shot(page, "lacking");
  await page.locator('[data-window="findings"] .window-head button').click();
});

test("values that the skill refuses together are refused while they are set", async () => {
  await imported(page, only("rub"));
  await icon(page, "it").dblclick({ position: { x: 60, y: 10 } });
  await field(page, "stop-force").fill("100");
  await icon(page, "it").locator(".mark-finding[data-error]").waitFor();
  await page.locator('.inspector .finding[data-severity="error"]', { hasText: "stop-force must be greater than the band's greatest force" }).waitFor();
  await shot(page, "refused-together");
  await field(page, "stop-force").fill("400");
  await icon(page, "it").locator(".mark-finding[data-error]").waitFor({ state: "detached" });
});

test("the longest times of icons and of the whole are shown, and that they are declared", async () => {
  await imported(page, only("touch", { reach: 60, "approach-speed": 20 }));
  // Back and forth at 20 mm/s, and eight seconds until it gives up.
  await icon(page, "it").locator(".caption", { hasText: "≤ 14 s, declared" }).waitFor();
  await page.locator(".state-bounds", { hasText: "14 s" }).click();
  await page.locator('[data-window="ways"]').getByText("All longest times here are declared by the cell").waitFor();
  await shot(page, "declared");
});
