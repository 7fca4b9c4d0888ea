// What pal says, as a text beside: the page of a finding.
import { execFile } from "node:child_process";
import * as vscode from "vscode";
import { program } from "./server";

function output(command: string, args: string[]): Promise<string> {
  return new Promise((resolve) => {
    execFile(command, args, { timeout: 10000, maxBuffer: 1 << 26 }, (_, out, err) => resolve(out === "" ? err : out));
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
