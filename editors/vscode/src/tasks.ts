// Tasks: what `pal` does with a file, as a task of the editor with the problem matcher $pal; and a run in the workcell.
// A terminal is as wide as the window, shows progress, and takes Ctrl-C.
import * as vscode from "vscode";
import type { SkillRequirements } from "./protocol";
import { program, type Server } from "./server";

export const taskCommands = ["check", "whatif", "atc", "pan", "generate"] as const;

interface PalTask extends vscode.TaskDefinition {
  command: (typeof taskCommands)[number];
  file: string;
  arguments?: string[];
}

export function task(definition: PalTask, folder: vscode.WorkspaceFolder | vscode.TaskScope): vscode.Task | undefined {
  const pal = program("pal");
  if (pal === undefined) return undefined;
  const cwd = typeof folder === "object" ? folder.uri.fsPath : undefined;
  const run = new vscode.ProcessExecution(pal, [definition.command, definition.file, ...(definition.arguments ?? [])], cwd === undefined ? {} : { cwd });
  const made = new vscode.Task(definition, folder, `${definition.command} ${definition.file}`, "pal", run, "$pal");
  made.presentationOptions = { reveal: vscode.TaskRevealKind.Always, clear: true };
  if (definition.command === "check") made.group = vscode.TaskGroup.Test;
  if (definition.command === "generate") made.group = vscode.TaskGroup.Build;
  return made;
}

/** Programs read files, so what was typed is saved first. */
async function saveAll(): Promise<void> {
  for (const document of vscode.workspace.textDocuments) if (document.isDirty && document.languageId === "pal") await document.save();
}

/** Options of pal that name the environment: the one that the server proves with. */
function environmentOf(skill: SkillRequirements | undefined, uri: vscode.Uri): string[] {
  const environment = skill === undefined || skill.environmentUri === "" ? undefined : vscode.Uri.parse(skill.environmentUri);
  return environment === undefined || environment.fsPath === uri.fsPath ? [] : ["--environment", vscode.workspace.asRelativePath(environment, false)];
}

export async function whatIf(skill: SkillRequirements): Promise<void> {
  await saveAll();
  const uri = vscode.Uri.parse(skill.uri);
  const folder = vscode.workspace.getWorkspaceFolder(uri) ?? vscode.TaskScope.Workspace;
  const made = task({ type: "pal", command: "whatif", file: vscode.workspace.asRelativePath(uri, false), arguments: ["--skill", skill.skill, ...environmentOf(skill, uri)] }, folder);
  if (made !== undefined) await vscode.tasks.executeTask(made);
}

export async function runInWorkcell({ skill }: SkillRequirements): Promise<void> {
  const workcell = program("workcell");
  if (workcell === undefined) {
    await vscode.window.showErrorMessage("The program workcell is not on the path, and the setting pal.workcellPath names none.");
    return;
  }
  await saveAll();
  const run = new vscode.ProcessExecution(workcell, ["run", skill]);
  await vscode.tasks.executeTask(new vscode.Task({ type: "process" }, vscode.TaskScope.Workspace, `run ${skill}`, "pal", run));
}

export function taskProvider(server: Server): vscode.TaskProvider {
  return {
    async provideTasks() {
      const document = vscode.window.activeTextEditor?.document;
      if (document?.languageId !== "pal") return [];
      const folder = vscode.workspace.getWorkspaceFolder(document.uri) ?? vscode.TaskScope.Workspace;
      const file = vscode.workspace.asRelativePath(document.uri, false);
      const environment = environmentOf((await server.skillsOf(document.uri.toString()))[0], document.uri);
      return taskCommands.flatMap((command) => task({ type: "pal", command, file, arguments: command === "pan" ? [] : environment }, folder) ?? []);
    },
    resolveTask(given) {
      return task(given.definition as PalTask, given.scope === undefined || given.scope === vscode.TaskScope.Global ? vscode.TaskScope.Workspace : given.scope);
    },
  };
}
