// PAL in VS Code: everything that is said of a text comes from `pal language-server`; this only shows it.
import * as vscode from "vscode";
import { Pictures } from "./pictures";
import type { PictureKind } from "./protocol";
import { Requirements } from "./requirements";
import { program, Server } from "./server";
import { taskProvider } from "./tasks";
import { Texts } from "./texts";

/** The arguments of the server's code lenses; without them a command is meant for the text before the user. */
interface LensArguments {
  uri: string;
  skill: string;
  module?: string;
  requirement?: string;
  environmentUri?: string;
}

function activeUri(): string | undefined {
  const active = vscode.window.activeTextEditor ?? vscode.window.visibleTextEditors.find((each) => each.document.languageId === "pal");
  return active?.document.languageId === "pal" ? active.document.uri.toString() : undefined;
}

/** Buttons of the title give a Uri, code lenses their arguments. */
function argumentsOf(given: unknown): LensArguments | undefined {
  if (given instanceof vscode.Uri) return { uri: given.toString(), skill: "" };
  if (typeof given === "object" && given !== null && "uri" in given) return given as LensArguments;
  const uri = activeUri();
  return uri === undefined ? undefined : { uri, skill: "" };
}

async function choosePal(): Promise<void> {
  const chosen = await vscode.window.showOpenDialog({ canSelectMany: false, title: "The program pal", openLabel: "Use This" });
  if (chosen?.[0] !== undefined) await vscode.workspace.getConfiguration("pal").update("path", chosen[0].fsPath, vscode.ConfigurationTarget.Global);
}

async function runInWorkcell(given: LensArguments): Promise<void> {
  const workcell = program("workcell");
  if (workcell === undefined) {
    await vscode.window.showErrorMessage("The program workcell is not on the path, and the setting pal.workcellPath names none.");
    return;
  }
  const run = new vscode.ProcessExecution(workcell, ["run", given.skill]);
  const made = new vscode.Task({ type: "process" }, vscode.TaskScope.Workspace, `run ${given.skill}`, "pal", run);
  await vscode.tasks.executeTask(made);
}

export async function activate(context: vscode.ExtensionContext): Promise<void> {
  const server = new Server();
  const pictures = new Pictures(server, context.extensionUri);
  const texts = new Texts();
  const show = (kind: PictureKind) => (given: unknown) => {
    const of = argumentsOf(given);
    if (of !== undefined) pictures.show(kind, { uri: of.uri, skill: of.skill, module: of.module ?? "", requirement: of.requirement ?? "", letters: false });
  };
  const command = (name: string, does: (given: unknown) => unknown) => vscode.commands.registerCommand(name, does);
  context.subscriptions.push(
    server,
    pictures,
    new Requirements(server),
    vscode.workspace.registerTextDocumentContentProvider("pal-text", texts),
    vscode.tasks.registerTaskProvider("pal", taskProvider),
    command("pal.showGraph", show("pan")),
    command("pal.showChart", show("atc")),
    command("pal.whatIf", (given) => {
      const of = argumentsOf(given);
      const environment = of?.environmentUri === undefined || of.environmentUri === "" ? undefined : vscode.Uri.parse(of.environmentUri);
      return of === undefined ? undefined : texts.whatIf(vscode.Uri.parse(of.uri), of.skill, environment);
    }),
    command("pal.runInWorkcell", (given) => {
      const of = argumentsOf(given);
      return of === undefined ? undefined : runInWorkcell(of);
    }),
    command("pal.explain", (given) => texts.explain(typeof given === "string" ? given : undefined)),
    command("pal.restart", () => server.restart()),
    command("pal.showOutput", () => server.showOutput()),
    command("pal.choosePal", choosePal),
    vscode.workspace.onDidChangeConfiguration((event) => {
      if (event.affectsConfiguration("pal.path") || event.affectsConfiguration("pal.log")) void server.restart();
      else if (event.affectsConfiguration("pal")) server.configure();
    }),
  );
  await server.start();
}

export function deactivate(): void {}
