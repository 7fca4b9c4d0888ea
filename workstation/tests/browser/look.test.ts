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

/** Every window in turn. */
async function tour(page: Page, name: string): Promise<void> {
  const look = async (window: string) => {
    await shot(page, `${name}-${window}`);
    await noViolation(page, `${name}, ${window}`);
  };
  await look("canvas");
  await page.locator(".state-bounds").click();
  await page.locator('[data-window="ways"] li').first().waitFor();
  await look("ways");
  await page.locator('[data-window="ways"] .window-head button').click();
  await icon(page, "find").dblclick({ position: { x: 60, y: 8 } });
  await look("dialog");
  await page.locator('[data-window="icon"] .window-foot button').first().click();
  await page.locator('[data-window="skill"] table').first().waitFor();
  await look("help");
  await page.keyboard.press("Escape");
  await page.locator('[data-window="icon"] .window-head button').click();
  await icon(page, "found").dblclick({ position: { x: 60, y: 8 } });
  await look("case");
  await page.locator('[data-window="icon"] .window-head button').click();
  await page.locator(".file").click();
  await look("file-menu");
  await page.keyboard.press("Escape");
  await page.keyboard.press("Control+o");
  await page.locator('[data-window="store"] .window-body > :not(.loading)').first().waitFor();
  await look("store");
  await page.locator('[data-window="store"] .window-head button').click();
  await page.keyboard.press("F1");
  await page.locator('[data-window="keys"] .help').waitFor();
  await look("keys");
  await page.locator('[data-window="keys"] .window-head button').click();
  await rest(page, name, look);
}

/** Windows that come of something: breakpoints, findings with their pages, a planned skill, a save and its versions. By keys, not by words: it serves every language. */
async function rest(page: Page, name: string, look: (window: string) => Promise<void>): Promise<void> {
  const close = async (window: string) => {
    await page.locator(`[data-window="${window}"] .window-head button`).click();
    await page.locator(`[data-window="${window}"]`).waitFor({ state: "detached" });
  };
  await icon(page, "lift").click({ button: "right", position: { x: 60, y: 10 } });
  await look("icon-menu");
  await page.locator('[data-key="break"]').click();
  await icon(page, "lift").locator(".mark-break").waitFor();
  await page.locator('.bar-part [aria-haspopup="true"]').last().click();
  await look("settings");
  await page.locator('[data-key="breaks"]').click();
  await page.locator('[data-window="breakpoints"] .break-head button').nth(1).click();
  await page.locator(".break-when").waitFor();
  await look("breakpoints");
  await close("breakpoints");
  await icon(page, "lift").focus();
  await page.keyboard.type("r");
  await page.locator(".floating .option").first().waitFor();
  await look("insert");
  await page.keyboard.type("zzz");
  await page.locator(".floating .nothing").waitFor();
  await noViolation(page, `${name}, insert nothing`);
  await page.keyboard.press("Escape");
  await page.locator('[data-offer="planned"]').dblclick();
  await page.locator('.icon[data-kind="planned"]:focus').waitFor();
  await page.keyboard.press("Enter");
  await page.locator('[data-window="icon"] .window-body > .form > .ways > button').last().click();
  await page.locator(".planned-argument").waitFor();
  await look("planned");
  await close("icon");
  await page.locator('.icon[data-kind="planned"] .mark-finding').click();
  await page.locator('[data-window="findings"] .finding').first().waitFor();
  await look("findings");
  await page.locator('[data-window="findings"] .finding .quiet').first().click();
  await page.locator('[data-window="explain"] .explained').waitFor();
  await look("finding-explained");
  await close("explain");
  await close("findings");
  await page.keyboard.press("Control+s");
  await page.locator(".modal input").fill(`tour-${name}`);
  await look("save");
  await page.keyboard.press("Enter");
  await page.locator(".unsaved").waitFor({ state: "detached" });
  await icon(page, "lift").focus();
  await page.keyboard.press("Delete");
  await page.locator(".file").click();
  await page.locator('[data-key="versions"]').click();
  await page.locator('[data-window="versions"] .version-row button').first().click();
  await page.locator(".change").first().waitFor();
  await look("versions");
  await close("versions");
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
