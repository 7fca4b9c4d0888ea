// The language server's life: found, started, started again, and what to do where there is no pal.
import * as vscode from "vscode";
import { LanguageClient, type ServerOptions } from "vscode-languageclient/node";
import { findProgram, versionOf } from "./find";
import type { Changed, SkillRequirements } from "./protocol";

/** Those that the server may put into code lenses: the extension carries them out. */
export const lensCommands = ["pal.showGraph", "pal.showChart", "pal.whatIf", "pal.runInWorkcell"];

export function settings(): vscode.WorkspaceConfiguration {
  return vscode.workspace.getConfiguration("pal");
}

/** What the server is told: as initializationOptions, and again when a setting changes. */
export function serverSettings(of: vscode.WorkspaceConfiguration = settings()): Record<string, unknown> {
  return {
    environments: of.get("environments"),
    proofTimeSeconds: of.get("proofTimeSeconds"),
    inlayHints: of.get("inlayHints"),
    commands: of.get("codeLenses") ? lensCommands : [],
    pictures: true,
  };
}

export function program(name: "pal" | "workcell"): string | undefined {
  const set = settings().get<string>(name === "pal" ? "path" : "workcellPath") ?? "";
  return findProgram(name, set, vscode.workspace.workspaceFolders?.[0]?.uri.fsPath);
}

export class Server implements vscode.Disposable {
  private client: LanguageClient | undefined;
  private readonly output = vscode.window.createOutputChannel("PAL");
  private readonly changes = new vscode.EventEmitter<Changed>();
  private readonly status = vscode.languages.createLanguageStatusItem("pal", [{ language: "pal" }, { language: "pal-operation" }]);
  /** The server says that pictures or proofs have changed. */
  readonly changed = this.changes.event;

  constructor() {
    this.status.name = "PAL";
    this.status.command = { command: "pal.showOutput", title: "output" };
  }

  async start(): Promise<void> {
    const found = program("pal");
    const version = found === undefined ? undefined : await versionOf(found);
    await vscode.commands.executeCommand("setContext", "pal.found", version !== undefined);
    if (found === undefined || version === undefined) {
      const set = settings().get<string>("path") ?? "";
      this.say(found === undefined ? (set === "" ? "pal is not on the path" : `there is no program ${set}`) : `${found} is no pal of PAL`, vscode.LanguageStatusSeverity.Error);
      void this.offer(found);
      return;
    }
    const log = settings().get<string>("log") ?? "";
    const run: ServerOptions = { command: found, args: ["language-server", ...(log === "" ? [] : ["--log", log])] };
    const client = new LanguageClient("pal", "PAL", run, {
      documentSelector: [
        { scheme: "file", language: "pal" },
        { scheme: "file", language: "pal-operation" },
      ],
      initializationOptions: serverSettings(),
      outputChannel: this.output,
    });
    this.client = client;
    client.onNotification("pal/changed", (changed: Changed) => this.changes.fire(changed));
    try {
      await client.start();
      this.say(`pal ${version}`, vscode.LanguageStatusSeverity.Information);
    } catch (error) {
      this.say(`the language server does not start: ${String(error)}`, vscode.LanguageStatusSeverity.Error);
    }
  }

  async restart(): Promise<void> {
    await this.client?.dispose();
    this.client = undefined;
    await this.start();
  }

  /** Undefined: there is no server, or it has no answer. */
  async ask<Result>(method: string, params: unknown): Promise<Result | undefined> {
    if (this.client === undefined || !this.client.isRunning()) return undefined;
    try {
      return await this.client.sendRequest<Result>(method, params);
    } catch (error) {
      this.output.appendLine(`${method}: ${String(error)}`);
      return undefined;
    }
  }

  /** The skills that see a file, with what is known of their requirements. */
  async skillsOf(uri: string): Promise<SkillRequirements[]> {
    return (await this.ask<SkillRequirements[]>("pal/requirements", { textDocument: { uri } })) ?? [];
  }

  configure(): void {
    if (this.client?.isRunning()) void this.client.sendNotification("workspace/didChangeConfiguration", { settings: { pal: serverSettings() } });
  }

  showOutput(): void {
    this.output.show(true);
  }

  private say(text: string, severity: vscode.LanguageStatusSeverity): void {
    this.status.text = text;
    this.status.severity = severity;
  }

  private async offer(found: string | undefined): Promise<void> {
    const choose = "Choose Where pal Is", how = "How to Get It";
    const set = settings().get<string>("path") ?? "";
    const text = found === undefined ? (set === "" ? "The program pal is not on the path, so nothing is checked." : `The setting pal.path names no program: ${set}. So nothing is checked.`) : `${found} is another program of that name, so nothing is checked.`;
    const answer = await vscode.window.showErrorMessage(text, choose, how);
    if (answer === choose) await vscode.commands.executeCommand("pal.choosePal");
    if (answer === how) await vscode.commands.executeCommand("workbench.action.openWalkthrough", "pal.pal#first-skill", false);
  }

  async dispose(): Promise<void> {
    this.status.dispose();
    this.changes.dispose();
    await this.client?.dispose();
    this.output.dispose();
  }
}
