// A hundred random drawings: the text that the page exports is that of `pal operation format`, byte for byte.
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { dirname, join } from "node:path";
import { test } from "node:test";
import { browser, openPage } from "../browser/browser";
import { cell } from "../browser/cell";
import { randomDrawing, randomOf } from "../unit/random";

test("a hundred random drawings have the text of pal operation format", async () => {
  const [chromium, served] = await Promise.all([browser(), cell("touch")]);
  const folder = mkdtempSync(join(tmpdir(), "texts-"));
  try {
    const page = await openPage(chromium, served.url);
    await page.locator('[data-offer="start"]').waitFor();
    const drawings = Array.from({ length: 100 }, (_, i) => JSON.stringify(randomDrawing(randomOf(i + 1))));
    for (const [i, text] of drawings.entries()) {
      await page.evaluate((drawing) => {
        localStorage.setItem("workcell-drawing", JSON.stringify({ drawing: JSON.parse(drawing), trail: [], version: 0, changed: false }));
        addEventListener("pagehide", (event) => event.stopImmediatePropagation(), { capture: true });
      }, text);
      const kept = await page.evaluate(() => localStorage.getItem("workcell-drawing"));
      await page.addInitScript((value) => value !== null && localStorage.setItem("workcell-drawing", value), kept);
      await page.reload();
      await page.locator('[data-offer="skill:touch"]').waitFor({ state: "attached" });
      await page.locator(".file").click();
      const [download] = await Promise.all([page.waitForEvent("download"), page.getByRole("menuitem", { name: "Export as a file" }).click()]);
      const file = join(folder, `${i}.op.json`);
      writeFileSync(file, text);
      const pal = spawnSync(join(dirname(process.env.WORKCELL!), "pal"), ["operation", "format", file], { encoding: "utf8" });
      assert.equal(pal.status, 0, `seed ${i + 1}: ${pal.stderr}`);
      assert.equal(readFileSync((await download.path())!, "utf8"), readFileSync(file, "utf8"), `seed ${i + 1}`);
    }
  } finally {
    await chromium.close();
    await served.end();
    rmSync(folder, { recursive: true });
  }
});
