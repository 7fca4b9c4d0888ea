// The operator's page: what the operation sets free can be set within its limits, everything else is locked; and whatever
// the page shows, the server refuses an operator's token all that an operator may not do.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser, BrowserContextOptions, Page } from "playwright-core";
import { noViolation } from "./axe";
import { act, browser, drawing, errors, field, icon, imported, openPage, shot, untilState } from "./browser";
import { cell, type Cell } from "./cell";

let chromium: Browser;
before(async () => void (chromium = await browser()));
after(() => chromium.close());

const example = readFileSync(join(process.env.WORKSTATION!, "../examples/operations/rub_in_square.op.json"), "utf8");
const operatorUrl = (served: Cell) => `${served.address}/#token=${JSON.parse(readFileSync(join(served.folder, "workcell.json"), "utf8")).tokens.operator}`;

async function within(options: BrowserContextOptions, pace: readonly string[], what: (programmer: Page, served: Cell, open: () => Promise<Page>) => Promise<void>): Promise<void> {
  const served = await cell("touch", pace);
  const pages = [await openPage(chromium, served.url)];
  try {
    await pages[0]!.locator('[data-offer="start"]').waitFor();
    await what(pages[0]!, served, async () => {
      pages.push(await openPage(chromium, operatorUrl(served), options));
      return pages.at(-1)!;
    });
    for (const page of pages) assert.deepEqual(errors.get(page), []);
  } catch (problem) {
    for (const [i, page] of pages.entries()) await shot(page, `failed-operate-${i}`);
    throw problem;
  } finally {
    for (const page of pages) await page.context().close();
    await served.end();
  }
}

/** The programmer sets a parameter free with limits, saves, and gives the controls back. */
async function prepare(page: Page): Promise<void> {
  await imported(page, example);
  await icon(page, "find").dblclick({ position: { x: 90, y: 12 } });
  const dialog = page.locator('[data-window="icon"]');
  await dialog.getByRole("button", { name: "approach-speed: locked for operators" }).click();
  await field(page, "approach-speed, at least").fill("5");
  await field(page, "approach-speed, at most").fill("15");
  await page.keyboard.press("Tab");
  await shot(page, "set-free");
  assert.deepEqual((await drawing(page)).icons.find((each) => each.id === "find"), { ...(await drawing(page)).icons.find((each) => each.id === "find"), operator: { "approach-speed": { from: 5, to: 15 } } });
  await dialog.locator(".window-head button").click();
  await page.keyboard.press("Control+s");
  await page.locator(".modal").getByRole("textbox").fill("square");
  await page.locator(".modal").getByRole("button", { name: "Save" }).click();
  await page.locator(".notice", { hasText: "square" }).waitFor();
}

test("an operator loads, sets what is free, runs, pauses, stops", () => within({ bypassCSP: true }, ["--paced", "6"], async (programmer, _, open) => {
  await prepare(programmer);
  const page = await open();
  await page.locator(".operator").waitFor();
  await page.getByRole("button", { name: "square", exact: true }).click();
  const speed = page.locator('[data-icon="find"]').getByRole("textbox", { name: "approach-speed", exact: true });
  await speed.waitFor();
  await shot(page, "operator-light");
  await noViolation(page, "operator, light");
  // Beyond the limit: refused at once, and the value stays.
  await speed.fill("30");
  await page.locator('[data-icon="find"] .refusal').waitFor();
  await page.keyboard.press("Tab");
  assert.equal(await speed.inputValue(), "10");
  await speed.fill("8");
  await page.keyboard.press("Tab");
  await page.waitForFunction(() => document.querySelectorAll(".notice").length === 0);
  // What is not free is shown, locked.
  await page.getByRole("button", { name: /locked icon/ }).click();
  assert.ok((await page.locator(".operator-icon .locked").count()) > 5);
  await act(page, "run").click();
  await untilState(page, "Running");
  await shot(page, "operator-running");
  await act(page, "pause").click();
  await untilState(page, "Paused", 40000);
  await act(page, "stop").click();
  await untilState(page, "Stopped");
  await page.locator(".operator-choices li").first().waitFor();
  await shot(page, "operator-stopped");
  // The programmer's page tells who set what.
  assert.equal(await programmer.locator(".operator").count(), 0);
}));

