// The page of a picture: shows an SVG, tells clicks, marks what the cursor is at.
import { marked } from "../src/places";
import type { FromPage, Look, Picture, Shown, ToPage } from "../src/protocol";
import own from "./shown.css";

declare function acquireVsCodeApi(): { postMessage(message: FromPage): void; setState(state: Shown): void };
const vscode = acquireVsCodeApi();
const tell = (message: FromPage) => vscode.postMessage(message);

const element = <Sort extends HTMLElement>(id: string) => document.getElementById(id) as Sort;
const skill = element<HTMLSelectElement>("skill"), choice = element<HTMLSelectElement>("choice");
const letters = element<HTMLInputElement>("letters"), state = element("state"), reason = element("reason");
const scroll = element("scroll"), holder = element("picture");
const root = holder.attachShadow({ mode: "open" });
const pan = document.body.dataset.kind === "pan";

let picture: Picture | undefined;
let shown: Shown | undefined;
let cursor: { uri: string; position: { line: number; character: number } } | undefined;
let zoom = 0; // 0: the width of the window, but no larger than it was drawn
let svg: SVGSVGElement | undefined;

const isDark = () => document.body.classList.contains("vscode-dark") || (document.body.classList.contains("vscode-high-contrast") && !document.body.classList.contains("vscode-high-contrast-light"));

/** A chart that is made narrower than this cannot be read. */
const legible = 720;
let look: Look | undefined;

/** Tells the picture that is wanted, if it is another one. */
function tellLook(): void {
  const now = { dark: isDark(), narrow: window.innerWidth < legible };
  if (now.dark === look?.dark && now.narrow === look.narrow) return;
  look = now;
  tell({ type: "look", look });
}

/** A policy without inline styles keeps those of an SVG out; the same rules as objects are let in. */
function adopt(drawn: SVGSVGElement): void {
  const sheets = [...drawn.querySelectorAll("style")].map((each) => {
    const sheet = new CSSStyleSheet();
    sheet.replaceSync(each.textContent ?? "");
    each.remove();
    return sheet;
  });
  const mine = new CSSStyleSheet();
  mine.replaceSync(own);
  root.adoptedStyleSheets = [...sheets, mine];
}

function parse(text: string): SVGSVGElement | undefined {
  // The style attribute of the root is the only one there is.
  const style = /^[^<]*(?:<[?!][^>]*>\s*)*<svg[^>]*? style="([^"]*)"/.exec(text)?.[1];
  const document_ = new DOMParser().parseFromString(style === undefined ? text : text.replace(` style="${style}"`, ""), "image/svg+xml");
  const found = document_.documentElement;
  if (found.nodeName !== "svg") return undefined;
  const drawn = document.importNode(found, true) as unknown as SVGSVGElement;
  if (style !== undefined) drawn.style.cssText = style;
  return drawn;
}

function size(): void {
  if (svg === undefined) return;
  const natural = parseFloat(svg.dataset.natural ?? "0");
  const most = scroll.clientWidth - 18;
  const width = zoom === 0 ? Math.min(natural, most) : natural * zoom;
  svg.style.width = `${width}px`;
}

function setZoom(to: number): void {
  const natural = parseFloat(svg?.dataset.natural ?? "1");
  const now = zoom === 0 ? Math.min(1, (scroll.clientWidth - 18) / natural) : zoom;
  zoom = to === 0 ? 0 : Math.min(8, Math.max(0.1, now * to));
  size();
}

function mark(): void {
  if (svg === undefined || picture === undefined) return;
  const ids = new Set(cursor === undefined ? [] : marked(picture.places, cursor.uri, cursor.position));
  let first: Element | undefined;
  for (const each of svg.querySelectorAll(".place")) {
    const is = ids.has(each.id);
    each.classList.toggle("marked", is);
    if (is) first ??= each;
  }
  const box = first?.getBoundingClientRect(), view = scroll.getBoundingClientRect();
  if (box !== undefined && (box.bottom < view.top || box.top > view.bottom || box.right < view.left || box.left > view.right))
    first?.scrollIntoView({ block: "center", inline: "center" });
}

