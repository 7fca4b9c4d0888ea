// Pictures beside the text: a module's graph (PAN), a requirement's worst run (ATC). They follow the text while it is
// typed; a click on an element goes to its statement, and the cursor marks the elements of its own.
import { randomBytes } from "node:crypto";
import * as vscode from "vscode";
import type { FromPage, Look, Picture, PictureKind, PictureParams, Shown, ToPage } from "./protocol";
import type { Server } from "./server";

const titles = { pan: "PAN", atc: "ATC" } as const;

class PictureView {
  private look: Look | undefined; // undefined: the page is not ready
  private asked = 0;
  private timer: NodeJS.Timeout | undefined;

  constructor(
    private readonly panel: vscode.WebviewPanel,
    private readonly kind: PictureKind,
    private readonly server: Server,
    extension: vscode.Uri,
    public shown: Shown,
  ) {
    const media = vscode.Uri.joinPath(extension, "out");
    panel.webview.options = { enableScripts: true, localResourceRoots: [media] };
    panel.iconPath = {
      light: vscode.Uri.joinPath(extension, "icons", `${kind}-light.svg`),
      dark: vscode.Uri.joinPath(extension, "icons", `${kind}-dark.svg`),
    };
    panel.webview.onDidReceiveMessage((message: FromPage) => void this.receive(message));
    panel.webview.html = page(panel.webview, media, kind);
  }

  show(shown: Shown): void {
    this.shown = shown;
    this.draw();
  }

  /** Soon: further changes in the meantime are drawn with it. */
  drawSoon(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.draw(), 60);
  }

  async draw(): Promise<void> {
    if (this.look === undefined) return;
    const asked = ++this.asked;
    const { uri, skill, module, requirement, letters } = this.shown;
    const editor = vscode.window.visibleTextEditors.find((each) => each.document.uri.toString() === uri);
    const params: PictureParams = { textDocument: { uri }, kind: this.kind, ...this.look };
    if (skill !== "") params.skill = skill;
    if (module !== "") params.module = module;
    if (requirement !== "") params.requirement = requirement;
    if (letters) params.letters = true;
    if (editor !== undefined) params.position = editor.selection.active;
    const picture = await this.server.ask<Picture>("pal/picture", params);
    if (picture === undefined || asked !== this.asked) return;
    this.panel.title = picture.title === "" ? titles[this.kind] : `${titles[this.kind]}: ${picture.title}`;
    this.tell({ type: "picture", picture, shown: this.shown });
    if (editor !== undefined) this.cursor(editor);
  }

  cursor(editor: vscode.TextEditor): void {
    this.tell({ type: "cursor", uri: editor.document.uri.toString(), position: editor.selection.active });
  }

  close(): void {
    clearTimeout(this.timer);
  }

  private tell(message: ToPage): void {
    void this.panel.webview.postMessage(message);
  }

  private async receive(message: FromPage): Promise<void> {
    switch (message.type) {
      case "look":
        this.look = message.look;
        return this.draw();
      case "choose":
        return this.show(message.shown);
      case "go": {
        const range = new vscode.Range(message.range.start.line, message.range.start.character, message.range.end.line, message.range.end.character);
        const uri = vscode.Uri.parse(message.uri);
        const open = vscode.window.visibleTextEditors.find((each) => each.document.uri.toString() === uri.toString());
        const editor = await vscode.window.showTextDocument(uri, { viewColumn: open?.viewColumn ?? vscode.ViewColumn.One, selection: range });
        editor.revealRange(range, vscode.TextEditorRevealType.InCenterIfOutsideViewport);
        return;
      }
      case "save": {
        const name = this.panel.title.replace(/^[A-Z]+: /, "").replace(/[^\w-]+/g, "_");
        const folder = vscode.workspace.workspaceFolders?.[0]?.uri ?? vscode.Uri.parse(this.shown.uri).with({ path: "/" });
        const uri = await vscode.window.showSaveDialog({ defaultUri: vscode.Uri.joinPath(folder, `${name}.svg`), filters: { SVG: ["svg"] } });
        if (uri !== undefined) await vscode.workspace.fs.writeFile(uri, new TextEncoder().encode(message.svg));
        return;
      }
    }
  }
}

