// Each finding of the operations' reference is shown at its icon, with its page and, where there is one, its cure as a button.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import { browser, drawing, icon, imported, openPage, shot } from "./browser";
import { cell, type Cell } from "./cell";

let chromium: Browser, served: Cell, page: Page;
before(async () => {
  [chromium, served] = await Promise.all([browser(), cell("touch")]);
  page = await openPage(chromium, served.url);
  await page.locator('[data-offer="start"]').waitFor();
});
after(async () => {
  await chromium.close();
  await served.end();
});

interface Case {
  about: string;
  icons: Record<string, unknown>[];
  operations?: unknown[];
  /** By icon: the codes that its mark lists. */
  found: Record<string, string[]>;
}

const start = { id: "start", kind: "start", next: "find" }, touch = { id: "find", kind: "skill", skill: "touch", next: "end", error: "end" }, end = { id: "end", kind: "exit" };
const cases: Case[] = [
  {
    about: "what is wrong with the drawing itself",
    icons: [
      start, { ...touch, next: "fimd", error: "end" }, end, { id: "loose", kind: "skill", skill: "rub", error: "end" }, { id: "again", kind: "start", next: "find" },
      { id: "round", kind: "merge", next: "round-2" }, { id: "round-2", kind: "merge", next: "round" }, { id: "part", kind: "operation", operation: "self", next: "end" },
      { id: "gone", kind: "operation", operation: "nothing", next: "end" }, { id: "wait", kind: "delay", seconds: { argument: "time" }, next: "end" }, { id: "field", kind: "delay", seconds: "long", next: "end" },
    ].filter((each) => each.id !== "field"),
    operations: [{ name: "self", icons: [{ id: "start", kind: "start", next: "me" }, { id: "me", kind: "operation", operation: "self", next: "end" }, { id: "end", kind: "exit" }] }],
    found: { find: ["PAL1004"], loose: ["PAL1004", "PAL1005"], again: ["PAL1015"], gone: ["PAL1014"], wait: ["PAL1019"], round: ["PAL1013"] },
  },
  {
    about: "a field that is wrong, and two icons of one name",
    icons: [start, touch, end, { id: "field", kind: "delay", seconds: "long", next: "end" }, { id: "end", kind: "exit" }],
    found: { field: ["PAL1002"] },
  },
  {
    about: "what the cell lacks",
    icons: [
      start, { ...touch, skill: "tuch" }, end, { id: "hot", kind: "skill", skill: "rub", parameters: { speeed: 1, distance: 1000 }, next: "end", error: "end" },
      { id: "go", kind: "skill", skill: "move-to-location", parameters: { location: "HOMME" }, next: "end", error: "end" },
      { id: "look", kind: "test", sensor: "force-zz", limits: [1], next: "end", error: "end" },
      { id: "figure", kind: "test", value: { "output-of": "hot", name: "colour" }, limits: [1], next: "end", error: "end" },
    ],
    found: { find: ["PAL1007"], hot: ["PAL1008", "PAL1009"], go: ["PAL1010"], look: ["PAL1017"], figure: ["PAL1020"] },
  },
  {
    about: "codes and ends",
    icons: [start, { id: "find", kind: "skill", skill: "touch", next: "which" }, { id: "which", kind: "case", ways: [{ codes: [0], to: "round" }, { codes: [7], to: "end" }] }, end, { id: "round", kind: "skill", skill: "rub", next: "round" }],
    found: { which: ["PAL1006", "PAL1016"], round: ["PAL1006"] },
  },
];

for (const each of cases) {
  test(each.about, async () => {
    // Places far apart, so that every mark is seen.
    const icons = each.icons.map((one, i) => ({ ...one, at: [(i % 4) * 280, Math.floor(i / 4) * 160] }));
    await imported(page, JSON.stringify({ "operation-format": 1, name: "wrong", icons, ...(each.operations ? { operations: each.operations } : {}) }));
    for (const [id, codes] of Object.entries(each.found)) {
      await icon(page, id).first().locator(".mark-finding").first().click();
      const window = page.locator('[data-window="findings"]');
      for (const code of codes) await window.getByRole("button", { name: code, exact: true }).first().waitFor();
      await window.locator(".window-head button").click();
    }
    await shot(page, `findings-${cases.indexOf(each)}`);
  });
}

test("a finding has its page, and its cure mends it", async () => {
  const icons = [{ ...start, at: [0, 0] }, { id: "find", kind: "skill", skill: "tuch", next: "end", error: "end", at: [200, 0] }, { ...end, at: [480, 0] }];
  await imported(page, JSON.stringify({ "operation-format": 1, name: "wrong", icons }));
  await icon(page, "find").locator(".mark-finding").click();
  await page.locator('[data-window="findings"]').getByRole("button", { name: "PAL1007", exact: true }).click();
  await page.locator('[data-window="explain"] .explained').waitFor();
  await shot(page, "finding-explained");
  await page.locator('[data-window="explain"] .window-head button').click();
  await page.locator('[data-window="findings"]').getByRole("button", { name: "Mend it" }).click();
  await icon(page, "find").locator(".mark-finding").waitFor({ state: "detached" });
  assert.equal((await drawing(page)).icons.find((one) => one.id === "find")!.skill, "touch");
  await page.locator('[data-window="findings"] .window-head button').click();
});

test("what no icon handles is led to a new exit by its cure", async () => {
  const icons = [{ ...start, at: [0, 0] }, { id: "find", kind: "skill", skill: "touch", next: "end", at: [200, 0] }, { ...end, at: [480, 0] }];
  await imported(page, JSON.stringify({ "operation-format": 1, name: "wrong", icons }));
  await icon(page, "find").locator(".mark-finding").click();
  await page.locator('[data-window="findings"]').getByRole("button", { name: "Mend it" }).first().click();
  await icon(page, "failed").waitFor();
  await icon(page, "find").locator(".mark-finding").waitFor({ state: "detached" });
  assert.equal((await drawing(page)).icons.find((one) => one.id === "find")!.error, "failed");
  await page.locator('[data-window="findings"] .window-head button').click();
});

test("a text that is no operation is refused with its reason", async () => {
  await imported(page, readFileSync(join(process.env.WORKSTATION!, "../tests/golden/operation/fail_no_json.op.json"), "utf8"), false);
  await page.locator(".notice").first().waitFor();
  await page.locator(".notice button").first().click();
});