function options(select: HTMLSelectElement, names: readonly string[], chosen: string, follow: string): void {
  const rows: [string, string][] = [...(follow === "" ? [] : [["", follow] as [string, string]]), ...names.map((each) => [each, each] as [string, string])];
  select.replaceChildren(
    ...rows.map(([value, label]) => {
      const row = document.createElement("option");
      row.value = value;
      row.textContent = label;
      row.selected = value === chosen;
      return row;
    }),
  );
}

function show(next: Picture, what: Shown): void {
  picture = next;
  shown = what;
  vscode.setState(what);
  const named = pan ? next.module : next.requirement;
  skill.hidden = next.choices.skills.length < 2;
  options(skill, [...new Set(next.choices.skills)], next.skill, "");
  options(choice, [...new Set(pan ? next.choices.modules : next.choices.requirements)], pan ? what.module : what.requirement, named === "" ? "at the cursor" : `at the cursor: ${named}`);
  letters.checked = what.letters;
  state.textContent = (next.state === "" ? "" : next.state) + (next.stale ? ", of an earlier text" : "");
  state.dataset.state = next.state;
  reason.textContent = next.reason;
  holder.classList.toggle("stale", next.stale);
  svg = next.svg === "" ? undefined : parse(next.svg);
  root.replaceChildren();
  if (svg === undefined) return;
  adopt(svg);
  const box = svg.viewBox.baseVal;
  const drawn = svg.getAttribute("width") ?? "";
  const natural = drawn.endsWith("pt") ? (parseFloat(drawn) * 4) / 3 : parseFloat(drawn) || box.width;
  svg.dataset.natural = String(natural);
  svg.removeAttribute("width");
  svg.removeAttribute("height");
  svg.style.setProperty("--mark", `${(3 * box.width) / natural}px`);
  const ids = new Set(next.places.map((each) => each.id));
  for (const each of svg.querySelectorAll("[id]")) if (ids.has(each.id)) each.classList.add("place");
  root.append(svg);
  size();
  mark();
}

root.addEventListener("click", (event) => {
  const place = (event.target as Element).closest(".place");
  const found = picture?.places.find((each) => each.id === place?.id);
  if (found !== undefined) tell({ type: "go", uri: found.uri, range: found.range });
});
const choose = (change: Partial<Shown>) => shown !== undefined && tell({ type: "choose", shown: { ...shown, ...change } });
skill.addEventListener("change", () => choose({ skill: skill.value, module: "", requirement: "" }));
choice.addEventListener("change", () => choose(pan ? { module: choice.value } : { requirement: choice.value }));
letters.addEventListener("change", () => choose({ letters: letters.checked }));
element("smaller").addEventListener("click", () => setZoom(1 / 1.25));
element("larger").addEventListener("click", () => setZoom(1.25));
element("fit").addEventListener("click", () => setZoom(0));
element("save").addEventListener("click", () => picture !== undefined && picture.svg !== "" && tell({ type: "save", svg: picture.svg }));
scroll.addEventListener("keydown", (event) => {
  if (event.key === "+") setZoom(1.25);
  else if (event.key === "-") setZoom(1 / 1.25);
  else if (event.key === "0") setZoom(0);
});
scroll.addEventListener("wheel", (event) => {
  if (!event.ctrlKey) return;
  event.preventDefault();
  setZoom(event.deltaY < 0 ? 1.1 : 1 / 1.1);
}, { passive: false });
window.addEventListener("resize", () => {
  size();
  tellLook();
});
window.addEventListener("message", ({ data }: MessageEvent<ToPage>) => {
  if (data.type === "picture") return show(data.picture, data.shown);
  cursor = { uri: data.uri, position: data.position };
  mark();
});
new MutationObserver(tellLook).observe(document.body, { attributes: true, attributeFilter: ["class"] });
tellLook();
