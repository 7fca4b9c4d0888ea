// What needs no editor: the program is found, places are marked, the manifest names what is there, findings are matched.
import assert from "node:assert/strict";
import { execFileSync, spawnSync } from "node:child_process";
import { chmodSync, existsSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { test } from "node:test";
import { findProgram, versionOf } from "../src/find";
import { marked } from "../src/places";

const { EXTENSION: extension, PAL: pal } = process.env as Record<string, string>;
const manifest = JSON.parse(readFileSync(join(extension!, "package.json"), "utf8"));

test("pal is found on the path, or where the setting says, and another pal is told apart", async () => {
  const folder = mkdtempSync(join(tmpdir(), "pal-"));
  try {
    const other = join(folder, "pal");
    writeFileSync(other, "#!/bin/sh\necho another 1.0\n");
    assert.equal(findProgram("pal", "", undefined, folder), undefined, "not executable");
    chmodSync(other, 0o755);
    assert.equal(findProgram("pal", "", undefined, `/nowhere:${folder}`), other);
    assert.equal(findProgram("pal", "pal", folder, ""), other);
    assert.equal(findProgram("pal", "/nowhere/pal", folder, folder), undefined);
    assert.equal(await versionOf(other), undefined);
    assert.match((await versionOf(pal!))!, /^\d+\.\d+\.\d+$/);
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test("the cursor marks all elements whose range holds it", () => {
  const range = (line: number, from: number, to: number) => ({ start: { line, character: from }, end: { line, character: to } });
  const places = [
    { id: "a", uri: "file:///x", range: range(3, 4, 9) },
    { id: "b", uri: "file:///x", range: range(3, 4, 9) },
    { id: "c", uri: "file:///y", range: range(3, 4, 9) },
    { id: "d", uri: "file:///x", range: { start: { line: 2, character: 0 }, end: { line: 4, character: 1 } } },
  ];
  assert.deepEqual(marked(places, "file:///x", { line: 3, character: 9 }), ["a", "b", "d"]);
  assert.deepEqual(marked(places, "file:///x", { line: 3, character: 3 }), ["d"]);
  assert.deepEqual(marked(places, "file:///x", { line: 4, character: 2 }), []);
});

test("what the manifest names is there, and what it promises is done", () => {
  const text = JSON.stringify(manifest);
  for (const [, path] of text.matchAll(/"(?:\.\/)?((?:icons|syntaxes|snippets|walkthrough)\/[^"]+)"/g)) assert.ok(existsSync(join(extension!, path!)), path);
  const code = ["extension", "server", "texts", "tasks"].map((each) => readFileSync(join(extension!, `src/${each}.ts`), "utf8")).join("\n");
  for (const { command } of manifest.contributes.commands) assert.ok(code.includes(`"${command}"`), command);
  for (const name of Object.keys(manifest.contributes.configuration.properties)) assert.ok(code.includes(`"${name.slice(4)}"`) || code.includes(`"${name}"`), name);
});

test("the problem matcher takes what pal check prints", () => {
  const [head, place] = manifest.contributes.problemPatterns[0].patterns.map((each: { regexp: string }) => new RegExp(each.regexp));
  const folder = mkdtempSync(join(tmpdir(), "pal-"));
  try {
    writeFileSync(join(folder, "a.pal"), "MESSAGE a : REAL\nMESSAGE a : REAL\n");
    const { stdout, stderr } = spawnSync(pal!, ["check", "a.pal"], { cwd: folder, encoding: "utf8" });
    const lines = `${stdout}\n${stderr}`.split("\n");
    const at = lines.findIndex((each) => head!.test(each));
    assert.ok(at >= 0, stdout);
    assert.equal(head!.exec(lines[at]!)![1], "error");
    assert.equal(place!.exec(lines[at + 1]!)![1], "a.pal");
    assert.equal(place!.exec(lines[at + 1]!)![2], "2");
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test("each snippet that is a whole unit can be laid out", () => {
  const snippets = JSON.parse(readFileSync(join(extension!, "snippets/pal.json"), "utf8")) as Record<string, { body: string | string[] }>;
  const folder = mkdtempSync(join(tmpdir(), "pal-"));
  try {
    for (const name of ["Skill template", "Skill module", "Logical sensor", "Environment"]) {
      const lines = [snippets[name]!.body].flat().join("\n");
      const names = new Map<string, string>();
      for (const [, number, word] of lines.matchAll(/\$\{(\d+):([^}]*)\}/g)) names.set(number!, word!);
      const filled = lines.replace(/\$\{(\d+):([^}]*)\}/g, "$2").replace(/\$(\d+)/g, (_, number: string) => names.get(number) ?? "Do Nothing");
      const file = join(folder, "snippet.pal");
      writeFileSync(file, `${filled}\n`);
      execFileSync(pal!, ["fmt", file], { stdio: ["ignore", "pipe", "pipe"] });
    }
  } finally {
    rmSync(folder, { recursive: true });
  }
});

test("the language has the words that the server's layout has", () => {
  const configuration = JSON.parse(readFileSync(join(extension!, "language-configuration.json"), "utf8"));
  const word = new RegExp(configuration.wordPattern, "g");
  assert.deepEqual("WTM( pc-force from LS1 ) 5.5".match(word), ["WTM", "pc-force", "from", "LS1", "5.5"]);
  const more = new RegExp(configuration.indentationRules.increaseIndentPattern), less = new RegExp(configuration.indentationRules.decreaseIndentPattern);
  assert.ok(more.test("  REPEAT") && more.test("BEGIN") && !more.test("  TXM( a to B )"));
  assert.ok(less.test("  END CASE") && less.test("  UNTIL( forever )") && !less.test("  ENDLESS"));
});

test("labels can be read in dark pictures", () => {
  const source = process.env.SOURCE!;
  const invert = Number(/invert\(([.\d]+)\)/.exec(readFileSync(join(source, "language_server/proof_view.cpp"), "utf8"))![1]);
  const colours = readFileSync(join(source, "analyzer/chart/svg_style.hpp"), "utf8") + readFileSync(join(source, "pal/pan/dot_look.cpp"), "utf8");
  const channels = (colour: string) => [1, 3, 5].map((at) => parseInt(colour.slice(at, at + 2), 16) / 255);
  /** CSS filter effects: invert(), then hue-rotate(180deg). */
  const dark = (colour: string) => {
    const [r, g, b] = channels(colour).map((each) => invert + each * (1 - 2 * invert)) as [number, number, number];
    const rows = [[-0.574, 1.43, 0.144], [0.426, 0.43, 0.144], [0.426, 1.43, -0.856]];
    return rows.map(([x, y, z]) => Math.min(1, Math.max(0, x! * r + y! * g + z! * b)));
  };
  const luminance = (of: number[]) => {
    const [r, g, b] = of.map((each) => (each <= 0.03928 ? each / 12.92 : ((each + 0.055) / 1.055) ** 2.4)) as [number, number, number];
    return 0.2126 * r + 0.7152 * g + 0.0722 * b;
  };
  const contrast = (a: string, b: string) => {
    const [low, high] = [luminance(dark(a)), luminance(dark(b))].sort((x, y) => x - y) as [number, number];
    return (high + 0.05) / (low + 0.05);
  };
  for (const [text, ground] of [["#ffffff", "#0072b2"], ["#000000", "#56b4e9"], ["#000000", "#f0e442"], ["#000000", "#cfe8f8"], ["#000000", "#fbf5b7"], ["#000000", "#ffffff"]] as const) {
    assert.ok(ground === "#ffffff" || colours.includes(ground), `${ground} is no colour of a picture any more`);
    assert.ok(contrast(text, ground) >= 4.5, `${text} on ${ground}: ${contrast(text, ground).toFixed(2)}`);
  }
});
