// Pick by identity, with its CASE and MERGE icons, by mouse; follow edge again by keyboard alone: from an empty canvas to
// their ends in the workcell. The other way round is in tests/long.
import { after, before, test } from "node:test";
import type { Browser } from "playwright-core";
import { browser } from "./browser";
import { followEdge, pick } from "./thesis";

let chromium: Browser;
before(async () => void (chromium = await browser()));
after(() => chromium.close());

test("pick by identity, by mouse", () => pick(chromium, "mouse"));
test("follow edge again, by keyboard alone", () => followEdge(chromium, "keyboard"));
