// Drawing an operation from a list of its icons, as a person does it with a mouse, or with the keyboard alone.
import type { Locator, Page } from "playwright-core";
import { drop, field, icon, insert, line } from "./browser";

/** A number or a text that is typed into a field, or an entry that is chosen from a list. */
export type Setting = string | { choose: string } | { press: string };

export interface Wanted {
  id: string;
  /** In the palette: "start", "case", "skill:rub". */
  offer: string;
  /** In pixels of the canvas. */
  at: [number, number];
  settings?: Record<string, Setting>;
  /** By output: the icon that its line leads to. */
  lines?: Record<string, string>;
}

/** The name that a new icon of the palette has at first. */
const firstName = (offer: string) => (offer === "exit" ? "done" : offer.replace(/^\w+:/, ""));
const form = (page: Page) => page.locator('[data-window="icon"]');
const list = (page: Page, label: string) => form(page).locator(".field", { has: page.getByText(label, { exact: true }) }).locator(".select-button").first();

async function setByMouse(page: Page, label: string, setting: Setting): Promise<void> {
  if (typeof setting === "string") return field(page, label).fill(setting);
  if ("press" in setting) return form(page).getByRole("button", { name: setting.press }).click();
  await list(page, label).click();
  await page.getByRole("option", { name: setting.choose }).first().click();
}

export async function drawByMouse(page: Page, icons: readonly Wanted[]): Promise<void> {
  for (const each of icons) {
    await drop(page, each.offer, ...each.at);
    if (each.offer === "start") continue;
    const name = firstName(each.offer);
    const made = await page.locator(`.icon[data-selected]`).getAttribute("data-id");
    if (!each.settings && made === each.id) continue;
    await icon(page, made ?? name).dblclick({ position: { x: 20, y: 6 } });
    await form(page).waitFor();
    for (const [label, setting] of Object.entries(each.settings ?? {})) await setByMouse(page, label, setting);
    if (made !== each.id) await field(page, "Name").fill(each.id);
    await page.keyboard.press("Tab");
    await form(page).locator(".window-head button").click();
  }
  for (const each of icons) for (const [port, to] of Object.entries(each.lines ?? {})) await line(page, each.id, port, to);
}

const focused = (page: Page) => page.evaluate(() => (document.activeElement as HTMLElement | null)?.dataset.id);

/** By arrows, as the eye leads: where it lies mostly, and aside if there is nothing. */
export async function walkTo(page: Page, id: string): Promise<void> {
  const tried = new Set<string>();
  for (let i = 0; i < 60; ++i) {
    const here = await focused(page);
    if (here === id) return;
    const keys = await page.evaluate(([from, to]) => {
      const middle = (name: string) => {
        const box = document.querySelector(`.icon[data-id="${name}"]`)!.getBoundingClientRect();
        return [box.left + box.width / 2, box.top + box.height / 2] as const;
      };
      const [a, b] = [middle(from!), middle(to!)], dx = b[0] - a[0], dy = b[1] - a[1];
      const across = dx > 0 ? "ArrowRight" : "ArrowLeft", down = dy > 0 ? "ArrowDown" : "ArrowUp";
      const back = dx > 0 ? "ArrowLeft" : "ArrowRight", up = dy > 0 ? "ArrowUp" : "ArrowDown";
      return Math.abs(dx) > Math.abs(dy) ? [across, down, up, back] : [down, across, back, up];
    }, [here ?? "", id]);
    const key = keys.find((each) => !tried.has(`${here} ${each}`));
    if (!key) throw new Error(`no arrow leads from ${here} to ${id}`);
    tried.add(`${here} ${key}`);
    await page.keyboard.press(key);
    await page.waitForTimeout(40);
  }
  throw new Error(`arrows do not lead to ${id}`);
}

/** Tab, or Shift+Tab to what lies before: a person sees on which side it is. */
export async function tabTo(page: Page, wanted: Locator): Promise<void> {
  for (let i = 0; i < 80; ++i) {
    const way = await wanted.evaluate((each) => {
      const here = document.activeElement;
      if (here === each) return "there";
      return here && here.compareDocumentPosition(each) & Node.DOCUMENT_POSITION_PRECEDING ? "back" : "on";
    });
    if (way === "there") return;
    await page.keyboard.press(way === "back" ? "Shift+Tab" : "Tab");
  }
  throw new Error("Tab does not lead there");
}

async function setByKeyboard(page: Page, label: string, setting: Setting): Promise<void> {
  if (typeof setting === "string") {
    await tabTo(page, field(page, label));
    await page.keyboard.press("Control+a");
    return page.keyboard.type(setting);
  }
  if ("press" in setting) {
    await tabTo(page, form(page).getByRole("button", { name: setting.press }));
    return page.keyboard.press("Enter");
  }
  await tabTo(page, list(page, label));
  await page.keyboard.press("Enter");
  await page.getByRole("option").first().waitFor();
  await page.keyboard.type(setting.choose);
  await page.keyboard.press("Enter");
  await page.getByRole("option").first().waitFor({ state: "detached" });
  // The focus comes back with the next frame.
  await list(page, label).and(page.locator(":focus")).waitFor();
}

export async function dialogByKeyboard(page: Page, name: string, settings: Record<string, Setting> = {}): Promise<void> {
  await page.keyboard.press("Enter");
  await form(page).waitFor();
  for (const [label, setting] of Object.entries(settings)) await setByKeyboard(page, label, setting);
  await tabTo(page, field(page, "Name"));
  await page.keyboard.press("Control+a");
  await page.keyboard.type(name);
  await page.keyboard.press("Tab");
  await page.keyboard.press("Escape");
  await form(page).waitFor({ state: "detached" });
  await page.locator(`.icon[data-id="${name}"]:focus`).waitFor();
}

/** Each icon comes behind the one that has the focus, if that has an open output; the other lines by "connect to…". */
export async function drawByKeyboard(page: Page, icons: readonly Wanted[]): Promise<void> {
  await page.locator(".canvas").focus();
  for (const each of icons) {
    // From which icon a line leads here.
    const from = icons.find((one) => Object.values(one.lines ?? {}).includes(each.id));
    const there = await page.locator(".icon").evaluateAll((all) => all.map((one) => (one as HTMLElement).dataset.id!));
    if (from && there.includes(from.id)) await walkTo(page, from.id);
    await insert(page, firstName(each.offer) === "done" ? "exit" : firstName(each.offer));
    await page.locator(".icon:focus").waitFor();
    if (each.offer !== "start") await dialogByKeyboard(page, each.id, each.settings);
  }
  for (const each of icons)
    for (const [port, to] of Object.entries(each.lines ?? {})) {
      await walkTo(page, each.id);
      // The first press takes an open output, each further one the next.
      for (let i = 0; i < 8; ++i) {
        await page.keyboard.press("Control+l");
        if (await icon(page, each.id).locator(`.connector.out[data-line-from][data-handleid="${port}"]`).count() > 0) break;
      }
      await walkTo(page, to);
      await page.keyboard.press("Control+Enter");
    }
}
