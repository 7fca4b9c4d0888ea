// axe-core over the page: nothing may be violated. The page's policy allows no foreign script, so the context bypasses it.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import type { Page } from "playwright-core";

const axe = readFileSync(createRequire(join(process.env.WORKSTATION!, "package.json")).resolve("axe-core/axe.min.js"), "utf8");

/** `part`: only what lies within; the rest of the page was looked at before. */
export async function noViolation(page: Page, where: string, part?: string): Promise<void> {
  if (!(await page.evaluate(() => "axe" in window))) await page.evaluate(axe);
  const found = await page.evaluate(async (within) => {
    const scope = window as unknown as { axe: { run(context: unknown, options: unknown): Promise<{ violations: { id: string; nodes: { html: string; failureSummary: string }[] }[] }> } };
    const about = within ? [...document.querySelectorAll(within)].at(-1) : document;
    if (!about) throw new Error(`${within} is not there`);
    const { violations } = await scope.axe.run(about, { resultTypes: ["violations"] });
    return violations.map((each) => `${each.id}: ${each.nodes.slice(0, 3).map((node) => `${node.html.slice(0, 160)} ${node.failureSummary}`).join(" | ")}`);
  }, part);
  assert.deepEqual(found, [], where);
}
