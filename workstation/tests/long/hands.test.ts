// The same operations by the other hand: pick by identity by keyboard alone, follow edge again by mouse.
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import { browser } from "../browser/browser";
import { followEdge, pick } from "../browser/thesis";

let chromium: Browser;
before(async () => void (chromium = await browser()));
after(() => chromium.close());

test("pick by identity, by keyboard alone", () => pick(chromium, "keyboard"));
test("follow edge again, by mouse", () => followEdge(chromium, "mouse"));
