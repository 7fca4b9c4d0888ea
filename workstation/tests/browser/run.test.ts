// Running and debugging: pause, change, resume; breakpoints; two browsers; a late one; the server killed.
import assert from "node:assert/strict";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import { act, browser, drawing, drop, field, icon, line, openPage, shot, state, untilState } from "./browser";
import { cell, type Cell } from "./cell";

let chromium: Browser;
before(async () => void (chromium = await browser()));
after(() => chromium.close());

const example = (name: string) => join(process.env.WORKSTATION!, "../examples/operations", `${name}.op.json`);

/** Opens an operation's file, as a person imports it. */
async function imported(page: Page, name: string): Promise<void> {
  await page.locator('[data-offer="start"]').waitFor();
  await page.locator(".file").click();
  const [chooser] = await Promise.all([page.waitForEvent("filechooser"), page.getByRole("menuitem", { name: "Import a file…" }).click()]);
  await chooser.setFiles(example(name));
  await page.locator(".icon").first().waitFor();
}

async function within(scene: string, options: readonly string[], what: (page: Page, served: Cell) => Promise<void>): Promise<void> {
  const served = await cell(scene, options);
  const page = await openPage(chromium, served.url);
  try {
    await what(page, served);
  } catch (problem) {
    await shot(page, "failed-run");
    throw problem;
  } finally {
    await page.context().close();
    await served.end();
  }
}

test("pause, change a parameter, resume", () => within("touch", ["--paced", "4"], async (page) => {
  await imported(page, "rub_in_square");
  await act(page, "run").click();
  await untilState(page, "Running");
  await act(page, "pause").click();
  await untilState(page, "Paused");
  await page.locator(".trail button").first().click().catch(() => {});
  await icon(page, "lift").dblclick({ position: { x: 90, y: 12 } });
  await field(page, "dz").fill("-30");
  await page.keyboard.press("Tab");
  await shot(page, "paused-and-changed");
  await page.locator('[data-window="icon"] .window-head button').click();
  await act(page, "resume").click();
  await untilState(page, "Ended", 40000);
}));

test("what lies beyond a range is refused at once, and the value stays", () => within("touch", ["--fast"], async (page) => {
  await imported(page, "rub_in_square");
  await icon(page, "find").dblclick({ position: { x: 90, y: 12 } });
  await field(page, "approach-speed").fill("61");
  await page.locator('[data-window="icon"] .refusal').waitFor();
  await shot(page, "refused");
  await page.keyboard.press("Tab");
  assert.equal(await field(page, "approach-speed").inputValue(), "10");
}));

test("a breakpoint halts before its icon, and the list switches it off", () => within("touch", ["--fast"], async (page) => {
  await imported(page, "rub_in_square");
  await icon(page, "lift").click({ button: "right", position: { x: 90, y: 12 } });
  await page.getByRole("menuitem", { name: "Set a breakpoint" }).click();
  await icon(page, "lift").locator(".mark-break").waitFor();
  await act(page, "run").click();
  await untilState(page, "Paused");
  assert.equal(await icon(page, "lift").getAttribute("data-run"), "halted");
  await page.getByRole("button", { name: "Settings" }).click();
  await page.getByRole("menuitem", { name: "Breakpoints" }).click();
  // It is in the drawing, so it is in the file.
  assert.deepEqual((await drawing(page)).icons.find((each) => each.id === "lift")!.break, {});
  await page.getByRole("button", { name: /^When the breakpoint/ }).click();
  await page.locator(".break-when").getByRole("textbox", { name: "Halt once in" }).fill("3");
  await page.locator(".break .checkbox").click();
  await icon(page, "lift").locator(".mark-break[data-off]").waitFor();
  assert.deepEqual((await drawing(page)).icons.find((each) => each.id === "lift")!.break, { every: 3, enabled: false });
  await shot(page, "breakpoints");
  await act(page, "resume").click();
  await untilState(page, "Ended");
}));

test("a skill that nobody has written yet is done by a person", () => within("touch", ["--fast"], async (page) => {
  await page.locator('[data-offer="planned"]').waitFor();
  await drop(page, "start", 40, 120);
  await drop(page, "planned", 260, 120);
  await icon(page, "new-skill").dblclick({ position: { x: 60, y: 8 } });
  await page.locator('[data-window="icon"]').getByRole("textbox", { name: "Name of the skill" }).fill("insert-pin");
  await page.locator('[data-window="icon"]').getByRole("button", { name: "Add a parameter" }).click();
  await shot(page, "planned");
  await page.locator('[data-window="icon"] .window-head button').click();
  await drop(page, "exit", 260, 320);
  await line(page, "start", "next", "new-skill");
  await line(page, "new-skill", "next", "done");
  await line(page, "new-skill", "error", "done");
  await act(page, "run").click();
  await page.locator(".asks", { hasText: "insert-pin (parameter-1 = 0 mm)" }).waitFor();
  await shot(page, "planned-asked");
  await page.locator(".asks").getByRole("button", { name: "It could not be done." }).click();
  await untilState(page, "Ended");
  assert.match((await page.locator(".state-detail").textContent())!, /code 1/);
}));

test("two browsers see the same, a late one sees the present, and the controls are handed over", () => within("seam", ["--paced", "3"], async (page, served) => {
  await imported(page, "follow_edge_again");
  await act(page, "run").click();
  await untilState(page, "Running");
  const late = await openPage(chromium, served.url);
  await untilState(late, "Running");
  await late.locator(".icon[data-run=acting]").waitFor();
  assert.match((await late.locator(".controls").textContent())!, /has the controls/);
  await shot(late, "late");
  await late.reload();
  await untilState(late, "Running");
  await late.locator(".controls").click();
  await late.getByRole("menuitem", { name: /^Ask/ }).click();
  await page.locator(".controls[data-asked]").waitFor();
  await page.locator(".controls").click();
  await page.getByRole("menuitem", { name: /^Hand over/ }).click();
  await late.locator(".controls[data-yours]").waitFor();
  await page.locator(".controls:not([data-yours])").waitFor();
  // Whoever has not the controls may stop all the same.
  await act(page, "stop").click();
  await untilState(page, "Stopped");
  await untilState(late, "Stopped");
  await late.locator(".go-on .choices li").first().waitFor();
  await shot(late, "after-a-stop");
  await late.context().close();
}));

test("the server is killed and started again under an open page", () => within("touch", ["--fast"], async (page, served) => {
  await imported(page, "rub_in_square");
  await served.kill();
  await untilState(page, "Connection lost");
  await icon(page, "lift").click({ position: { x: 90, y: 12 } });
  const again = await cell("touch", ["--fast"], served);
  try {
    // The token is another one: the page asks for it, and has kept the drawing.
    await page.locator(".no-token").waitFor();
    await page.goto(`${again.url}`);
    await page.reload();
    await icon(page, "lift").waitFor();
    await act(page, "run").click();
    await untilState(page, "Ended");
  } finally {
    await again.kill();
  }
}));

test("a wrong token shows nothing of the cell", () => within("touch", ["--fast"], async (page, served) => {
  const wrong = await openPage(chromium, `${served.address}/#token=wrong`);
  await wrong.locator(".no-token").waitFor();
  assert.equal(await wrong.locator(".icon, .palette, .state").count(), 0);
  await shot(wrong, "wrong-token");
  await wrong.context().close();
  assert.equal(await state(page).count(), 1);
}));
