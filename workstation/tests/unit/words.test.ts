// No text is missing in a language, none is unused, and none stands in the source outside the catalogues.
import assert from "node:assert/strict";
import { readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";
import { test } from "node:test";
import english from "../../src/words/en.json";
import french from "../../src/words/fr.json";
import { duration, fill } from "../../src/words/words";

const source = join(process.env.WORKSTATION!, "src");
const files = (readdirSync(source, { recursive: true }) as string[]).filter((each) => /\.tsx?$/.test(each)).map((each) => ({ name: each, text: readFileSync(join(source, each), "utf8") }));
const placeholders = (text: string) => [...new Set([...text.matchAll(/\{(\w+)/g)].map((each) => each[1]))].sort();

test("every language has every text, with the same values", () => {
  assert.deepEqual(Object.keys(french).sort(), Object.keys(english).sort());
  for (const [key, text] of Object.entries(english)) {
    assert.notEqual(text.trim(), "", key);
    assert.deepEqual(placeholders(french[key as keyof typeof french]), placeholders(text), key);
  }
});

test("every text is used", () => {
  const all = files.map((each) => each.text).join("\n");
  const begun = [...all.matchAll(/`(\w+)\.(?:\w+\.)?\$\{/g)].map((each) => each[1]);
  const unused = Object.keys(english).filter((key) => !all.includes(`"${key}"`) && !begun.includes(key.split(".")[0]!));
  assert.deepEqual(unused, []);
});

test("no text stands in the components", () => {
  const found: string[] = [];
  for (const { name, text } of files) {
    if (!name.endsWith(".tsx")) continue;
    const code = text.replace(/\/\/.*$/gm, "").replace(/\/\*[\s\S]*?\*\//g, "");
    // Between tags: letters that are no expression. The file of licences is named as it is called.
    for (const each of code.matchAll(/(?<![=\-])>([^<>{}()=;&|?]*[A-Za-z\u00c0-\u017f]{2,}[^<>{}()=;&|?]*)<\/?[A-Za-z]/g)) if (!each[1]!.includes("LICENSES.txt")) found.push(`${name}: ${each[1]}`);
    for (const each of code.matchAll(/(?:aria-label|title|placeholder|label|hint|alt)="([^"]*[A-Za-z]{2,}[^"]*)"/g)) found.push(`${name}: ${each[1]}`);
  }
  assert.deepEqual(found, []);
});

test("plurals by language", () => {
  assert.equal(fill("{count|one icon|{count} icons}", { count: 1 }, "en"), "one icon");
  assert.equal(fill("{count|one icon|{count} icons}", { count: 0 }, "en"), "0 icons");
  assert.equal(fill("{count|une icône|{count} icônes}", { count: 0 }, "fr"), "une icône");
  assert.equal(fill("{a} – {b}", { a: "x" }, "en"), "x – {b}");
});

test("a length of time has no more digits than it means", () => {
  assert.deepEqual([0, 0.35, 4.24, 38.2, 119.6, 120, 125, 300, 7200].map(duration), ["0 s", "0.35 s", "4.2 s", "38 s", "120 s", "2 min", "2 min 5 s", "5 min", "2 h"]);
});
