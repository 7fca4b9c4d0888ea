// Three people at one cell, each with the page alone: the first teaches, tunes and saves; the second runs it as an operator,
// until something goes wrong; the third looks at that run again, and can say which sensor saw what, and when.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import { act, browser, drawing, errors, field, icon, imported, openPage, shot, untilState } from "../browser/browser";
import { cell, type Cell } from "../browser/cell";
import { record } from "./recording";

let chromium: Browser, served: Cell;
before(async () => {
  [chromium, served] = await Promise.all([browser(), cell("touch", ["--paced", "4"])]);
});
after(async () => {
  await chromium.close();
  await served.end();
});

const operation = JSON.stringify({
  "operation-format": 1, name: "polish", icons: [
    { id: "start", kind: "start", next: "go", at: [0, 24] },
    { id: "go", kind: "skill", skill: "move-to-location", next: "find", error: "failed", at: [160, 0] },
    { id: "find", kind: "skill", skill: "touch", parameters: { "approach-speed": 10 }, next: "polish", error: "failed", at: [420, 0] },
    { id: "polish", kind: "skill", skill: "rub", parameters: { distance: 2, speed: 0.5, "greatest-force": -300, "least-force": -200 }, next: "lift", error: "failed", at: [680, 0] },
    { id: "lift", kind: "skill", skill: "relative-move", parameters: { dz: -20 }, next: "done", error: "failed", at: [940, 0] },
    { id: "done", kind: "exit", at: [1200, 24] }, { id: "failed", kind: "exit", code: 1, at: [1200, 200] },
  ],
});

const url = (role: string) => `${served.address}/#token=${JSON.parse(readFileSync(join(served.folder, "workcell.json"), "utf8")).tokens[role]}`;
const dialog = (page: Page) => page.locator('[data-window="icon"]');

async function as(role: string, name: string, what: (page: Page) => Promise<void>): Promise<void> {
  const page = await openPage(chromium, url(role));
  const end = await record(page, `people-${name}`);
  try {
    await what(page);
    assert.deepEqual(errors.get(page), []);
  } catch (problem) {
    await shot(page, `failed-people-${name}`);
    throw problem;
  } finally {
    await end();
    await page.context().close();
  }
}

async function view(page: Page, name: string): Promise<void> {
  await page.getByRole("button", { name: "Windows on the cell" }).click();
  await page.locator(".menu-item", { has: page.locator(".name", { hasText: new RegExp(`^${name}$`) }) }).click();
}

test("the first teaches, tunes, sets free and saves", () => as("programmer", "first", async (page) => {
  await page.locator('[data-offer="skill:rub"]').waitFor();
  await imported(page, operation);
  await view(page, "Locations");
  const locations = page.locator('[data-window="locations"]');
  await page.getByRole("button", { name: "Move z by −10 mm", exact: true }).click();
  await page.waitForFunction(() => document.querySelector(".state-headline")?.textContent === "Idle" && [...document.querySelectorAll<HTMLButtonElement>(".step-axis button")].every((each) => !each.disabled));
  await locations.getByRole("textbox", { name: "New name" }).fill("BEGIN");
  await page.getByRole("button", { name: "Teach BEGIN here" }).click();
  await locations.locator('[data-location="BEGIN"]').waitFor();
  await locations.getByRole("button", { name: /Close/ }).click();
  await icon(page, "go").dblclick({ position: { x: 90, y: 12 } });
  await dialog(page).locator(".field", { has: page.getByText("location", { exact: true }) }).locator(".select-button").first().click();
  await page.getByRole("option", { name: "BEGIN" }).click();
  await dialog(page).locator(".window-head button").click();
  await act(page, "run").click();
  await untilState(page, "Ended", 60000);

  await icon(page, "polish").click({ button: "right", position: { x: 90, y: 12 } });
  await page.getByRole("menuitem", { name: "Tune…" }).click();
  const tuning = page.locator('[data-window="tuning"]');
  const study = (name: string) => tuning.locator(".aside-study").getByRole("textbox", { name });
  await tuning.getByRole("button", { name: /Parameter/ }).last().click();
  await page.getByRole("option", { name: "greatest-force", exact: true }).click();
  await study("From").fill("-300");
  await study("To").fill("-220");
  await study("Values").fill("3");
  await page.keyboard.press("Tab");
  await tuning.getByRole("button", { name: "Try", exact: true }).click();
  await page.locator('[data-row="aside.3"]').waitFor({ timeout: 120000 });
  await tuning.getByRole("button", { name: "Take the parameters of aside.3 into the icon" }).click();
  assert.equal((await drawing(page)).icons.find((each) => each.id === "polish")!.parameters!["greatest-force"], -220);
  await tuning.locator(".window-head button").click();

  await icon(page, "polish").dblclick({ position: { x: 90, y: 12 } });
  await dialog(page).getByRole("button", { name: "distance: locked for operators" }).click();
  await field(page, "distance, at least").fill("1");
  await field(page, "distance, at most").fill("30");
  await page.keyboard.press("Tab");
  await dialog(page).locator(".window-head button").click();
  await page.keyboard.press("Control+s");
  await page.locator(".modal").getByRole("textbox").fill("polish");
  await page.locator(".modal").getByRole("button", { name: "Save" }).click();
  await page.locator(".notice", { hasText: "polish" }).waitFor();
}));

