// The tutorial's first steps in a real VS Code, without a terminal, then a skill of the workcell:
// drive.mjs CODE_SERVER NODE VSIX PAL WORKCELL SOURCE_DIR PICTURES. CODE_SERVER: the folder of the package code-server; NODE: the Node that
// it needs. Ends with 0 if every step did what it should.
import assert from "node:assert/strict";
import { spawn, spawnSync } from "node:child_process";
import { cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { createServer } from "node:net";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { chromium } from "playwright-core";

const [codeServer, node, vsix, pal, workcell, source, pictures] = process.argv.slice(2).map((each) => resolve(each));
const work = mkdtempSync(join(tmpdir(), "pal-editor-"));
const folder = join(work, "dip"), skills = join(work, "skills"), user = join(work, "user"), extensions = join(work, "extensions"), bin = join(work, "bin");
for (const each of [folder, join(user, "User"), extensions, bin, pictures]) mkdirSync(each, { recursive: true });

/** A file of the tutorial, as it is typed there. */
function fromTutorial(name) {
  const text = readFileSync(join(source, "docs/tutorial.md"), "utf8");
  const found = new RegExp("```\\w+ file=" + name.replace(".", "\\.") + "\\n([\\s\\S]*?)```").exec(text);
  assert.ok(found, `${name} is in the tutorial`);
  return found[1];
}
writeFileSync(join(folder, "dip.pal"), fromTutorial("dip.pal"));
writeFileSync(join(folder, "bench.pal"), fromTutorial("bench.pal"));
cpSync(join(source, "skills_pal"), skills, { recursive: true, filter: (each) => !/\.(cpp|hpp|txt)$/.test(each) });
symlinkSync(pal, join(bin, "pal"));
symlinkSync(workcell, join(bin, "workcell"));
const programs = { "pal.path": join(bin, "pal"), "pal.workcellPath": join(bin, "workcell") }; // the path is that of a login shell
const settings = {
  "workbench.colorTheme": "Light Modern", "workbench.startupEditor": "none", "editor.minimap.enabled": false, "telemetry.telemetryLevel": "off",
  "security.workspace.trust.enabled": false, "chat.disableAIFeatures": true, "workbench.secondarySideBar.defaultVisibility": "hidden", "editor.fontSize": 13,
  "window.commandCenter": false, "workbench.layoutControl.enabled": false, "extensions.ignoreRecommendations": true, "update.mode": "none", "editor.fontFamily": "DejaVu Sans Mono",
  "editor.accessibilitySupport": "off", "pal.proofTimeSeconds": 20, "terminal.integrated.gpuAcceleration": "off", "terminal.integrated.fontSize": 12, "files.simpleDialog.enable": true, ...programs,
};
writeFileSync(join(user, "User/settings.json"), JSON.stringify(settings));
mkdirSync(join(user, "Machine"));
writeFileSync(join(user, "Machine/settings.json"), JSON.stringify(programs)); // the settings of the server's machine

const environment = { ...process.env, PATH: `${bin}:/usr/bin:/bin`, HOME: work, VSCODE_PROXY_URI: "" };
const entry = join(codeServer, "out/node/entry.js");
const shared = ["--user-data-dir", user, "--extensions-dir", extensions];
const installed = spawnSync(node, [entry, ...shared, "--install-extension", vsix], { env: environment, encoding: "utf8" });
assert.equal(installed.status, 0, installed.stdout + installed.stderr);

const port = await new Promise((found) => {
  const probe = createServer();
  probe.listen(0, "127.0.0.1", () => {
    const { port: free } = probe.address();
    probe.close(() => found(free));
  });
});
const server = spawn(node, [entry, ...shared, "--auth", "none", "--bind-addr", `127.0.0.1:${port}`, "--disable-telemetry", "--disable-update-check", "--disable-workspace-trust", folder], { env: environment, stdio: ["ignore", "pipe", "pipe"] });
let said = "";
for (const stream of [server.stdout, server.stderr]) stream.on("data", (bytes) => (said += bytes));

const patience = Number(process.env.PATIENCE ?? 3);
const long = 60000 * patience;
const browser = await chromium.launch({ executablePath: process.env.CHROMIUM ?? "/usr/bin/chromium", args: process.getuid?.() === 0 ? ["--no-sandbox"] : [] });
let page;
let number = 0;
const step = async (name, does) => {
  process.stdout.write(`${String(++number).padStart(2)} ${name} … `);
  const begin = Date.now();
  await does();
  console.log(`${((Date.now() - begin) / 1000).toFixed(1)} s`);
};
const shot = async (name) => {
  await page.mouse.move(640, 893);
  await page.waitForTimeout(300);
  await page.screenshot({ path: join(pictures, `${name}.png`) });
};
const command = async (words) => {
  await page.keyboard.press("F1");
  const input = page.locator(".quick-input-widget input").first();
  await input.waitFor({ timeout: long });
  await input.fill(`>${words}`);
  const row = page.locator(".quick-input-list .monaco-list-row").filter({ hasText: words }).first();
  await row.waitFor({ timeout: long });
  await row.click();
};
/** Of the tasks that the extension has for the text before the user: they stand below its name. */
const runTask = async (name) => {
  await command("Tasks: Run Task");
  const rows = page.locator(".quick-input-list .monaco-list-row");
  await rows.getByText("pal", { exact: true }).first().click();
  await rows.getByText(name).first().click();
};
/** Lenses are drawn again when a proof ends, which may be between the press and the release of a button. */
const lens = async (title, opened) => {
  for (let i = 0; i < 20; ++i) {
    await page.locator(".codelens-decoration a", { hasText: title }).first().click();
    if (await opened().waitFor({ timeout: 5000 * patience }).then(() => true, () => false)) return;
  }
  throw new Error(`the lens '${title}' opens nothing`);
};
const tab = (title) => page.locator(".tab").filter({ hasText: title }).first();
/** What a program wrote to the terminal. */
const terminal = (text) => page.locator(".terminal.xterm .xterm-rows > div").filter({ hasText: text }).first();
/** The menu of cures at the cursor, once it has this one: what is tried or proved comes later. */
const cures = async (title) => {
  const offered = page.locator(".action-widget").getByText(title).first();
  for (let i = 0; i < 30; ++i) {
    await page.keyboard.press("Control+.");
    if (await offered.waitFor({ timeout: 2000 * patience }).then(() => true, () => false)) return offered;
    await page.keyboard.press("Escape");
  }
  throw new Error(`no cure '${title}' is offered`);
};
const hint = (text) => page.locator(".view-lines").getByText(text).first();
/** The document of a picture: VS Code has it in a frame in a frame. */
const picture = (title) => page.frameLocator(`.webview.ready >> nth=${title === "PAN" ? -1 : 0}`).frameLocator("#active-frame");
const status = () => page.locator(".statusbar-item").filter({ hasText: /^Ln \d+/ }).first().innerText();

try {
  page = await (await browser.newContext({ viewport: { width: 1440, height: 900 }, locale: "en-US", reducedMotion: "reduce" })).newPage();
  page.setDefaultTimeout(long);
  const policy = [];
  page.on("console", (message) => /content security policy/i.test(message.text()) && /picture\.(js|css)|pal/.test(message.text()) && policy.push(message.text()));

  await step("VS Code opens the folder", async () => {
    for (let i = 0; ; ++i) {
      try {
        await page.goto(`http://127.0.0.1:${port}/?folder=${folder}`);
        break;
      } catch (error) {
        if (i > 200 * patience || server.exitCode !== null) throw new Error(`${error}\n${said}`);
        await new Promise((later) => setTimeout(later, 300));
      }
    }
    await page.locator(".monaco-workbench").waitFor();
    await page.locator(".explorer-viewlet").getByText("dip.pal").dblclick();
    await page.locator(".view-lines").getByText("Lowers a probe").first().waitFor();
  });

  await step("the mistake is underlined", async () => {
    await page.locator(".squiggly-error").first().waitFor();
    await page.locator(".marker-count, .statusbar-item").filter({ hasText: "1" }).first().waitFor();
    await page.keyboard.press("F8");
    await page.getByText("there is no module or device 'Guage'").first().waitFor();
    await shot("editor-finding");
    await page.keyboard.press("Escape");
  });

  await step("its cure is applied", async () => {
    await cures("replace 'Guage' by 'Gauge'");
    await shot("editor-cure");
    await page.keyboard.press("Enter");
    await page.locator(".view-lines").getByText("Guage").waitFor({ state: "detached" });
  });

  await step("the bounds appear, and one fails", async () => {
    await page.keyboard.press("Control+Home");
    await hint("20.35 ms of 10 ms, exact, fails").waitFor();
    await hint("350 us of 8 ms, exact").waitFor();
    await shot("editor-bounds");
  });

  await step("the worst run is drawn beside the text", async () => {
    await lens("chart", () => tab("ATC"));
    await picture("ATC").locator("svg .place").first().waitFor();
    await page.waitForTimeout(500);
    await shot("editor-chart");
  });

  await step("a click on a bar leads to its statement, and the cursor back to the bar", async () => {
    const bar = picture("ATC").locator("svg .place");
    const count = await bar.count();
    assert.ok(count > 5, `${count} bars`);
    let selected = "";
    for (let i = 0; i < count && !/selected/.test(selected); ++i) {
      const box = await bar.nth(i).boundingBox();
      if (box === null || box.width < 3 || box.height < 3) continue;
      await bar.nth(i).click({ timeout: 5000 }).catch(() => undefined);
      await page.waitForTimeout(400);
      selected = await status();
    }
    assert.match(selected, /Ln \d+, Col \d+ \(\d+ selected\)/);
    await picture("ATC").locator("svg .place.marked").first().waitFor();
    await shot("editor-click");
  });

  await step("the cure that was tried is applied", async () => {
    await page.keyboard.press("Control+1");
    await page.keyboard.press("Control+g");
    const line = readFileSync(join(folder, "dip.pal"), "utf8").split("\n").findIndex((each) => each.includes("REQUIREMENT fresh-level")) + 1;
    await page.locator(".quick-input-widget input").first().fill(`:${line}:5`);
    await page.keyboard.press("Enter");
    const offered = await cures("wait for tick before sensing wet");
    await shot("editor-remedy");
    await offered.click();
    await page.keyboard.press("Control+Home");
    await hint("300 us of 10 ms, exact").waitFor();
    await hint("7 ms of 8 ms, exact").waitFor();
    await picture("ATC").locator("#state", { hasText: "holds" }).waitFor();
    await page.keyboard.press("Control+s");
    await shot("editor-mended");
  });

  await step("requirements are tests", async () => {
    await command("Testing: Focus on Test Explorer View");
    await command("Test: Run All Tests");
    await page.locator(".test-explorer .monaco-list-row").first().waitFor();
    await page.locator(".test-explorer .codicon-testing-passed-icon").first().waitFor();
    await page.locator(".test-explorer .monaco-list-row").first().click();
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("ArrowRight");
    await page.keyboard.press("ArrowRight");
    await page.waitForTimeout(500);
    await shot("editor-tests");
    await page.keyboard.press("Control+j"); // the panel with results goes
    assert.equal(await page.locator(".test-explorer .codicon-testing-failed-icon").count(), 0);
  });

  await step("the slack stands beside the times", async () => {
    await command("View: Show Explorer");
    await page.locator(".explorer-viewlet").getByText("bench.pal").dblclick();
    await hint("slack 1 ms").waitFor();
    await shot("editor-slack");
  });

  await step("what if", async () => {
    await page.locator(".tab").filter({ hasText: "dip.pal" }).first().click();
    await lens("what if", () => terminal("all together"));
    await terminal("Terminal will be reused").waitFor();
    await shot("editor-what-if");
  });

  await step("the module at the cursor is drawn as a graph", async () => {
    await page.locator(".tab").filter({ hasText: "dip.pal" }).first().click();
    await command("PAL: Show the Graph of the Module (PAN)");
    await page.locator(".tab").filter({ hasText: "PAN: " }).waitFor();
    await picture("PAN").locator("svg .place").first().waitFor();
    await page.waitForTimeout(500);
    await shot("editor-graph");
  });

  await step("a picture is saved", async () => {
    await picture("PAN").locator("#save").click();
    const name = page.locator(".quick-input-widget input").first();
    const saved = join(folder, "Dipper_of_dip.svg");
    await page.waitForFunction((path) => document.querySelector(".quick-input-widget input")?.value === path, saved);
    await name.press("Enter");
    for (let i = 0; i < 50 && !existsSync(saved); ++i) await page.waitForTimeout(200);
    assert.match(readFileSync(saved, "utf8"), /<svg[^]*WTM[^]*<\/svg>/);
  });

  await step("a task checks the file", async () => {
    await tab("dip.pal").click();
    await runTask("check dip.pal");
    await terminal("1 ms to spare").waitFor();
    await shot("editor-task");
    await page.keyboard.press("Control+j");
  });

  await step("a dark theme turns the pictures dark", async () => {
    await command("Preferences: Toggle between Light/Dark Themes");
    await page.locator(".monaco-workbench.vs-dark").waitFor();
    await page.waitForTimeout(1500);
    await shot("editor-dark-graph");
    await page.locator(".tab").filter({ hasText: "ATC: " }).first().click();
    await page.waitForTimeout(1000);
    await shot("editor-dark-chart");
  });

  await step("a skill runs in the workcell", async () => {
    await page.goto(`http://127.0.0.1:${port}/?folder=${skills}`);
    await page.locator(".explorer-viewlet").getByText("touch", { exact: true }).first().click();
    await page.locator(".explorer-viewlet").getByText("touch.pal").first().dblclick();
    await lens("run in the workcell", () => terminal("fresh-force: measured"));
    await shot("editor-workcell");
  });

  await step("a task of a skill whose environment stands elsewhere", async () => {
    await page.locator(".view-lines").first().click();
    await runTask("check touch/touch.pal");
    await terminal("touch in workcell").waitFor();
    await shot("editor-task-touch");
  });

  assert.deepEqual(policy, [], "the page of a picture keeps to its policy");
  console.log(`pictures are in ${pictures}`);
} catch (error) {
  if (page !== undefined) await page.screenshot({ path: join(pictures, "failed.png") }).catch(() => undefined);
  console.error(`\n${error.stack}\npicture: ${join(pictures, "failed.png")}\n${said.slice(-2000)}`);
  process.exitCode = 1;
} finally {
  await browser.close();
  server.kill();
  if (process.env.KEEP === undefined) rmSync(work, { recursive: true, force: true });
  else console.log(`kept: ${work}`);
}
