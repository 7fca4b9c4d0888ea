// The walk of somebody who has only the page: "rub in a square" is made from an empty canvas, runs, is stopped by a fault, its
// cause is found, a parameter is changed, and it ends. By mouse, by finger on a tablet, and by keyboard alone.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser, BrowserContextOptions, Page } from "playwright-core";
import { noViolation } from "../browser/axe";
import { act, browser, drawing, errors, field, icon, insert, openPage, shot, untilState } from "../browser/browser";
import { cell } from "../browser/cell";
import { tabTo } from "../browser/hands";

let chromium: Browser;
before(async () => void (chromium = await browser()));
after(() => chromium.close());

/** Somebody's hand on the page. */
interface Hand {
  begin(page: Page): Promise<void>;
  /** Puts an icon at the end of the line from the one before. */
  add(page: Page, name: string): Promise<void>;
  open(page: Page, id: string): Promise<void>;
  set(page: Page, label: string, value: string): Promise<void>;
  press(page: Page, button: string): Promise<void>;
  run(page: Page): Promise<void>;
}

const button = (page: Page, name: string) => page.getByRole("button", { name, exact: true });

const mouse: Hand = {
  begin: (page) => button(page, "Place START").click(),
  add: (page, name) => button(page, `Add ${name}`).click(),
  open: (page, id) => icon(page, id).dblclick({ position: { x: 40, y: 8 } }),
  set: (page, label, value) => field(page, label).fill(value),
  press: (page, name) => button(page, name).click(),
  run: (page) => act(page, "run").click(),
};

const finger: Hand = {
  begin: (page) => button(page, "Place START").tap(),
  add: (page, name) => button(page, `Add ${name}`).tap(),
  open: async (page, id) => {
    const box = (await icon(page, id).boundingBox())!;
    for (let i = 0; i < 2; ++i) await page.touchscreen.tap(box.x + box.width / 2, box.y + 10);
  },
  set: async (page, label, value) => {
    await field(page, label).tap();
    await field(page, label).fill(value);
  },
  press: (page, name) => button(page, name).tap(),
  run: (page) => act(page, "run").tap(),
};

const keyboard: Hand = {
  begin: async (page) => {
    await tabTo(page, button(page, "Place START"));
    await page.keyboard.press("Enter");
  },
  add: async (page, name) => {
    await insert(page, name);
    await page.locator(".icon:focus").waitFor();
  },
  open: async (page, id) => {
    // The icons of the walk stand in one row.
    for (const key of ["ArrowLeft", "ArrowRight"])
      for (let i = 0; i < 12 && (await page.locator(`.icon[data-id="${id}"]:focus`).count()) === 0; ++i) {
        await page.keyboard.press(key);
        await page.waitForTimeout(60);
      }
    await page.keyboard.press("Enter");
  },
  set: async (page, label, value) => {
    await tabTo(page, field(page, label));
    await page.keyboard.press("Control+a");
    await page.keyboard.type(value);
  },
  press: async (page, name) => {
    if (name.startsWith("Close")) return page.keyboard.press("Escape");
    await tabTo(page, button(page, name));
    await page.keyboard.press("Enter");
  },
  run: (page) => page.keyboard.press("F5"),
};

async function walk(name: string, hand: Hand, options: BrowserContextOptions): Promise<void> {
  const served = await cell("touch", ["--paced", "10"]);
  const page = await openPage(chromium, served.url, { bypassCSP: true, ...options });
  let n = 0;
  const look = async (what: string) => {
    await page.waitForTimeout(250);
    await shot(page, `walk-${name}-${++n}-${what}`);
  };
  try {
    await page.locator('[data-offer="skill:rub"]').waitFor({ state: "attached" });
    await look("empty");
    await hand.begin(page);
    await page.locator(".icon:focus").waitFor();
    for (const each of ["touch", "rub", "rub", "rub", "rub", "relative-move", "exit"]) await hand.add(page, each);
    await look("chain");
    // The first distance is written in millimetres by mistake, and relative-move is to lift.
    for (const [id, values] of [
      ["rub", { distance: "20" }], ["rub-2", { direction: "90", distance: "2" }], ["rub-3", { direction: "180", distance: "2" }],
      ["rub-4", { direction: "270", distance: "2" }], ["relative-move", { dz: "-20" }],
    ] as const) {
      await hand.open(page, id);
      await page.locator('[data-window="icon"]').waitFor();
      for (const [label, value] of Object.entries(values)) await hand.set(page, label, value);
      if (id === "rub-2") await look("dialog");
      await hand.press(page, `Close ${id}`);
      await page.locator('[data-window="icon"]').waitFor({ state: "detached" });
    }
    await hand.run(page);
    await page.locator('.icon[data-id="rub"][data-run="acting"]').waitFor();
    await look("running");
    await untilState(page, "Failed", 30000);
    assert.equal(await page.locator(".go-on .cause").textContent(), "the surface has ended: nothing was felt for 140 ms");
    await look("fault");
    await noViolation(page, `${name}, fault`);
    await hand.press(page, "Open rub and change it");
    await page.locator('[data-window="icon"]').waitFor();
    await hand.set(page, "distance", "2");
    await page.locator(".go-on", { hasText: "First comes rub with distance 2 cm" }).waitFor();
    await look("changed");
    await hand.press(page, "Close rub");
    await hand.press(page, "Begin at START");
    await untilState(page, "Running");
    await untilState(page, "Ended", 30000);
    await look("ended");
    assert.equal(await page.locator(".state-detail").textContent(), "with code 0");
    assert.deepEqual((await drawing(page)).icons.map((each) => each.kind), ["start", "skill", "skill", "skill", "skill", "skill", "skill", "exit"]);
    assert.deepEqual(errors.get(page), []);
  } catch (problem) {
    await shot(page, `failed-walk-${name}`);
    throw problem;
  } finally {
    await page.context().close();
    await served.end();
  }
}

test("by mouse", () => walk("mouse", mouse, { viewport: { width: 1280, height: 800 } }));
test("in the dark, on a wide screen", () => walk("dark", mouse, { viewport: { width: 1440, height: 900 }, colorScheme: "dark" }));
test("by finger on a tablet", () => walk("tablet", finger, { viewport: { width: 1024, height: 768 }, hasTouch: true, isMobile: true }));
test("by keyboard alone", () => walk("keyboard", keyboard, { viewport: { width: 1280, height: 800 } }));
