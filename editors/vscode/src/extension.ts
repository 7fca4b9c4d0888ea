// PAL in VS Code: everything that is said of a text comes from `pal language-server`; this only shows it.
import * as vscode from "vscode";
import { Pictures } from "./pictures";
import type { PictureKind, SkillRequirements } from "./protocol";
import { Requirements } from "./requirements";
import { Server } from "./server";
import { runInWorkcell, taskProvider, whatIf } from "./tasks";
import { Texts } from "./texts";

/** The arguments of the server's code lenses; without them a command is meant for the text before the user. */
interface LensArguments {
  uri: string;
  skill: string;
  module?: string;
  requirement?: string;
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

/** The skill that is meant, and its environment; of several in a text the one that the user chooses. */
async function skillOf(given: LensArguments, server: Server): Promise<SkillRequirements | undefined> {
  const known = (await server.skillsOf(given.uri)).filter((each) => given.skill === "" || each.skill === given.skill);
  if (known.length < 2) return known[0];
  const chosen = await vscode.window.showQuickPick(known.map((each) => each.skill), { title: "Skill" });
  return known.find((each) => each.skill === chosen);
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
  const ofSkill = (does: (skill: SkillRequirements) => Promise<void>) => async (given: unknown) => {
    const of = argumentsOf(given);
    const skill = of === undefined ? undefined : await skillOf(of, server);
    if (skill !== undefined) await does(skill);
  };
  context.subscriptions.push(
    server,
    pictures,
    new Requirements(server),
    vscode.workspace.registerTextDocumentContentProvider("pal-text", texts),
    vscode.tasks.registerTaskProvider("pal", taskProvider(server)),
    command("pal.showGraph", show("pan")),
    command("pal.showChart", show("atc")),
    command("pal.whatIf", ofSkill(whatIf)),
    command("pal.runInWorkcell", ofSkill(runInWorkcell)),
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