test("dark, on a tablet, and the programmer's look at the same page", () => within({ bypassCSP: true, colorScheme: "dark", viewport: { width: 1024, height: 768 }, hasTouch: true, isMobile: true }, ["--fast"], async (programmer, _, open) => {
  await prepare(programmer);
  const page = await open();
  await page.getByRole("button", { name: "square", exact: true }).tap();
  await page.locator('[data-icon="find"]').waitFor();
  await shot(page, "operator-dark-tablet");
  await noViolation(page, "operator, dark");
  await programmer.getByRole("button", { name: "Settings" }).click();
  await programmer.getByRole("menuitem", { name: "Look as an operator" }).click();
  await programmer.locator(".operator").waitFor();
  await programmer.getByRole("button", { name: "Back to the drawing" }).click();
  await icon(programmer, "find").waitFor();
}));

test("an operator's token is refused everything else", () => within({}, ["--fast"], async (programmer, served, open) => {
  await prepare(programmer);
  const page = await open();
  await page.locator(".operator").waitFor();
  const schema = JSON.parse(readFileSync(join(process.env.WORKSTATION!, "../server/schema/protocol.json"), "utf8"));
  const beyond: string[] = schema.methods.filter((each: { "x-role": string }) => each["x-role"] === "programmer").map((each: { name: string }) => each.name);
  assert.ok(beyond.length >= 8, beyond.join());
  const { operator } = JSON.parse(readFileSync(join(served.folder, "workcell.json"), "utf8")).tokens;
  // By a client of its own: what the page does not offer is tried all the same.
  const answers = await page.evaluate(async ({ token, methods }) => {
    const socket = new WebSocket(`ws://${location.host}/`);
    await new Promise((resolve) => (socket.onopen = resolve));
    const told = new Map<number, { error?: { code: number; data?: { why?: string } } }>();
    let arrived = () => {};
    socket.onmessage = ({ data }) => {
      const message = JSON.parse(String(data));
      if (message.id !== undefined) told.set(message.id, message);
      arrived();
    };
    const ask = async (id: number, method: string, params: unknown) => {
      socket.send(JSON.stringify({ jsonrpc: "2.0", id, method, params }));
      while (!told.has(id)) await new Promise<void>((resolve) => (arrived = resolve));
      return told.get(id)!.error?.data?.why ?? "done";
    };
    await ask(1, "hello", { token, name: "intruder" });
    const result: Record<string, string> = {};
    let id = 2;
    for (const method of methods) result[method] = await ask(id++, method, { skill: "touch", location: "HOME", to: "X", name: "square", text: "{}", based_on: 1, pose: [0, 0, 0, 0, 0, 0] });
    result["text"] = await ask(id++, "operation.load", { main: "a.op.json", files: { "a.op.json": "{}" } });
    result["load"] = await ask(id++, "operation.load", { name: "square" });
    result["free, beyond"] = await ask(id++, "operation.set", { icon: "find", parameter: "approach-speed", value: 30 });
    result["free, within"] = await ask(id++, "operation.set", { icon: "find", parameter: "approach-speed", value: 12 });
    result["locked"] = await ask(id++, "operation.set", { icon: "find", parameter: "reach", value: 40 });
    result["more"] = await ask(id++, "controls.take", { force: true });
    return result;
  }, { token: operator as string, methods: beyond });
  for (const method of beyond) assert.equal(answers[method], "role", method);
  assert.equal(answers["text"], "role");
  assert.equal(answers["load"], "done");
  assert.equal(answers["free, beyond"], "role");
  assert.equal(answers["free, within"], "done");
  assert.equal(answers["locked"], "role");
}));
