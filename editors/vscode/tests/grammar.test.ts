// The TextMate grammar against the lexer: its words are PalLexer's, and every PAL file of the tree is coloured by it as
// the language server, which asks the lexer, colours it.
import assert from "node:assert/strict";
import { readdirSync, readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { join } from "node:path";
import { pathToFileURL } from "node:url";
import { after, before, test } from "node:test";
import { createOnigScanner, createOnigString, loadWASM } from "vscode-oniguruma";
import { INITIAL, Registry, parseRawGrammar, type IGrammar } from "vscode-textmate";
import { Client } from "./client";

const { EXTENSION: extension, PAL: pal, SOURCE: source } = process.env as Record<string, string>;
const text = readFileSync(join(extension!, "syntaxes/pal.tmLanguage.json"), "utf8");
let grammar: IGrammar, client: Client, types: string[];

before(async () => {
  const wasm = readFileSync(createRequire(join(extension!, "package.json")).resolve("vscode-oniguruma/release/onig.wasm"));
  await loadWASM(wasm.buffer.slice(wasm.byteOffset, wasm.byteOffset + wasm.byteLength));
  const registry = new Registry({
    onigLib: Promise.resolve({ createOnigScanner, createOnigString }),
    loadGrammar: async () => parseRawGrammar(text, "pal.json"),
  });
  grammar = (await registry.loadGrammar("source.pal"))!;
  client = new Client(pal!);
  const answer = await client.ask<{ capabilities: { semanticTokensProvider: { legend: { tokenTypes: string[] } } } }>("initialize", { capabilities: {}, initializationOptions: { proofTimeSeconds: 0 } });
  types = answer.capabilities.semanticTokensProvider.legend.tokenTypes;
  client.tell("initialized", {});
});
after(() => client.end());

interface Token {
  line: number;
  begin: number;
  end: number;
  text: string;
  scope: string;
}

function tokens(content: string): Token[] {
  const found: Token[] = [];
  let state = INITIAL;
  content.split(/\r\n|\n|\r/).forEach((row, line) => {
    const result = grammar.tokenizeLine(row, state);
    state = result.ruleStack;
    for (const each of result.tokens) {
      const scope = each.scopes.at(-1)!;
      const written = row.slice(each.startIndex, each.endIndex);
      if (written.trim() !== "") found.push({ line, begin: each.startIndex, end: Math.min(each.endIndex, row.length), text: written, scope });
    }
  });
  return found;
}

/** The words of the lexer's grammar between two of its comments. */
function words(from: string, to: string): string[] {
  const lexer = readFileSync(join(source!, "grammar/PalLexer.g4"), "utf8");
  const begin = lexer.indexOf(from), end = lexer.indexOf(to, begin);
  assert.ok(begin >= 0 && end > begin, `${from} … ${to}`);
  return [...lexer.slice(begin, end).matchAll(/^([A-Z]+)\s*: (?:[A-Z] )+;/gm)].map((each) => each[1]!);
}

test("each word of the lexer has its scope, in any case, and is a part of a longer name", () => {
  const groups: [string[], RegExp][] = [
    [words("// Reserved", "// These begin"), /^(keyword\.(control|operator\.logical)|constant\.language)\.pal$/],
    [words("// These begin", "// These mean"), /^keyword\.declaration\.pal$/],
    [words("// These mean", "LEFT "), /^keyword\.other\.pal$/],
  ];
  let count = 0;
  for (const [all, scope] of groups) {
    for (const word of all) {
      ++count;
      for (const written of [word, word.toLowerCase(), word[0] + word.slice(1).toLowerCase()]) assert.match(tokens(written)[0]!.scope, scope, written);
      for (const name of [`${word}x`, `${word}-x`, `x-${word}`, `${word}_`, `${word}1`, `x${word}`]) {
        const [only, ...more] = tokens(name);
        assert.equal(more.length, 0, name);
        assert.equal(only!.scope, "variable.other.pal", name);
      }
    }
  }
  assert.ok(count > 100, `${count} words`);
});

test("numbers, texts and comments end where the lexer ends them", () => {
  const shape = (written: string) => tokens(written).map((each) => `${each.text.trim()} ${each.scope.split(".")[0]}`);
  assert.deepEqual(shape("5ms"), ["5 constant", "ms variable"]);
  assert.deepEqual(shape("-1.5e-3"), ["-1.5e-3 constant"]);
  assert.deepEqual(shape("a-1"), ["a-1 variable"]);
  assert.deepEqual(shape('"a\\"b" x'), ['"a\\"b" string', "x variable"]);
  assert.deepEqual(shape('"open'), ['"open invalid']);
});

function files(folder: string): string[] {
  return readdirSync(folder, { withFileTypes: true }).flatMap((each) => {
    if (/^(\.|build|node_modules$)/.test(each.name)) return [];
    const path = join(folder, each.name);
    return each.isDirectory() ? files(path) : each.name.endsWith(".pal") ? [path] : [];
  });
}

const reserved = new Set(words("// Reserved", "// These begin"));

/** What a kind of token may look like. A name may be a contextual word: only the server knows which it is. */
function fits(type: string, scope: string, word: string): boolean {
  switch (type) {
    case "comment":
      return scope.startsWith("comment.") || scope.startsWith("punctuation.definition.comment.");
    case "string":
      return scope.startsWith("string.") || scope.startsWith("invalid.illegal.string.");
    case "number":
      return scope === "constant.numeric.pal";
    case "keyword": // also a contextual word that a declaration with a mistake names
      return scope.startsWith("keyword.") || scope === "constant.language.pal" || (scope.startsWith("entity.") && !reserved.has(word.toUpperCase()));
    case "enumMember": // the number of a completion or a contingency
      return scope === "constant.numeric.pal" || fits("name", scope, word);
    default:
      return /^(variable|entity)\./.test(scope) || scope === "keyword.other.pal" || scope === "keyword.declaration.pal";
  }
}

test("every PAL file of the tree has the lexer's colours", async () => {
  const wrong: string[] = [];
  let checked = 0, seen = 0;
  for (const path of files(source!)) {
    const bytes = readFileSync(path);
    const content = bytes.toString("utf8");
    if (bytes.length > 200000 || Buffer.compare(Buffer.from(content), bytes) !== 0) continue; // no UTF-8: no editor shows it
    ++seen;
    const uri = pathToFileURL(path).href;
    client.tell("textDocument/didOpen", { textDocument: { uri, languageId: "pal", version: 1, text: content } });
    const { data } = await client.ask<{ data: number[] }>("textDocument/semanticTokens/full", { textDocument: { uri } });
    client.tell("textDocument/didClose", { textDocument: { uri } });
    const mine = new Map<string, Token>();
    const rows = content.split(/\r\n|\n|\r/);
    for (const each of tokens(content)) mine.set(`${each.line}:${each.begin}`, each);
    let line = 0, column = 0;
    for (let i = 0; i < data.length; i += 5) {
      line += data[i]!;
      column = data[i] === 0 ? column + data[i + 1]! : data[i + 1]!;
      const type = types[data[i + 3]!]!;
      const at = mine.get(`${line}:${column}`);
      ++checked;
      const length = data[i + 2]!;
      const whole = type === "comment" || (at !== undefined && at.end - at.begin === length);
      if (at === undefined || !whole || !fits(type, at.scope, at.text)) wrong.push(`${path}:${line + 1}:${column + 1}: '${rows[line]?.slice(column, column + length)}' is ${type}, not ${at?.scope ?? "the same word"} '${at?.text ?? ""}'`);
    }
  }
  assert.deepEqual(wrong.slice(0, 20), [], `${wrong.length} of ${checked}`);
  assert.ok(seen > 300 && checked > 20000, `${seen} files, ${checked} tokens`);
});
