// A walk through the windows that belong to a drawing. With PICTURES=FOLDER it keeps a picture of each.
import type { Page } from "playwright-core";
import { noViolation } from "./axe";
import { icon, printed, shot } from "./browser";

/** Every window in turn: axe-core looks at the whole page first, then at what was opened. */
export async function tour(page: Page, name: string): Promise<void> {
  const look = async (what: string, part = ".window") => {
    await shot(page, `${name}-${what}`);
    await noViolation(page, `${name}, ${what}`, part);
  };
  await shot(page, `${name}-canvas`);
  await noViolation(page, `${name}, canvas`);
  await page.locator(".state-bounds").click();
  await page.locator('[data-window="ways"] li').first().waitFor();
  await look("ways");
  await page.locator('[data-window="ways"] .window-head button').click();
  await icon(page, "find").dblclick({ position: { x: 60, y: 8 } });
  await look("dialog");
  await page.locator('[data-window="icon"] .window-foot button').first().click();
  await page.locator('[data-window="skill"] table').first().waitFor();
  await look("help");
  await page.keyboard.press("Escape");
  await page.locator('[data-window="icon"] .window-head button').click();
  await icon(page, "found").dblclick({ position: { x: 60, y: 8 } });
  await look("case");
  await page.locator('[data-window="icon"] .window-head button').click();
  await page.locator(".file").click();
  await look("file-menu", ".popover");
  await page.locator('[data-key="story"]').click();
  await page.locator('[data-window="storyboard"] .story-picture').first().waitFor();
  await look("storyboard");
  await printed(page, ".story-picture", [".page", ".story-print"]);
  await page.locator('[data-window="storyboard"] .window-head button').click();
  await page.keyboard.press("Control+o");
  await page.locator('[data-window="store"] .window-body > :not(.loading)').first().waitFor();
  await look("store");
  await page.locator('[data-window="store"] .window-head button').click();
  await page.keyboard.press("F1");
  await page.locator('[data-window="keys"] .help').waitFor();
  await look("keys");
  await page.locator('[data-window="keys"] .window-head button').click();
  await rest(page, name, look);
}

/** Windows that come of something: breakpoints, findings with their pages, a planned skill, a save and its versions. By keys, not by words: it serves every language. */
async function rest(page: Page, name: string, look: (what: string, part?: string) => Promise<void>): Promise<void> {
  const close = async (window: string) => {
    await page.locator(`[data-window="${window}"] .window-head button`).click();
    await page.locator(`[data-window="${window}"]`).waitFor({ state: "detached" });
  };
  await icon(page, "lift").click({ button: "right", position: { x: 60, y: 10 } });
  await look("icon-menu", ".popover");
  await page.locator('[data-key="break"]').click();
  await icon(page, "lift").locator(".mark-break").waitFor();
  await page.locator('.bar-part [aria-haspopup="true"]').last().click();
  await look("settings", ".popover");
  await page.locator('[data-key="breaks"]').click();
  await page.locator('[data-window="breakpoints"] .break-head button').nth(1).click();
  await page.locator(".break-when").waitFor();
  await look("breakpoints");
  await close("breakpoints");
  await icon(page, "lift").focus();
  await page.keyboard.type("r");
  await page.locator(".floating .option").first().waitFor();
  await look("insert", ".floating");
  await page.keyboard.type("zzz");
  await page.locator(".floating .nothing").waitFor();
  await noViolation(page, `${name}, insert nothing`, ".floating");
  await page.keyboard.press("Escape");
  await page.locator('[data-offer="planned"]').dblclick();
  await page.locator('.icon[data-kind="planned"]:focus').waitFor();
  await page.keyboard.press("Enter");
  await page.locator('[data-window="icon"] .window-body > .form > .ways > button').last().click();
  await page.locator(".planned-argument").waitFor();
  await look("planned");
  await close("icon");
  await page.locator('.icon[data-kind="planned"] .mark-finding').click();
  await page.locator('[data-window="findings"] .finding').first().waitFor();
  await look("findings");
  await page.locator('[data-window="findings"] .finding .quiet').first().click();
  await page.locator('[data-window="explain"] .explained').waitFor();
  await look("finding-explained");
  await close("explain");
  await close("findings");
  await page.keyboard.press("Control+s");
  await page.locator(".modal input").fill(`tour-${name}`);
  await look("save", ".modal");
  await page.keyboard.press("Enter");
  await page.locator(".unsaved").waitFor({ state: "detached" });
  await icon(page, "lift").focus();
  await page.keyboard.press("Delete");
  await page.locator(".file").click();
  await page.locator('[data-key="versions"]').click();
  await page.locator('[data-window="versions"] .version-row button').first().click();
  await page.locator(".change").first().waitFor();
  await look("versions");
  await close("versions");
}
