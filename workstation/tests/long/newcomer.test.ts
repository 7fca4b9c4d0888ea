// The walk of somebody who has only the page: "rub in a square" is made from an empty canvas, runs, is stopped by a fault, its
// cause is found, a parameter is changed, and it ends.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import { act, browser, errors, field, icon, openPage, shot, untilState } from "../browser/browser";
import { cell } from "../browser/cell";

let chromium: Browser;
before(async () => void (chromium = await browser()));
after(() => chromium.close());

test("by mouse", async () => {
  const served = await cell("touch", ["--paced", "8"]);
  const page = await openPage(chromium, served.url, { viewport: { width: 1280, height: 800 } });
  let n = 0;
  const look = (what: string) => shot(page, `walk-${String(++n).padStart(2, "0")}-${what}`);
  try {
    await page.locator('[data-offer="skill:rub"]').waitFor();
    await look("empty");
    await page.getByRole("button", { name: "Place START" }).click();
    await look("start");
    for (const name of ["touch", "rub", "rub", "rub", "rub", "relative-move", "exit"]) await page.getByRole("button", { name: `Add ${name}`, exact: true }).click();
    await page.waitForTimeout(500);
    await look("chain");
    for (const [id, direction] of [["rub", "0"], ["rub-2", "90"], ["rub-3", "180"], ["rub-4", "270"]] as const) {
      await icon(page, id).dblclick({ position: { x: 60, y: 12 } });
      await field(page, "direction").fill(direction);
      await field(page, "distance").fill(id === "rub" ? "20" : "2");
      if (id === "rub-2") await look("dialog");
      await page.locator('[data-window="icon"] .window-head button').click();
    }
    await page.waitForTimeout(500);
    await look("numbers");
    await act(page, "run").click();
    await page.waitForTimeout(600);
    await look("running");
    await untilState(page, "Failed", 30000);
    await page.waitForTimeout(600);
    await look("fault");
    await page.getByRole("button", { name: "Open rub and change it" }).click();
    await page.locator('[data-window="icon"]').waitFor();
    await page.waitForTimeout(300);
    await field(page, "distance").fill("2");
    await look("change");
    await page.locator('[data-window="icon"] .window-head button').click();
    await page.getByRole("button", { name: "Begin at START" }).click();
    await page.waitForTimeout(1000);
    await untilState(page, "Ended", 60000);
    await look("end");
  } catch (problem) {
    await shot(page, "failed-walk");
    throw problem;
  } finally {
    await page.context().close();
    await served.end();
  }
});
