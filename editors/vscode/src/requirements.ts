// Requirements as tests: each file with skills, its skills, their requirements; green only if proved.
import * as vscode from "vscode";
import type { Requirement } from "./protocol";
import type { Server } from "./server";

const range = (of: { start: { line: number; character: number }; end: { line: number; character: number } }) =>
  new vscode.Range(of.start.line, of.start.character, of.end.line, of.end.character);

/** A skill's template ends so; USES of one, and texts that name one, do not. */
const hasSkill = (text: string) => /^\s*END\s+SKILL\b/im.test(text);

export class Requirements implements vscode.Disposable {
  private readonly tests = vscode.tests.createTestController("pal", "PAL requirements");
  private readonly known = new Map<string, Requirement>(); // by the id of the test
  private readonly told = new Map<string, string>(); // by the id of a file: what is shown of it
  private readonly subscriptions: vscode.Disposable[] = [];

  constructor(private readonly server: Server) {
    this.tests.resolveHandler = (item) => (item === undefined ? this.findFiles() : this.resolve(item.uri!));
    this.tests.refreshHandler = () => this.findFiles();
    const profile = this.tests.createRunProfile("Prove", vscode.TestRunProfileKind.Run, (request, token) => this.run(request, token), true);
    profile.isDefault = true;
    const watcher = vscode.workspace.createFileSystemWatcher("**/*.pal");
    this.subscriptions.push(
      watcher,
      watcher.onDidCreate((uri) => this.addFile(uri)),
      watcher.onDidDelete((uri) => this.tests.items.delete(uri.toString())),
      vscode.workspace.onDidOpenTextDocument((document) => void this.opened(document)),
      server.changed(({ uris, what }) => {
        if (what === "proof") for (const uri of uris) if (this.tests.items.get(uri) !== undefined) void this.resolve(vscode.Uri.parse(uri), true);
      }),
    );
    for (const document of vscode.workspace.textDocuments) void this.opened(document);
  }

  private async opened(document: vscode.TextDocument): Promise<void> {
    if (document.languageId !== "pal" || document.uri.scheme !== "file" || !hasSkill(document.getText())) return;
    await this.addFile(document.uri);
    await this.resolve(document.uri);
  }

  private async findFiles(): Promise<void> {
    const files = await vscode.workspace.findFiles("**/*.pal", "{**/build*/**,**/node_modules/**}");
    await Promise.all(files.map((uri) => this.addFile(uri)));
  }

  private async addFile(uri: vscode.Uri): Promise<void> {
    const id = uri.toString();
    if (this.tests.items.get(id) !== undefined) return;
    const open = vscode.workspace.textDocuments.find((each) => each.uri.toString() === id);
    const text = open?.getText() ?? new TextDecoder().decode(await vscode.workspace.fs.readFile(uri));
    if (!hasSkill(text) || this.tests.items.get(id) !== undefined) return;
    const item = this.tests.createTestItem(id, vscode.workspace.asRelativePath(uri), uri);
    item.canResolveChildren = true;
    this.tests.items.add(item);
  }

  /** Asks what is known. `tell`: a run shows it, as proofs have come. */
  private async resolve(uri: vscode.Uri, tell = false): Promise<void> {
    const file = this.tests.items.get(uri.toString());
    if (file === undefined) return;
    const skills = await this.server.skillsOf(uri.toString());
    const items = skills
      .filter((each) => each.uri === uri.toString() || vscode.Uri.parse(each.uri).fsPath === uri.fsPath)
      .map((skill) => {
        const item = this.tests.createTestItem(`${file.id}/${skill.skill}`, skill.skill, uri);
        item.range = range(skill.range);
        item.description = skill.environment === "" ? "no environment" : `in ${skill.environment}`;
        item.children.replace(
          skill.requirements.map((each) => {
            const test = this.tests.createTestItem(`${item.id}/${each.name}`, each.name, vscode.Uri.parse(each.uri));
            test.range = range(each.range);
            test.description = each.state === "open" ? "" : `${each.bound} of ${each.limit}`;
            this.known.set(test.id, each);
            return test;
          }),
        );
        return item;
      });
    file.children.replace(items);
    if (!tell) return;
    const leaves = leavesOf(file).filter((each) => this.known.get(each.id)?.state !== "open");
    const now = leaves.map((each) => `${each.id} ${this.known.get(each.id)?.state}`).join("\n");
    if (leaves.length === 0 || this.told.get(file.id) === now) return;
    this.told.set(file.id, now);
    const run = this.tests.createTestRun(new vscode.TestRunRequest(leaves), file.label, false);
    for (const each of leaves) this.say(run, each, false); // the finding and the bound stand in the text already
    run.end();
  }

  /** Holds: passed. Fails and never: failed. Undecided: errored, as it is not known. */
  private say(run: vscode.TestRun, test: vscode.TestItem, why: boolean): void {
    const known = this.known.get(test.id);
    if (known === undefined) return run.skipped(test);
    if (why) run.appendOutput(`${known.state.padEnd(10)} ${test.label}  ${test.description ?? ""}\r\n`, undefined, test);
    if (known.state === "holds") return run.passed(test);
    const message = new vscode.TestMessage(known.message === "" ? `${known.state}: ${known.bound} of ${known.limit}` : known.message);
    message.location = new vscode.Location(test.uri!, test.range!);
    const messages = why ? [message] : [];
    if (known.state === "fails" || known.state === "never") run.failed(test, messages);
    else run.errored(test, why && known.state === "open" ? new vscode.TestMessage("not proved: the text has errors, there is no environment, or proofTimeSeconds is 0") : messages);
  }

  private async run(request: vscode.TestRunRequest, token: vscode.CancellationToken): Promise<void> {
    const asked = request.include ?? [...this.tests.items].map(([, each]) => each);
    const files = new Set(asked.map((each) => this.tests.items.get(each.uri!.toString()) ?? each));
    const run = this.tests.createTestRun(request);
    for (const file of files) {
      if (token.isCancellationRequested) break;
      await vscode.workspace.openTextDocument(file.uri!); // what is open is proved
      const seconds = vscode.workspace.getConfiguration("pal").get<number>("proofTimeSeconds") ?? 2;
      const last = Date.now() + (seconds + 5) * 1000;
      for (;;) {
        await this.resolve(file.uri!);
        const open = leavesOf(file).some((each) => this.known.get(each.id)?.state === "open");
        if (!open || Date.now() > last || token.isCancellationRequested) break;
        await new Promise((resolve) => setTimeout(resolve, 100));
      }
      const wanted = asked.filter((each) => each.uri!.toString() === file.uri!.toString()).map((each) => each.id);
      const chosen = (test: vscode.TestItem) => wanted.some((each) => test.id === each || test.id.startsWith(`${each}/`));
      const excluded = (test: vscode.TestItem) => request.exclude?.some((each) => each.id === test.id) ?? false;
      for (const test of leavesOf(file)) if (chosen(test) && !excluded(test)) this.say(run, test, true);
    }
    run.end();
  }

  dispose(): void {
    for (const each of this.subscriptions) each.dispose();
    this.tests.dispose();
  }
}

function leavesOf(item: vscode.TestItem): vscode.TestItem[] {
  const found: vscode.TestItem[] = [];
  for (const [, skill] of item.children) for (const [, each] of skill.children) found.push(each);
  return found;
}
