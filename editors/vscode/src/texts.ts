// What pal says, as a text beside: the page of a finding, and what if.
import { execFile } from "node:child_process";
import { dirname } from "node:path";
import * as vscode from "vscode";
import { program } from "./server";

function output(command: string, args: string[], cwd?: string): Promise<string> {
  return new Promise((resolve) => {
    execFile(command, args, { timeout: 120000, maxBuffer: 1 << 26, ...(cwd === undefined ? {} : { cwd }) }, (_, out, err) => resolve(out === "" ? err : err === "" ? out : `${out}\n${err}`));
  });
}

/** Texts that can be read and not changed: pal-text:/NAME. */
export class Texts implements vscode.TextDocumentContentProvider {
  private readonly texts = new Map<string, string>();
  private readonly changes = new vscode.EventEmitter<vscode.Uri>();
  readonly onDidChange = this.changes.event;

  provideTextDocumentContent(uri: vscode.Uri): string {
    return this.texts.get(uri.path) ?? "";
  }

  set(name: string, text: string): vscode.Uri {
    const uri = vscode.Uri.from({ scheme: "pal-text", path: `/${name}` });
    this.texts.set(uri.path, text);
    this.changes.fire(uri);
    return uri;
  }

  async explain(code: string | undefined): Promise<void> {
    const pal = program("pal");
    if (pal === undefined) return;
    const asked = code ?? codeAtCursor() ?? (await vscode.window.showInputBox({ prompt: "The code of a finding", placeHolder: "PAL0201", validateInput: (text) => (/^PAL\d{4}$/i.test(text) ? undefined : "PAL and four digits") }));
    if (asked === undefined) return;
    const uri = this.set(`${asked}.md`, await output(pal, ["explain", asked]));
    await vscode.commands.executeCommand("markdown.showPreviewToSide", uri);
  }

  /** Asks of what is saved, so it is saved first. */
  async whatIf(file: vscode.Uri, skill: string, environment: vscode.Uri | undefined): Promise<void> {
    const pal = program("pal");
    if (pal === undefined) return;
    for (const document of vscode.workspace.textDocuments) if (document.isDirty && document.languageId === "pal") await document.save();
    const args = ["whatif", file.fsPath, ...(skill === "" ? [] : ["--skill", skill])];
    if (environment !== undefined && environment.fsPath !== file.fsPath) args.push("--environment", environment.fsPath);
    const text = await vscode.window.withProgress({ location: vscode.ProgressLocation.Notification, title: `What if: ${skill}` }, () => output(pal, args, dirname(file.fsPath)));
    const uri = this.set(`What if ${skill === "" ? "the skill" : skill}`, text);
    await vscode.window.showTextDocument(uri, { viewColumn: vscode.ViewColumn.Beside, preserveFocus: true, preview: true });
  }
}

function codeAtCursor(): string | undefined {
  const editor = vscode.window.activeTextEditor;
  if (editor === undefined) return undefined;
  const at = editor.selection.active;
  for (const each of vscode.languages.getDiagnostics(editor.document.uri)) {
    if (each.source !== "pal" || !each.range.contains(at)) continue;
    const code = typeof each.code === "object" ? each.code.value : each.code;
    if (typeof code === "string") return code;
  }
  return undefined;
}
