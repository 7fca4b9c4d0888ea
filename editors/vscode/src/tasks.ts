// Tasks: what `pal` does with a file, as a task of the editor with the problem matcher $pal.
import * as vscode from "vscode";
import { program } from "./server";

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

export const taskProvider: vscode.TaskProvider = {
  provideTasks() {
    const document = vscode.window.activeTextEditor?.document;
    if (document?.languageId !== "pal") return [];
    const folder = vscode.workspace.getWorkspaceFolder(document.uri) ?? vscode.TaskScope.Workspace;
    const file = vscode.workspace.asRelativePath(document.uri, false);
    return taskCommands.flatMap((command) => task({ type: "pal", command, file }, folder) ?? []);
  },
  resolveTask(given) {
    return task(given.definition as PalTask, given.scope === undefined || given.scope === vscode.TaskScope.Global ? vscode.TaskScope.Workspace : given.scope);
  },
};
