// The store: save, open, rename, versions with their difference, a conflict with a choice, export and import; tidy; step; a
// page that crashes with a drawing that was not saved; a page of another origin.
import assert from "node:assert/strict";
import { mkdtempSync, readdirSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import { act, browser, drawing, icon, imported, launch, openPage, shot, untilState } from "./browser";
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

const text = readFileSync(join(process.env.WORKSTATION!, "../examples/operations/rub_in_square.op.json"), "utf8");
const exported = async (from: Page): Promise<string> => {
  await from.locator(".file").click();
  const [download] = await Promise.all([from.waitForEvent("download"), from.getByRole("menuitem", { name: "Export as a file" }).click()]);
  return readFileSync((await download.path())!, "utf8");
};
const title = (from: Page, wanted: string) => from.waitForFunction((name) => document.querySelector(".file-name")?.textContent === name, wanted);

test("an imported file is exported byte for byte", async () => {
  await imported(page, text);
  assert.equal(await exported(page), text);
});

test("save under a name, change, save again, and see what changed", async () => {
  await page.keyboard.press("Control+s");
  await page.locator(".modal").getByRole("textbox", { name: "Name" }).fill("square");
  await page.locator(".modal").getByRole("button", { name: "Save", exact: true }).click();
  await title(page, "square");
  await icon(page, "lift").dblclick({ position: { x: 60, y: 8 } });
  await page.locator('[data-window="icon"]').getByRole("textbox", { name: "dz", exact: true }).fill("-30");
  await page.keyboard.press("Tab");
  await page.locator('[data-window="icon"] .window-head button').click();
  await page.locator(".unsaved").waitFor();
  await page.keyboard.press("Control+s");
  await page.locator(".unsaved").waitFor({ state: "detached" });
  await page.locator(".file").click();
  await page.getByRole("menuitem", { name: "Older versions" }).click();
  const window = page.locator('[data-window="versions"]');
  await window.getByRole("button", { name: "What changed" }).nth(1).click();
  await window.locator(".change", { hasText: "lift" }).waitFor();
  assert.match((await window.locator(".change").textContent())!, /dz/);
  await shot(page, "versions");
  await window.locator(".window-head button").click();
});

test("a save over somebody's newer version is refused, with a choice", async () => {
  const other = await openPage(chromium, served.url);
  await other.keyboard.press("Control+o");
  await other.locator(".store-open").first().click();
  await title(other, "square");
  for (const [each, name] of [[other, "theirs"], [page, "mine"]] as const) {
    await icon(each, "lift").dblclick({ position: { x: 60, y: 8 } });
    await each.locator('[data-window="icon"]').getByRole("textbox", { name: "Note" }).fill(name);
    await each.locator('[data-window="icon"] .window-head button').click();
    await each.keyboard.press("Control+s");
    if (each === other) await each.locator(".unsaved").waitFor({ state: "detached" });
  }
  await page.locator(".modal", { hasText: "newer" }).waitFor();
  await shot(page, "conflict");
  await page.getByRole("button", { name: "Save mine as the newest" }).click();
  await page.locator(".unsaved").waitFor({ state: "detached" });
  await other.context().close();
});

test("rename in the list", async () => {
  await page.keyboard.press("Control+o");
  await page.getByRole("button", { name: "More for square" }).click();
  await page.getByRole("menuitem", { name: "Rename" }).click();
  await page.getByRole("textbox", { name: "New name" }).fill("plate");
  await page.keyboard.press("Enter");
  await title(page, "plate");
  await shot(page, "store");
  await page.locator('[data-window="store"] .window-head button').click();
});

test("tidy lays the icons out, as one step that undo takes back", async () => {
  const before = await drawing(page);
  await page.getByRole("button", { name: "Tidy up" }).click();
  await page.waitForFunction((old) => JSON.stringify(JSON.parse(localStorage.getItem("workcell-drawing")!).drawing) !== old, JSON.stringify(before));
  await page.locator(".canvas").click({ position: { x: 20, y: 20 } });
  await page.keyboard.press("Control+z");
  assert.deepEqual(await drawing(page), before);
});

test("a step runs one skill and pauses", async () => {
  await act(page, "step").click();
  await untilState(page, "Paused");
  // The canvas has followed into the part.
  assert.match((await page.locator(".state-detail").textContent())!, /rub-in-square › side-1/);
  assert.equal(await icon(page, "side-1").getAttribute("data-run"), "halted");
  await act(page, "step").click();
  await page.waitForFunction(() => /side-2/.test(document.querySelector(".state-detail")?.textContent ?? ""));
  await act(page, "stop").click();
});

test("a drawing that was not saved survives a crash of the page", async () => {
  await imported(page, JSON.stringify({ "operation-format": 1, name: "crashed", icons: [{ id: "only-here", kind: "start", at: [0, 0] }] }));
  await drawing(page);
  const context = page.context();
  await page.goto("chrome://crash").catch(() => {});
  page = await context.newPage();
  await page.goto(served.url);
  await icon(page, "only-here").waitFor();
  await page.locator(".unsaved").waitFor();
});

/** The browser's own program, of the profile in this folder. */
function programOf(profile: string): number {
  for (const pid of readdirSync("/proc").filter((each) => /^\d+$/.test(each))) {
    let words: string[] = [];
    try {
      words = readFileSync(`/proc/${pid}/cmdline`, "utf8").split("\0");
    } catch {
      // It has just ended.
    }
    if (words.includes(`--user-data-dir=${profile}`) && !words.some((each) => each.startsWith("--type="))) return Number(pid);
  }
  throw new Error("the browser of this profile is not there");
}

test("a drawing that was not saved survives a crash of the whole browser", async () => {
  const profile = mkdtempSync(join(tmpdir(), "profile-"));
  const begun = async () => {
    const context = await chromium.browserType().launchPersistentContext(profile, { ...launch, locale: "en-US" });
    const there = context.pages()[0] ?? (await context.newPage());
    await there.goto(served.url);
    return there;
  };
  try {
    const first = await begun();
    await first.locator('[data-offer="skill:touch"]').waitFor();
    await imported(first, JSON.stringify({ "operation-format": 1, name: "killed", icons: [{ id: "begin", kind: "start", at: [0, 0] }] }));
    await first.locator('[data-offer="skill:touch"]').dblclick();
    await icon(first, "touch").waitFor();
    await first.waitForTimeout(700);
    process.kill(programOf(profile), "SIGKILL");
    await first.waitForEvent("close").catch(() => {});
    const again = await begun();
    await icon(again, "begin").waitFor();
    await icon(again, "touch").waitFor();
    await again.locator(".unsaved").waitFor();
    await again.context().close();
  } finally {
    rmSync(profile, { recursive: true, force: true, maxRetries: 5 });
  }
});

test("a page of another origin does not get in", async () => {
  const context = await chromium.newContext();
  const foreign = await context.newPage();
  await foreign.route("http://elsewhere.test/", (route) => route.fulfill({ contentType: "text/html", body: "<p>elsewhere</p>" }));
  await foreign.goto("http://elsewhere.test/");
  const came = await foreign.evaluate(([address, token]) => new Promise((resolve) => {
    const socket = new WebSocket(address!.replace("http", "ws"));
    socket.onopen = () => socket.send(JSON.stringify({ jsonrpc: "2.0", id: 1, method: "hello", params: { token } }));
    socket.onmessage = () => resolve("answered");
    socket.onclose = () => resolve("closed");
  }), [served.address, served.token]);
  assert.equal(came, "closed");
  await context.close();
});
