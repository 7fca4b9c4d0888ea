// Production: runs are counted, cycle times stand beside the proved ones, and a standstill says why.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser, BrowserContextOptions } from "playwright-core";
import { noViolation } from "./axe";
import { act, browser, errors, imported, openPage, printed, shot, untilState } from "./browser";
import { cell } from "./cell";

let chromium: Browser;
before(async () => void (chromium = await browser()));
after(() => chromium.close());

const example = readFileSync(join(process.env.WORKSTATION!, "../examples/operations/rub_in_square.op.json"), "utf8");

async function shift(name: string, options: BrowserContextOptions): Promise<void> {
  const served = await cell("touch", ["--fast"]);
  const page = await openPage(chromium, served.url, { bypassCSP: true, ...options });
  try {
    await page.locator('[data-offer="start"]').waitFor({ state: "attached" });
    await imported(page, example);
    await act(page, "run").click();
    await untilState(page, "Ended", 30000);
    await page.getByRole("button", { name: "Windows on the cell" }).click();
    await page.getByRole("menuitem", { name: "Production" }).click();
    const production = page.locator('[data-window="production"]');
    const tile = (label: string) => production.locator(".tiles > div", { hasText: label }).locator("dd").textContent();
    await production.locator(".tiles").waitFor();
    assert.equal(await tile("ended with code 0"), "1");
    // A side that is too long makes the operation end with another code.
    await imported(page, example.replaceAll('"distance": 2', '"distance": 30'));
    await act(page, "run").click();
    await production.locator(".stops tbody tr").first().waitFor({ timeout: 60000 });
    assert.equal(await tile("runs in all"), "2");
    assert.match((await production.locator(".cycles").first().textContent())!, /measured, one run/);
    // The other way has its row, with its own longest time; the drawing is the second one by now, and its first run took that way.
    const ways = production.locator(".by-way tbody tr");
    await ways.nth(1).waitFor();
    assert.match((await ways.allTextContents()).join("|"), /exit failed with code 2.*side-1/);
    await shot(page, `${name}-production`);
    await noViolation(page, `production, ${name}`);
    await printed(page, ".production .tiles", [".page", ".production .button"]);
    assert.deepEqual(errors.get(page), []);
  } catch (problem) {
    await shot(page, "failed-produce");
    throw problem;
  } finally {
    await page.context().close();
    await served.end();
  }
}

test("a shift is counted, its cycles measured, its standstill explained", () => shift("light", {}));
test("the same in dark", () => shift("dark", { colorScheme: "dark" }));
