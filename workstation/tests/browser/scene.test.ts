// The cell in three dimensions: the arm stands in the page where it stands in the cell, the named views come by keys, and a
// run is looked at again by a slider that moves the arm, the cursor of a chart and the mark of the icon that acted.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import { noViolation } from "./axe";
import { act, browser, errors, icon, imported, openPage, shot, untilState } from "./browser";
import { cell } from "./cell";

let chromium: Browser;
before(async () => void (chromium = await browser()));
after(() => chromium.close());

const operation = JSON.stringify({
  "operation-format": 1, name: "up and touch", icons: [
    { id: "start", kind: "start", next: "up" }, { id: "up", kind: "skill", skill: "relative-move", parameters: { dz: -25 }, next: "feel", error: "end" },
    { id: "feel", kind: "skill", skill: "touch", next: "end", error: "end" }, { id: "end", kind: "exit" }],
});

const view = (page: Page) => page.locator(".scene-frame");
const camera = async (page: Page) => (await view(page).getAttribute("data-camera"))!.split(" ").map(Number) as [number, number, number];
const tip = async (page: Page) => (await view(page).getAttribute("data-tip"))!.split(" ").map(Number);
const apart = (a: readonly number[], b: readonly number[]) => Math.hypot(...a.map((each, i) => each - b[i]!));

async function open(page: Page): Promise<void> {
  await page.getByRole("button", { name: "Windows on the cell" }).click();
  await page.getByRole("menuitem", { name: "The cell in 3-D" }).click();
  await page.waitForFunction(() => document.querySelector<HTMLElement>(".scene-frame")?.dataset["tip"] !== undefined);
}

/** Asks the cell by a socket of its own, as any client does. */
async function asked(page: Page, token: string, method: string): Promise<unknown> {
  return page.evaluate(([shown, wanted]) => new Promise((resolve) => {
    const socket = new WebSocket(`ws://${location.host}`);
    const ask = (id: number, name: string, params: object) => socket.send(JSON.stringify({ jsonrpc: "2.0", id, method: name, params }));
    socket.onopen = () => (ask(1, "hello", { token: shown, name: "test", role: "viewer" }), ask(2, wanted!, {}));
    socket.onmessage = ({ data }) => {
      const message = JSON.parse(data);
      if (message.id === 2) (socket.close(), resolve(message.result));
    };
  }), [token, method] as const);
}

