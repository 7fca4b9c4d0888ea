// Draws operations of the thesis from an empty canvas and runs them to their ends.
import assert from "node:assert/strict";
import type { Browser, Page } from "playwright-core";
import { act, drawing, errors, icon, openPage, shot, state, untilState } from "./browser";
import { cell } from "./cell";
import { drawByKeyboard, drawByMouse, type Wanted } from "./hands";
import { followEdgeAgain, pickByIdentity } from "./operations";

export type Hand = "mouse" | "keyboard";

async function drawn(from: Browser, scene: string, hand: Hand, icons: readonly Wanted[], options: readonly string[], then: (page: Page) => Promise<void>): Promise<void> {
  const served = await cell(scene, options);
  const page = await openPage(from, served.url);
  try {
    await page.locator('[data-offer="skill:rub"]').waitFor();
    if (hand === "mouse") {
      await page.getByRole("button", { name: "Hide this panel" }).click();
      if (icons.length > 10) for (let i = 0; i < 4; ++i) await page.getByRole("button", { name: "Zoom out" }).click();
      await page.waitForTimeout(200);
    }
    await (hand === "mouse" ? drawByMouse : drawByKeyboard)(page, icons);
    const there = await drawing(page);
    assert.deepEqual(there.icons.map((each) => each.id).sort(), icons.map((each) => each.id).sort());
    await page.locator(".state-findings").waitFor({ state: "detached" });
    await shot(page, `${scene}-drawn-by-${hand}`);
    await then(page);
    assert.deepEqual(errors.get(page), []);
  } catch (problem) {
    await shot(page, `failed-${scene}-${hand}`);
    throw problem;
  } finally {
    await page.context().close();
    await served.end();
  }
}

/** One part comes; it is told by the sensor, taken to the place of its kind, and then no other one comes. */
export const pick = (from: Browser, hand: Hand): Promise<void> => drawn(from, "delivery-middle", hand, pickByIdentity, ["--fast"], async (page) => {
  await act(page, "run").click();
  await untilState(page, "Ended", 60000);
  assert.match((await page.locator(".state-detail").textContent())!, /code 0/);
  for (const id of ["pick-middle", "place-middle", "picked", "placed", "no-part"]) assert.equal(await icon(page, id).getAttribute("data-run"), "passed", id);
  for (const id of ["pick-high", "pick-low", "place-high"]) assert.equal(await icon(page, id).getAttribute("data-run"), "none", id);
  await shot(page, `pick-by-identity-run-${hand}`);
});

/** It goes round until it is stopped. */
export const followEdge = (from: Browser, hand: Hand): Promise<void> => drawn(from, "seam", hand, followEdgeAgain, ["--fast"], async (page) => {
  await page.keyboard.press("F5");
  await page.waitForFunction(() => [...document.querySelectorAll('.icon[data-id="follow"] .visits')].some((each) => each.textContent === "×2"));
  await page.keyboard.press("F9");
  await untilState(page, "Stopped");
  assert.equal(await state(page).textContent(), "Stopped");
  await shot(page, `follow-edge-stopped-${hand}`);
});
