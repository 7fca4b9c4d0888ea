// A page does not grow while its windows stay open: nothing is set again that is shown already. React keeps each such update until the
// component is rendered again, so a window that shows a cell at rest would grow for as long as it is open.
import assert from "node:assert/strict";
import { after, before, test } from "node:test";
import type { Browser, Page } from "playwright-core";
import { act, browser, errors, imported, openPage, untilState } from "./browser";
import { cell } from "./cell";

let chromium: Browser;
before(async () => void (chromium = await browser()));
after(() => chromium.close());

const operation = JSON.stringify({
  "operation-format": 1, name: "up", icons: [
    { id: "start", kind: "start", next: "up" }, { id: "up", kind: "skill", skill: "relative-move", parameters: { dz: -10 }, next: "end", error: "end" }, { id: "end", kind: "exit" }],
});
const windows = ["Force", "Position of the tool", "Joints", "Requirements", "Sensors", "The cell in 3-D"];

/** The components with more than two updates that wait; and how many places for updates there are at all. */
function waiting(page: Page): Promise<{ places: number; of: { name: string; count: number }[] }> {
  return page.evaluate(() => {
    interface Update { next: Update }
    interface Hook { queue: { pending?: Update | null } | null; next: Hook | null }
    interface Fiber { type: unknown; memoizedState: Hook | null; child: Fiber | null; sibling: Fiber | null }
    const root = [...document.querySelectorAll("*")].flatMap((each) => Object.entries(each)).find(([name]) => name.startsWith("__reactContainer$"))?.[1] as { stateNode: { current: Fiber } };
    let places = 0;
    const of: { name: string; count: number }[] = [];
    const walk = (fiber: Fiber | null): void => {
      for (; fiber; fiber = fiber.sibling) {
        if (typeof fiber.type === "function")
          for (let hook = fiber.memoizedState; hook; hook = hook.next) {
            if (!hook.queue || !("pending" in hook.queue)) continue;
            ++places;
            const last = hook.queue.pending;
            let count = 0;
            if (last) for (let each = last; ; each = each.next) if (++count > 10_000 || each.next === last) break;
            // A window may set once what it shows already, when it opens.
            if (count > 2) of.push({ name: (fiber.type as { name: string }).name, count });
          }
        walk(fiber.child);
      }
    };
    walk(root.stateNode.current);
    return { places, of };
  });
}

test("windows on a cell, in a run and at rest, keep no updates that change nothing", async () => {
  const served = await cell("touch", ["--paced", "2"]);
  const page = await openPage(chromium, served.url);
  try {
    await imported(page, operation);
    for (const name of windows) {
      await page.getByRole("button", { name: "Windows on the cell" }).click();
      await page.locator(".menu-item", { has: page.locator(".name", { hasText: new RegExp(`^${name}$`) }) }).click();
    }
    await act(page, "run").click();
    await untilState(page, "Running");
    await page.waitForFunction(() => /Tool: x [\d.−-]+/.test(document.querySelector(".scene-told")?.textContent ?? ""));
    await untilState(page, "Ended");
    await page.waitForTimeout(3000);
    const before = await waiting(page);
    await page.waitForTimeout(3000);
    const { places, of } = await waiting(page);
    assert.ok(places > 100, `React has ${places} places for updates`);
    // A busy machine is late with what has just been set, here or there; what grows waits both times.
    const both = of.filter(({ name }) => before.of.some((each) => each.name === name));
    assert.deepEqual(both, [], "updates that wait");
    assert.deepEqual(errors.get(page), []);
  } finally {
    await page.context().close();
    await served.end();
  }
});
