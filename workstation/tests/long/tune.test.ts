// Tuning: executions as rows, the same skill tried aside, a row taken back into the icon; then the live cell, by its own
// figures, presses with a force in its band.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import { noViolation } from "../browser/axe";
import { act, browser, drawing, errors, icon, imported, openPage, shot, untilState } from "../browser/browser";
import { cell } from "../browser/cell";

let chromium: Browser;
before(async () => void (chromium = await browser()));
after(() => chromium.close());

/** Touches, then rubs 2 cm with a band whose upper end is to be found. */
const operation = JSON.stringify({
  "operation-format": 1, name: "polish", icons: [
    { id: "start", kind: "start", next: "find", at: [0, 24] },
    { id: "find", kind: "skill", skill: "touch", parameters: { "approach-speed": 10 }, next: "polish", error: "failed", at: [160, 0] },
    { id: "polish", kind: "skill", skill: "rub", parameters: { distance: 2, speed: 0.5, "greatest-force": -300, "least-force": -200 }, next: "lift", error: "failed", at: [420, 0] },
    { id: "lift", kind: "skill", skill: "relative-move", parameters: { dz: -20 }, next: "done", error: "failed", at: [680, 0] },
    { id: "done", kind: "exit", at: [940, 24] }, { id: "failed", kind: "exit", code: 1, at: [940, 200] },
  ],
});

const rows = (page: Page) => page.locator('[data-window="tuning"] tbody tr');
const figure = async (page: Page, row: string, column: string) => Number((await page.locator(`[data-row="${row}"] [data-column="${column}"]`).textContent())!.replace("−", "-").replace(",", ""));

async function tuned(colorScheme: "light" | "dark"): Promise<void> {
  const served = await cell("touch", ["--fast"]);
  const page = await openPage(chromium, served.url, { bypassCSP: true, colorScheme });
  try {
    await page.locator('[data-offer="start"]').waitFor();
    await imported(page, operation);
    await act(page, "run").click();
    await untilState(page, "Ended");
    await icon(page, "polish").click({ button: "right", position: { x: 90, y: 12 } });
    await page.getByRole("menuitem", { name: "Tune…" }).click();
    const tuning = page.locator('[data-window="tuning"]');
    await rows(page).first().waitFor();
    assert.equal(await rows(page).count(), 1);
    assert.equal(await tuning.locator('[data-column="figure:mean-force"]').count(), 1);
    // The greatest age of this run stands beside its bound.
    assert.ok((await figure(page, "1.2", "requirement:fresh-force")) > 0);
    // Five values of the band's upper end, each in a simulator of its own.
    const field = (name: string) => tuning.locator(".aside-study").getByRole("textbox", { name });
    await tuning.getByRole("button", { name: /Parameter/ }).last().click();
    await page.getByRole("option", { name: "greatest-force", exact: true }).click();
    await field("From").fill("-300");
    await field("To").fill("-220");
    await field("Values").fill("3");
    await page.keyboard.press("Tab");
    await tuning.getByRole("button", { name: "Try", exact: true }).click();
    await page.locator('[data-row="aside.3"]').waitFor({ timeout: 60000 });
    assert.equal(await tuning.locator(".point").count(), 4);
    await shot(page, `${colorScheme}-tuning`);
    await noViolation(page, `tuning, ${colorScheme}`);
    // The first trial has the icon's own parameters, and begins where the cell began: it is like the run of the cell.
    assert.ok(Math.abs((await figure(page, "aside.1", "figure:mean-force")) - (await figure(page, "1.2", "figure:mean-force"))) < 1.5);
    // A narrower band presses less hard at its upper end.
    await tuning.getByRole("button", { name: "Take the parameters of aside.3 into the icon" }).click();
    assert.equal((await drawing(page)).icons.find((each) => each.id === "polish")!.parameters!["greatest-force"], -220);
    // Nothing of the live cell has moved meanwhile.
    assert.equal(await page.locator(".state-headline").textContent(), "Ended");
    await act(page, "run").click();
    await page.locator('[data-row^="2."]').waitFor({ timeout: 30000 });
    await untilState(page, "Ended");
    const mean = await figure(page, "2.2", "figure:mean-force");
    // 200 to 220 counts are 10 to 11 N. The regulator may leave the band by the force of one step.
    assert.ok(mean > 9.5 && mean < 11.5, `${mean} N`);
    // Two rows beside each other.
    await page.locator('[data-row="1.2"] .checkbox').click();
    await page.locator('[data-row="2.2"] .checkbox').click();
    await tuning.getByText("Only the 2 chosen").click();
    assert.equal(await rows(page).count(), 2);
    await shot(page, `${colorScheme}-tuning-compared`);
    assert.deepEqual(errors.get(page), []);
  } catch (problem) {
    await shot(page, "failed-tune");
    throw problem;
  } finally {
    await page.context().close();
    await served.end();
  }
}

test("rub is tried aside, taken over, and its force stays in its band", () => tuned("light"));
test("the same in dark, after the cell has been told nothing of the first", () => tuned("dark"));

test("the live cell works while trials go on, and they can be ended", async () => {
  const served = await cell("touch", ["--paced", "2"]);
  const page = await openPage(chromium, served.url);
  try {
    await page.locator('[data-offer="start"]').waitFor();
    await imported(page, operation);
    await icon(page, "polish").click({ button: "right", position: { x: 90, y: 12 } });
    await page.getByRole("menuitem", { name: "Tune…" }).click();
    const tuning = page.locator('[data-window="tuning"]');
    await tuning.getByRole("textbox", { name: "Values" }).fill("50");
    await page.keyboard.press("Tab");
    await tuning.getByRole("button", { name: "Try", exact: true }).click();
    await page.locator('[data-row="aside.1"]').waitFor({ timeout: 60000 });
    await act(page, "run").click();
    await untilState(page, "Running");
    await tuning.getByRole("button", { name: "End", exact: true }).click();
    await tuning.getByRole("button", { name: "Try", exact: true }).waitFor();
    assert.ok((await rows(page).count()) < 50);
    await act(page, "stop").click();
    await untilState(page, "Stopped");
  } finally {
    await page.context().close();
    await served.end();
  }
});
