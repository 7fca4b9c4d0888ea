// Operations of the thesis, drawn from an empty canvas and run to their ends in the workcell.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import { act, browser, drawing, drop, errors, field, icon, insert, line, openPage, shot, untilState } from "./browser";
import { cell } from "./cell";

let chromium: Browser;
before(async () => void (chromium = await browser()));
after(() => chromium.close());

/** Places an icon, names it and sets its numbers in its dialog. */
async function dialog(page: Page, id: string, name: string, numbers: Record<string, string> = {}): Promise<void> {
  await icon(page, id).dblclick({ position: { x: 90, y: 12 } });
  for (const [label, value] of Object.entries(numbers)) await field(page, label).fill(value);
  if (name !== id) await field(page, "Name").fill(name);
  await page.keyboard.press("Tab");
  await page.locator('[data-window="icon"] .window-head button').click();
}

test("rub in a square, by mouse", async () => {
  const served = await cell("touch");
  const page = await openPage(chromium, served.url);
  try {
    await page.locator('[data-offer="skill:rub"]').waitFor();
    await page.getByRole("button", { name: "Hide this panel" }).click();
    await drop(page, "start", 40, 80);
    await drop(page, "skill:touch", 290, 80);
    await drop(page, "case", 540, 80);
    await page.locator(".zoom").waitFor();
    await line(page, "start", "next", "touch");
    await line(page, "touch", "next", "case");
    for (const [i, direction] of [0, 90, 180, 270].entries()) {
      await drop(page, "skill:rub", 140 + i * 250, 340);
      await dialog(page, "rub", `side-${i + 1}`, { direction: String(direction), distance: "2", speed: "0.5" });
    }
    await drop(page, "skill:relative-move", 850, 500);
    await dialog(page, "relative-move", "lift", { dz: "-20" });
    await drop(page, "exit", 850, 180);
    await dialog(page, "done", "failed", { Code: "2" });
    await drop(page, "exit", 560, 520);
    await line(page, "case", "way:0", "side-1");
    await line(page, "case", "default", "failed");
    await line(page, "case", "way:1", "failed");
    for (let i = 1; i < 4; ++i) {
      await line(page, `side-${i}`, "next", `side-${i + 1}`);
      await line(page, `side-${i}`, "error", "failed");
    }
    await line(page, "side-4", "next", "lift");
    await line(page, "side-4", "error", "failed");
    await line(page, "lift", "next", "done");
    await line(page, "lift", "error", "failed");
    await shot(page, "drawn-by-mouse");
    const drawn = await drawing(page);
    assert.equal(drawn.icons.length, 10);
    await page.locator(".state-findings").waitFor({ state: "detached" });
    await act(page, "run").click();
    await untilState(page, "Ended");
    assert.match((await page.locator(".state-detail").textContent())!, /code 0/);
    assert.equal(await icon(page, "side-4").getAttribute("data-run"), "passed");
    await shot(page, "run-to-its-end");
    assert.deepEqual(errors.get(page), []);
  } catch (problem) {
    await shot(page, "failed-draw");
    throw problem;
  } finally {
    await page.context().close();
    await served.end();
  }
});

test("the same by keyboard alone", async () => {
  const served = await cell("touch");
  const page = await openPage(chromium, served.url);
  const rename = async (name: string, numbers: Record<string, string> = {}) => {
    await page.keyboard.press("Enter");
    await page.locator('[data-window="icon"]').waitFor();
    for (const [label, value] of Object.entries(numbers)) {
      // Tab leads through the fields in their order.
      for (let i = 0; i < 60; ++i) {
        if (await field(page, label).evaluate((each) => each === document.activeElement)) break;
        await page.keyboard.press("Tab");
      }
      await page.keyboard.press("Control+a");
      await page.keyboard.type(value);
    }
    for (let i = 0; i < 60 && !(await field(page, "Name").evaluate((each) => each === document.activeElement)); ++i) await page.keyboard.press("Shift+Tab");
    await page.keyboard.press("Control+a");
    await page.keyboard.type(name);
    await page.keyboard.press("Tab");
    await page.keyboard.press("Escape");
    await page.locator('[data-window="icon"]').waitFor({ state: "detached" });
    await icon(page, name).waitFor();
  };
  try {
    await page.locator('[data-offer="skill:rub"]').waitFor();
    await page.locator(".canvas").focus();
    await insert(page, "start");
    await insert(page, "touch");
    for (const [i, direction] of [0, 90, 180, 270].entries()) {
      await insert(page, "rub");
      await rename(`side-${i + 1}`, { direction: String(direction), distance: "2" });
      await page.locator(`.icon[data-id="side-${i + 1}"]:focus`).waitFor();
    }
    await insert(page, "relative-move");
    await rename("lift", { dz: "-20" });
    await insert(page, "exit");
    // Another exit for what goes wrong, by the list "connect to…".
    await page.keyboard.press("ArrowLeft");
    await insert(page, "exit");
    await rename("failed");
    for (const id of ["side-4", "side-3", "side-2", "side-1", "touch"]) {
      await icon(page, id).focus();
      await page.keyboard.press("Control+l");
      await icon(page, "failed").focus();
      await page.keyboard.press("Control+Enter");
    }
    const drawn = await drawing(page);
    assert.deepEqual(drawn.icons.map((each) => each.id), ["start", "touch", "side-1", "side-2", "side-3", "side-4", "lift", "done", "failed"]);
    for (const each of drawn.icons) if (each.kind === "skill") assert.ok(each.next && each.error, each.id);
    await shot(page, "drawn-by-keyboard");
    await page.keyboard.press("F5");
    await untilState(page, "Ended");
    assert.equal(await icon(page, "side-4").getAttribute("data-run"), "passed");
  } catch (problem) {
    await shot(page, "failed-draw");
    throw problem;
  } finally {
    await page.context().close();
    await served.end();
  }
});