test("the cell in 3-D, live and again", async () => {
  const served = await cell("touch", ["--paced", "6"]);
  const page = await openPage(chromium, served.url, { bypassCSP: true });
  try {
    await page.locator('[data-offer="start"]').waitFor({ state: "attached" });
    await imported(page, operation);
    await open(page);
    await page.waitForFunction(() => /Tool: x [\d.−-]+/.test(document.querySelector(".scene-told")?.textContent ?? "") || document.querySelector(".scene-frame")?.hasAttribute("data-time"));
    const began = await tip(page);

    // Views by keys, and by buttons.
    await view(page).focus();
    for (const [key, azimuth, height] of [["1", 0, 4], ["2", 90, 4], ["3", 0, 90], ["4", 38, 26]] as const) {
      await page.keyboard.press(key);
      await page.waitForFunction(([a, h]) => {
        const [x, y] = document.querySelector<HTMLElement>(".scene-frame")!.dataset["camera"]!.split(" ").map(Number);
        return Math.abs(y! - h!) < 0.2 && (h! > 89 || Math.abs(x! - a!) < 0.2);
      }, [azimuth, height] as const);
    }
    const [, , far] = await camera(page);
    await page.keyboard.press("ArrowLeft");
    await page.keyboard.press("+");
    await page.waitForFunction((was) => Number(document.querySelector<HTMLElement>(".scene-frame")!.dataset["camera"]!.split(" ")[2]) < was, far);
    assert.ok(Math.abs((await camera(page))[0] - 32) < 0.2);
    await page.locator('[data-view="iso"]').click();

    // The arm stands in the page where the cell says that it stands.
    await act(page, "run").click();
    await untilState(page, "Ended", 30000);
    await page.getByRole("button", { name: "Windows on the cell" }).click();
    await page.getByRole("menuitem", { name: "Locations" }).click();
    const locations = page.locator('[data-window="locations"]');
    await locations.getByRole("textbox", { name: "New name" }).fill("TOUCHED");
    await locations.getByRole("button", { name: "Teach TOUCHED here" }).click();
    await page.waitForFunction(() => [...document.querySelectorAll(".scene-names [data-kind=location]")].some((each) => each.textContent?.includes("TOUCHED")));
    const places = (await asked(page, served.token, "scene.locations")) as { location: string; position: number[] }[];
    const taught = places.find((each) => each.location === "TOUCHED")!.position;
    // A busy computer draws it later.
    for (let i = 0; i < 100 && apart(await tip(page), taught) >= 0.0006; ++i) await page.waitForTimeout(100);
    const there = await tip(page);
    assert.ok(apart(there, taught) < 0.0006, `${there} is drawn, ${taught} is taught by the encoders`);
    assert.ok(began[2]! - there[2]! > 0.005, `the tool is lower by the touch: ${began} ${there}`);
    await locations.getByRole("button", { name: /Close/ }).click();
    await shot(page, "scene-live");
    await noViolation(page, "the cell in 3-D");

    // The run again: slider, chart and icon are one.
    await page.getByRole("button", { name: "Windows on the cell" }).click();
    await page.getByRole("menuitem", { name: "Force" }).click();
    await page.locator('[data-act="scene.replay"]').click();
    await page.locator(".scene-mark").waitFor();
    await page.locator('[data-about="force"] .chart-replayed').waitFor();
    const slider = page.getByRole("slider", { name: "Instant of the run" });
    const [first, last] = [Number(await slider.getAttribute("min")), Number(await slider.getAttribute("max"))];
    const to = async (time: number) => {
      await slider.evaluate((input: HTMLInputElement, value) => {
        Object.getOwnPropertyDescriptor(HTMLInputElement.prototype, "value")!.set!.call(input, String(value));
        input.dispatchEvent(new Event("input", { bubbles: true }));
      }, time);
      await page.waitForFunction((wanted) => Math.abs(Number(document.querySelector<HTMLElement>(".scene-frame")!.dataset["time"]) - wanted) < 0.011, time);
    };
    await to(first + 0.05);
    assert.ok(apart(await tip(page), began) < 0.002, "the arm is where it began");
    assert.equal(await icon(page, "up").getAttribute("data-replayed"), "true");
    await to(last - 0.05);
    assert.ok(apart(await tip(page), there) < 0.002, "the arm is where it ended");
    assert.equal(await icon(page, "feel").getAttribute("data-replayed"), "true");
    assert.equal(await icon(page, "up").getAttribute("data-replayed"), null);
    // The chart tells the force of that instant, and its cursor is there.
    const time = await page.locator('[data-about="force"] .chart-time').textContent();
    assert.ok(Math.abs(Number(time!.replace(/[^\d.]/g, "")) - (last - 0.05)) < 0.03, `${time} in the chart`);
    await page.waitForFunction(() => Number(document.querySelector('[data-about="force"] [data-field="fz"] b')?.textContent?.replace("−", "-")) < -2);
    // By keys, and played.
    await slider.focus();
    await page.keyboard.press("Home");
    await page.waitForFunction((wanted) => Math.abs(Number(document.querySelector<HTMLElement>(".scene-frame")!.dataset["time"]) - wanted) < 0.011, first);
    await page.getByRole("button", { name: "0.25×" }).click();
    await page.locator('[data-act="scene.play"]').click();
    await page.waitForFunction((wanted) => Number(document.querySelector<HTMLElement>(".scene-frame")!.dataset["time"]) > wanted + 0.1, first);
    await page.locator('[data-act="scene.play"]').click();
    await to(last - 0.05);
    await shot(page, "scene-replay");
    await noViolation(page, "a run again");
    await page.locator('[data-act="scene.live"]').click();
    await page.locator(".scene-mark").waitFor({ state: "detached" });
    assert.equal(await page.locator(".icon[data-replayed]").count(), 0);
    assert.deepEqual(errors.get(page), []);
  } catch (problem) {
    await shot(page, "failed-scene");
    throw problem;
  } finally {
    await page.context().close();
    await served.end();
  }
});