test("the second runs it as an operator, once well, and once too far", () => as("operator", "second", async (page) => {
  await page.getByRole("button", { name: "polish", exact: true }).click();
  const distance = page.locator('[data-icon="polish"]').getByRole("textbox", { name: "distance", exact: true });
  await distance.waitFor();
  await act(page, "run").click();
  await untilState(page, "Ended", 60000);
  assert.equal(await page.locator(".locked, .operator-icon").count() > 0, true);
  await distance.fill("25");
  await page.keyboard.press("Tab");
  await act(page, "run").click();
  await page.getByText("the surface has ended: nothing was felt for 140 ms").first().waitFor({ timeout: 90000 });
  await page.waitForTimeout(500);
}));

test("the third looks at the run again, and says which sensor saw what, and when", () => as("programmer", "third", async (page) => {
  await page.locator('[data-offer="skill:rub"]').waitFor();
  // The page has come late, and still says why.
  await page.getByText("the surface has ended: nothing was felt for 140 ms").first().waitFor();
  await page.locator(".go-on-head button").click();
  await view(page, "The cell in 3-D");
  await view(page, "Force");
  await page.locator('[data-act="scene.replay"]').click();
  await page.locator('[data-about="force"] .chart-replayed').waitFor();
  const slider = page.getByRole("slider", { name: "Instant of the run" });
  const first = Number(await slider.getAttribute("min")), last = Number(await slider.getAttribute("max"));
  const to = async (time: number) => {
    await slider.evaluate((input: HTMLInputElement, value) => {
      Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")!.set!.call(input, String(value));
      input.dispatchEvent(new Event("input", { bubbles: true }));
    }, time);
    await page.waitForFunction((wanted) => Math.abs(Number(document.querySelector<HTMLElement>(".scene-frame")!.dataset["time"]) - wanted) < 0.011, time);
  };
  const force = async () => Number((await page.locator('[data-about="force"] [data-field="fz"] b').textContent())!.replace("−", "-"));
  const acting = () => page.locator(".scene-acting").textContent();
  // While the tool rubs, the sensor feels the plate; at some instant of the same icon it feels nothing any more.
  let pressed = NaN, nothing = NaN;
  for (let time = first + 0.2; time < last; time += Math.max(0.1, (last - first) / 120)) {
    await to(time);
    if ((await acting()) !== "polish") continue;
    const now = await force();
    if (now < -5) pressed = time;
    if (now > -1 && pressed < time && Number.isNaN(nothing)) nothing = time;
    if (now < -5) nothing = NaN;
  }
  assert.ok(pressed > first && nothing > pressed, `the plate was felt until ${pressed} s, and not from ${nothing} s on`);
  await to(nothing);
  await page.waitForTimeout(400);
  await shot(page, "people-cause");
  console.log(`force fz: pressed until ${(pressed - first).toFixed(1)} s of the run, nothing from ${(nothing - first).toFixed(1)} s on, while polish acted`);
}));
