// axe-core over the page: nothing may be violated. The page's policy allows no foreign script, so the context bypasses it.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import type { Page } from "playwright-core";

const axe = readFileSync(createRequire(join(process.env.WORKSTATION!, "package.json")).resolve("axe-core/axe.min.js"), "utf8");

export async function noViolation(page: Page, where: string): Promise<void> {
  const found = await page.evaluate(async (source) => {
    const scope = window as unknown as { axe?: { run(context: unknown, options: unknown): Promise<{ violations: { id: string; nodes: { html: string; failureSummary: string }[] }[] }> } };
    if (!scope.axe) (0, eval)(source);
    const { violations } = await scope.axe!.run(document, { resultTypes: ["violations"] });
    return violations.map((each) => `${each.id}: ${each.nodes.slice(0, 3).map((node) => `${node.html.slice(0, 160)} ${node.failureSummary}`).join(" | ")}`);
  }, axe);
  assert.deepEqual(found, [], where);
}
