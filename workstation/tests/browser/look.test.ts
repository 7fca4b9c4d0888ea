// How the page looks and whom it serves: no violation of axe-core in any window, light and dark; a tablet; French; five
// hundred icons. With PICTURES=FOLDER it keeps a picture of each window.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser, BrowserContextOptions, Page } from "playwright-core";
import { noViolation } from "./axe";
import { browser, errors, icon, shot } from "./browser";
import { cell, type Cell } from "./cell";
import { tour } from "./tour";

let chromium: Browser, served: Cell;
before(async () => {
  [chromium, served] = await Promise.all([browser(), cell("touch")]);
});
after(async () => {
  await chromium.close();
  await served.end();
});

const example = readFileSync(join(process.env.WORKSTATION!, "../examples/operations/rub_in_square.op.json"), "utf8");

async function within(options: BrowserContextOptions, drawing: string, what: (page: Page) => Promise<void>): Promise<void> {
  const context = await chromium.newContext({ viewport: { width: 1280, height: 800 }, locale: "en-US", reducedMotion: "reduce", ...options });
  await context.addInitScript((text) => {
    if (!localStorage.getItem("workcell-drawing")) localStorage.setItem("workcell-drawing", JSON.stringify({ drawing: JSON.parse(text), trail: [], version: 0, changed: false }));
  }, drawing);
  const page = await context.newPage();
  const seen: string[] = [];
  errors.set(page, seen);
  page.on("pageerror", (error) => seen.push(error.message));
  page.on("console", (message) => /content security policy/i.test(message.text()) && seen.push(message.text()));
  try {
    await page.goto(served.url);
    await page.locator(".icon").first().waitFor();
    await page.locator('[data-offer="skill:touch"]').waitFor({ state: "attached" });
    await what(page);
    assert.deepEqual(seen, []);
  } catch (problem) {
    await shot(page, "failed-look");
    throw problem;
  } finally {
    await context.close();
  }
}

test("every window in light", () => within({ bypassCSP: true, colorScheme: "light" }, example, (page) => tour(page, "light")));
test("every window in dark, in French", () => within({ bypassCSP: true, colorScheme: "dark", locale: "fr-FR" }, example, (page) => tour(page, "dark")));
test("a tablet, by touch", () => within({ bypassCSP: true, viewport: { width: 1024, height: 768 }, hasTouch: true, isMobile: true }, example, async (page) => {
  await shot(page, "tablet");
  const small = await page.locator(".bar button, .palette button, .canvas-tools button").evaluateAll((all) =>
    all.filter((each) => each.getClientRects().length > 0 && (each.clientHeight < 42 || each.clientWidth < 42)).map((each) => each.getAttribute("aria-label") ?? each.textContent));
  assert.deepEqual(small, []);
  await noViolation(page, "tablet");
}));

test("five hundred icons: all are shown; what a step of panning costs is printed", () => {
  const icons = [{ id: "start", kind: "start", next: "i0", at: [-160, 0] }] as Record<string, unknown>[];
  for (let i = 0; i < 499; ++i) icons.push({ id: `i${i}`, kind: "skill", skill: "touch", ...(i < 498 ? { next: `i${i + 1}` } : {}), at: [(i % 25) * 264, Math.floor(i / 25) * 136] });
  return within({}, JSON.stringify({ "operation-format": 1, name: "many", icons }), async (page) => {
    assert.equal(await page.locator(".icon").count(), 500);
    const client = await page.context().newCDPSession(page);
    await client.send("Performance.enable");
    const scripting = async () => (await client.send("Performance.getMetrics")).metrics.find((each) => each.name === "ScriptDuration")!.value;
    const gap = await page.evaluate(() => {
      for (let y = 200; y < 700; y += 3) for (let x = 400; x < 900; x += 3) if (document.elementFromPoint(x, y)?.classList.contains("react-flow__pane")) return { x, y };
      return undefined;
    });
    assert.ok(gap);
    const one = (await icon(page, "i30").boundingBox())!;
    for (const [what, x, y] of [["panning", gap.x, gap.y], ["moving an icon", one.x + 40, one.y + 10]] as const) {
      await page.mouse.move(x, y);
      await page.mouse.down();
      await page.mouse.move(x - 3, y - 3);
      const began = await scripting();
      for (let i = 1; i <= 30; ++i) await page.mouse.move(x - i * 4, y - i * 4);
      const each = ((await scripting()) - began) / 30 * 1000;
      await page.mouse.up();
      console.log(`500 icons: ${each.toFixed(1)} ms of scripting for a step of ${what}`);
    }
    await shot(page, "five-hundred");
  });
});
