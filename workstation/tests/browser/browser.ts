// The browser of the tests, and what a person does with the page.
import { existsSync, mkdirSync } from "node:fs";
import { join } from "node:path";
import { chromium, type Browser, type BrowserContextOptions, type Page } from "playwright-core";

const program = process.env.CHROMIUM ?? "/usr/bin/chromium";
// WebGL 2 without a graphics card.
export const launch = { executablePath: program, args: ["--enable-unsafe-swiftshader", ...(process.getuid?.() === 0 ? ["--no-sandbox"] : [])] };

export async function browser(): Promise<Browser> {
  if (!existsSync(program)) throw new Error(`${program} is missing: apt-get install chromium (scripts/setup does it)`);
  return chromium.launch(launch);
}

export const errors = new WeakMap<Page, string[]>();

export async function openPage(from: Browser, url: string, options: BrowserContextOptions = {}): Promise<Page> {
  const context = await from.newContext({ viewport: { width: 1440, height: 900 }, locale: "en-US", reducedMotion: "reduce", ...options });
  const page = await context.newPage();
  const seen: string[] = [];
  errors.set(page, seen);
  page.on("pageerror", (error) => seen.push(error.message));
  page.on("console", (message) => /content security policy/i.test(message.text()) && seen.push(message.text()));
  page.setDefaultTimeout(30000);
  await page.goto(url);
  // Keys that are pressed before the page is drawn would be the browser's own.
  if (url.startsWith("http")) await page.locator(".page, .no-token, .operator").first().waitFor();
  return page;
}

export const icon = (page: Page, id: string) => page.locator(`.icon[data-id="${id}"]`);
export const state = (page: Page) => page.locator(".state-headline");
export const act = (page: Page, word: string) => page.locator(`[data-act="run.${word}"]`);

export async function untilState(page: Page, text: string, longest = 15000): Promise<void> {
  await page.waitForFunction((wanted) => document.querySelector(".state-headline")?.textContent === wanted, text, { timeout: longest });
}

/** Drags an icon from the palette to a place of the canvas. */
export async function drop(page: Page, offer: string, x: number, y: number): Promise<void> {
  const item = page.locator(`[data-offer="${offer}"]`);
  await item.scrollIntoViewIfNeeded();
  await item.dragTo(page.locator(".canvas"), { targetPosition: { x, y }, sourcePosition: { x: 20, y: 16 } });
}

/** Draws a line with the mouse, from an output to an icon's input. */
export async function line(page: Page, from: string, port: string, to: string): Promise<void> {
  const a = (await icon(page, from).locator(`.connector.out[data-handleid="${port}"]`).boundingBox())!;
  const b = (await icon(page, to).locator(".connector.in").boundingBox())!;
  await page.mouse.move(a.x + a.width / 2, a.y + a.height / 2);
  await page.mouse.down();
  await page.mouse.move((a.x + b.x) / 2, (a.y + b.y) / 2, { steps: 3 });
  await page.mouse.move(b.x + b.width / 2, b.y + b.height / 2, { steps: 3 });
  await page.mouse.up();
}

/** Types the name of an icon and takes the first that fits; it comes behind the icon that has the focus. */
export async function insert(page: Page, name: string): Promise<void> {
  await page.keyboard.type(name);
  await page.keyboard.press("Enter");
  await page.locator(".floating").waitFor({ state: "detached" });
}

/** Opens an operation as a person imports its file. */
export async function imported(page: Page, text: string, shown = true): Promise<void> {
  await page.locator(".file").click();
  const [chooser] = await Promise.all([page.waitForEvent("filechooser"), page.getByRole("menuitem", { name: "Import a file…" }).click()]);
  await chooser.setFiles({ name: "operation.op.json", mimeType: "application/json", buffer: Buffer.from(text) });
  const discard = page.getByRole("button", { name: "Go on without saving" });
  await page.waitForTimeout(150);
  if (await discard.isVisible()) await discard.click();
  if (shown) await page.locator(".icon").first().waitFor();
  await page.waitForTimeout(300);
}

/** What the page keeps of the drawing. */
export async function drawing(page: Page): Promise<{ name: string; icons: { id: string; kind: string; skill?: string; break?: Record<string, unknown>; next?: string; error?: string; parameters?: Record<string, unknown> }[] }> {
  await page.waitForTimeout(260);
  return page.evaluate(() => JSON.parse(localStorage.getItem("workcell-drawing")!).drawing);
}

/** A field of the open dialog of an icon. */
export const field = (page: Page, label: string) => page.locator('[data-window="icon"]').getByRole("textbox", { name: label, exact: true });

/** What a print of the page would show: the parts that are seen then. */
export async function printed(page: Page, shown: string, hidden: readonly string[]): Promise<void> {
  await page.evaluate(() => dispatchEvent(new Event("beforeprint")));
  await page.emulateMedia({ media: "print" });
  await page.locator(shown).first().waitFor({ state: "visible" });
  for (const each of hidden) await page.locator(each).first().waitFor({ state: "hidden" });
  // Paper is light, whatever the screen is.
  if ((await page.locator("html").getAttribute("data-theme")) !== "light") throw new Error("the print is dark");
  await shot(page, `print-${shown.replace(/\W+/g, "-")}`);
  await page.emulateMedia({ media: "screen" });
  await page.evaluate(() => dispatchEvent(new Event("afterprint")));
  await page.locator(hidden[0]!).first().waitFor({ state: "visible" });
}

export async function shot(page: Page, name: string): Promise<void> {
  const folder = process.env.PICTURES;
  if (!folder) return;
  mkdirSync(folder, { recursive: true });
  await page.waitForTimeout(150);
  // The cell in 3-D is drawn finely once it rests. A cell that moves is not waited for.
  await page.waitForFunction(() => Number.parseFloat(document.querySelector<HTMLElement>(".scene-frame")?.dataset["fineness"] ?? "1") >= 1, undefined, { timeout: 3000 }).catch(() => {});
  await page.screenshot({ path: join(folder, `${name}.png`) });
}