/** No network, no inline script, no inline style: the style sheet of a picture is adopted by the page's script. */
function page(webview: vscode.Webview, media: vscode.Uri, kind: PictureKind): string {
  const nonce = randomBytes(16).toString("base64");
  const file = (name: string) => webview.asWebviewUri(vscode.Uri.joinPath(media, name)).toString();
  return `<!doctype html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src ${webview.cspSource}; script-src 'nonce-${nonce}'">
<link rel="stylesheet" href="${file("picture.css")}">
<title>${titles[kind]}</title>
</head>
<body data-kind="${kind}">
<div id="bar">
<select id="skill" title="Skill" hidden></select>
<select id="choice" title="${kind === "pan" ? "Module" : "Requirement"}"></select>
<label id="letters-label" ${kind === "pan" ? "" : "hidden"}><input id="letters" type="checkbox"> letters</label>
<span id="state" role="status"></span>
<span class="space"></span>
<button id="smaller" title="Smaller (-)" aria-label="Smaller">−</button>
<button id="fit" title="Fit the width (0)">fit</button>
<button id="larger" title="Larger (+)" aria-label="Larger">+</button>
<button id="save" title="Save as SVG">save</button>
</div>
<div id="reason"></div>
<div id="scroll" tabindex="0"><div id="picture"></div></div>
<script nonce="${nonce}" src="${file("picture.js")}"></script>
</body>
</html>`;
}

export class Pictures implements vscode.Disposable, vscode.WebviewPanelSerializer<Shown> {
  private readonly views = new Map<PictureKind, { panel: vscode.WebviewPanel; view: PictureView }>();
  private readonly subscriptions: vscode.Disposable[] = [];

  constructor(
    private readonly server: Server,
    private readonly extension: vscode.Uri,
  ) {
    this.subscriptions.push(
      server.changed(({ uris, what }) => {
        for (const [kind, { view }] of this.views) {
          if ((kind === "pan") === (what === "text") && uris.includes(view.shown.uri)) view.drawSoon();
          else if (kind === "atc" && what === "text" && uris.includes(view.shown.uri)) view.drawSoon(); // it is stale now
        }
      }),
      vscode.window.onDidChangeTextEditorSelection(({ textEditor, kind }) => {
        if (textEditor.document.languageId !== "pal") return;
        for (const { view } of this.views.values()) {
          const uri = textEditor.document.uri.toString();
          view.cursor(textEditor);
          const follows = view.shown.module === "" && view.shown.requirement === "" && kind !== undefined;
          if (follows) {
            view.shown = { ...view.shown, uri };
            view.drawSoon();
          }
        }
      }),
      vscode.window.registerWebviewPanelSerializer("pal.pan", this),
      vscode.window.registerWebviewPanelSerializer("pal.atc", this),
    );
  }

  show(kind: PictureKind, shown: Shown): void {
    const open = this.views.get(kind);
    if (open !== undefined) {
      open.panel.reveal(undefined, true);
      open.view.show(shown);
      return;
    }
    const other = this.views.get(kind === "pan" ? "atc" : "pan")?.panel.viewColumn;
    this.adopt(kind, vscode.window.createWebviewPanel(`pal.${kind}`, titles[kind], { viewColumn: other ?? vscode.ViewColumn.Beside, preserveFocus: true }, { retainContextWhenHidden: true }), shown);
  }

  /** After a reload of the window. */
  async deserializeWebviewPanel(panel: vscode.WebviewPanel, shown: Shown | undefined): Promise<void> {
    const kind = panel.viewType === "pal.pan" ? "pan" : "atc";
    if (this.views.has(kind)) return panel.dispose();
    this.adopt(kind, panel, shown ?? { uri: "", skill: "", module: "", requirement: "", letters: false });
  }

  private adopt(kind: PictureKind, panel: vscode.WebviewPanel, shown: Shown): void {
    const view = new PictureView(panel, kind, this.server, this.extension, shown);
    this.views.set(kind, { panel, view });
    panel.onDidDispose(() => {
      view.close();
      this.views.delete(kind);
    });
  }

  dispose(): void {
    for (const each of this.subscriptions) each.dispose();
    for (const { panel } of [...this.views.values()]) panel.dispose();
  }
}
