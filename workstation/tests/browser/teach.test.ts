// Teaching: the arm is moved by steps, locations are taught, compared, gone to, renamed and deleted; a pallet, and a
// place square on a surface, from three corners; and a dialog takes the place where the robot is.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser, BrowserContextOptions, Page } from "playwright-core";
import { noViolation } from "./axe";
import { browser, drawing, drop, errors, icon, openPage, shot } from "./browser";
import { cell } from "./cell";

let chromium: Browser;
before(async () => void (chromium = await browser()));
after(() => chromium.close());

const locations = (page: Page) => page.locator('[data-window="locations"]');
const row = (page: Page, name: string) => locations(page).locator(`[data-location="${name}"]`);
const idle = (page: Page) => page.waitForFunction(() => [...document.querySelectorAll<HTMLButtonElement>(".step-axis button")].every((each) => !each.disabled));

async function step(page: Page, label: string): Promise<void> {
  await page.getByRole("button", { name: label, exact: true }).click();
  await page.waitForFunction(() => document.querySelector(".state-headline")?.textContent !== "Skill runs alone");
  await idle(page);
}

async function teach(page: Page, name: string): Promise<void> {
  await locations(page).getByRole("textbox", { name: "New name" }).fill(name);
  await page.getByRole("button", { name: `Teach ${name} here` }).click();
  await row(page, name).waitFor();
}

async function within(options: BrowserContextOptions, what: (page: Page) => Promise<void>): Promise<void> {
  const served = await cell("pallet", ["--fast"]);
  const page = await openPage(chromium, served.url, { bypassCSP: true, ...options });
  try {
    await page.locator('[data-offer="skill:relative-move"]').waitFor({ state: "attached" });
    await page.getByRole("button", { name: "Windows on the cell" }).click();
    await page.getByRole("menuitem", { name: "Locations" }).click();
    await idle(page);
    await what(page);
    assert.deepEqual(errors.get(page), []);
  } catch (problem) {
    await shot(page, "failed-teach");
    throw problem;
  } finally {
    await page.context().close();
    await served.end();
  }
}

const place = async (page: Page, name: string) => (await row(page, name).locator(".location-place").textContent())!.replaceAll("−", "-").replaceAll(",", "").trim().split(/\s+/).map(Number);

test("three corners by steps become a pallet", () => within({}, async (page) => {
  await step(page, "Move z by −10 mm");
  await teach(page, "C1");
  await locations(page).getByRole("textbox", { name: "Step" }).fill("60");
  await page.keyboard.press("Tab");
  await step(page, "Move x by +60 mm");
  await teach(page, "C2");
  await step(page, "Move x by −60 mm");
  await step(page, "Move y by +60 mm");
  await teach(page, "C3");
  await shot(page, "light-locations");
  await noViolation(page, "locations");
  const [one, two, three] = [await place(page, "C1"), await place(page, "C2"), await place(page, "C3")];
  assert.ok(Math.abs(Math.hypot(...one.map((each, i) => each - two[i]!)) - 60) < 1, `${one} ${two}`);
  await page.getByRole("button", { name: "Pallet from three corners…" }).click();
  const choose = async (label: string, name: string) => {
    await page.locator(".pallet").getByRole("button", { name: label }).click();
    await page.getByRole("option", { name, exact: true }).click();
  };
  await choose("First corner", "C1");
  await choose("End of its row", "C2");
  await choose("End of its column", "C2");
  await page.locator(".pallet .refusal").waitFor();
  await choose("End of its column", "C3");
  await page.locator(".pallet").getByRole("textbox", { name: "Name" }).fill("TRAY");
  await shot(page, "light-pallet");
  await page.getByRole("button", { name: "Teach 9 places" }).click();
  await row(page, "TRAY_3_3").waitFor();
  const middle = await place(page, "TRAY_2_2"), wanted = one.map((each, i) => (two[i]! + three[i]!) / 2 + 0 * each);
  assert.ok(Math.hypot(...middle.map((each, i) => each - wanted[i]!)) < 0.3, `${middle} ${wanted}`);
  // The same corners as a surface, the third one 60 mm higher: the tool leans there by 45 degrees.
  await step(page, "Move z by −60 mm");
  await teach(page, "HIGH");
  await page.getByRole("button", { name: "Square on a surface…" }).click();
  const wizard = page.locator('[data-wizard="surface"]');
  for (const [label, name] of [["First, where it stands", "C1"], ["Second, along x", "C2"], ["Third, beside them", "C2"]] as const) {
    await wizard.getByRole("button", { name: label }).click();
    await page.getByRole("option", { name, exact: true }).click();
  }
  await wizard.locator(".refusal").waitFor();
  await wizard.getByRole("button", { name: "Third, beside them" }).click();
  await page.getByRole("option", { name: "HIGH", exact: true }).click();
  await wizard.locator(".figures").waitFor();
  await shot(page, "light-surface");
  await noViolation(page, "surface");
  await wizard.getByRole("button", { name: "Teach SURFACE" }).click();
  await row(page, "SURFACE").waitFor();
  await row(page, "SURFACE").getByRole("button").first().click();
  const a = Number((await row(page, "SURFACE").locator(".figures").first().locator("dd").nth(4).textContent())!.replace("−", "-").replace("°", ""));
  assert.ok(Math.abs(Math.abs(a) - 45) < 1, `A is ${a}`);
}));

test("go there after the way was tried aside, teach again, rename, delete, and compare", () => within({ colorScheme: "dark" }, async (page) => {
  await teach(page, "HERE1");
  await step(page, "Move z by −10 mm");
  // What was taught last is open.
  await row(page, "HERE1").locator(".differences").waitFor();
  await shot(page, "dark-location");
  await noViolation(page, "location, dark");
  await row(page, "HERE1").getByRole("button", { name: "Go there" }).click();
  await row(page, "HERE1").locator(".location-apart", { hasText: "0.0 mm" }).or(row(page, "HERE1").locator(".location-apart", { hasText: "0.1 mm" })).waitFor({ timeout: 60000 });
  await step(page, "Move y by +10 mm");
  await row(page, "HERE1").getByRole("button", { name: "Teach again here" }).click();
  await row(page, "HERE1").getByRole("button", { name: "Teach again here" }).click();
  await row(page, "HERE1").getByText("version 2").waitFor();
  await row(page, "HERE1").getByRole("button", { name: "Rename" }).click();
  await row(page, "HERE1").getByRole("textbox", { name: "New name" }).fill("THERE");
  await row(page, "HERE1").getByRole("button", { name: "Rename" }).click();
  await row(page, "THERE").getByRole("button", { name: "Delete" }).click();
  await row(page, "THERE").getByRole("button", { name: "Delete" }).click();
  await row(page, "THERE").waitFor({ state: "detached" });
}));

test("Here in a dialog teaches the place and takes it", () => within({ viewport: { width: 1440, height: 900 } }, async (page) => {
  await page.locator('[data-window="locations"] .window-head button').click();
  await drop(page, "start", 40, 120);
  await drop(page, "skill:move-to-location", 260, 120);
  await icon(page, "move-to-location").dblclick({ position: { x: 60, y: 8 } });
  await page.locator('[data-window="icon"]').getByRole("button", { name: "Teach a new location here for location" }).click();
  await page.locator('[data-window="icon"]').getByText("P1").first().waitFor();
  await shot(page, "light-here");
  assert.equal((await drawing(page)).icons.find((each) => each.id === "move-to-location")!.parameters!["location"], "P1");
}));
