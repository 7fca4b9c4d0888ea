// What a chart shows, as CSV and as SVG: plain functions from numbers to text.
import type { LimitLine } from "./steps";
import { unitText } from "../words/words";
import type { Track } from "./track";

export interface Field {
  field: number;
  name: string;
  unit: string;
}

const quoted = (text: string) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
const plain = (value: number) => String(Number(value.toPrecision(9)));

/** A row for each span: its end, then least, greatest and last of each field. */
export function csvOf(track: Track, fields: readonly Field[], begin: number, end: number): string {
  const names = fields.flatMap(({ name, unit }) => ["least", "greatest", "last"].map((each) => `${name} ${each}${unit === "" ? "" : ` (${unit})`}`));
  const rows = [["time (s)", ...names].map(quoted).join(",")];
  const [from, to] = track.within(begin, end);
  for (let i = from; i < to; ++i)
    rows.push([plain(track.times[i]!), ...fields.flatMap(({ field }) => [track.low[field]![i]!, track.high[field]![i]!, track.last[field]![i]!].map(plain))].join(","));
  return rows.join("\n") + "\n";
}

const escaped = (text: string) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(">", "&gt;").replaceAll('"', "&quot;");

/** Round values between two, some five to eight of them. */
export function ticks(low: number, high: number): number[] {
  const rough = (high - low) / 6, power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((each) => each * power).find((each) => each >= rough) ?? power;
  const found: number[] = [];
  for (let at = Math.ceil(low / step); at * step <= high + step * 1e-9; ++at) found.push(Number((at * step).toPrecision(12)));
  return found;
}

export interface Panel {
  unit: string;
  fields: readonly Field[];
  range: readonly [number, number];
  limits: readonly LimitLine[];
}

export interface Paint {
  ink: string;
  ground: string;
  grid: string;
  color(field: number): string;
  dash(field: number): readonly number[];
  limit(kind: LimitLine["kind"]): string;
}

const width = 960, height = 260, left = 72, right = 16, top = 16, bottom = 36;

function panelSvg(track: Track, panel: Panel, begin: number, end: number, offset: number, paint: Paint): string {
  const [low, high] = panel.range;
  const x = (time: number) => (left + ((time - begin) / (end - begin)) * (width - left - right)).toFixed(2);
  const y = (value: number) => (offset + height - bottom - ((value - low) / (high - low)) * (height - top - bottom)).toFixed(2);
  const parts: string[] = [];
  for (const each of ticks(low, high)) parts.push(`<path d="M${left} ${y(each)}H${width - right}" stroke="${paint.grid}"/><text x="${left - 6}" y="${y(each)}" text-anchor="end" dominant-baseline="middle">${plain(each)}</text>`);
  for (const each of ticks(begin, end)) parts.push(`<path d="M${x(each)} ${offset + top}V${offset + height - bottom}" stroke="${paint.grid}"/><text x="${x(each)}" y="${offset + height - bottom + 16}" text-anchor="middle">${plain(each)} s</text>`);
  parts.push(`<text x="4" y="${offset + top}" dominant-baseline="hanging">${escaped(unitText(panel.unit))}</text>`);
  const [from, to] = track.within(begin, end);
  panel.fields.forEach((each, place) => {
    const points = (row: Float64Array) => Array.from({ length: to - from }, (_, i) => `${x(track.times[from + i]!)} ${y(row[from + i]!)}`);
    if (to > from) {
      parts.push(`<path d="M${[...points(track.high[each.field]!), ...points(track.low[each.field]!).reverse()].join("L")}Z" fill="${paint.color(each.field)}" opacity=".2"/>`);
      parts.push(`<path d="M${points(track.last[each.field]!).join("L")}" fill="none" stroke="${paint.color(each.field)}" stroke-width="1.5" stroke-dasharray="${paint.dash(each.field).join(" ")}"/>`);
    }
    parts.push(`<text x="${left + 8 + place * 80}" y="${offset + top + 4}" fill="${paint.color(each.field)}" font-weight="600" dominant-baseline="hanging">${escaped(each.name)}</text>`);
  });
  for (const each of panel.limits) {
    if (each.value < low || each.value > high) continue;
    const first = Math.max(each.begin, begin), last = Math.min(each.end ?? end, end);
    parts.push(`<path d="M${x(first)} ${y(each.value)}H${x(last)}" stroke="${paint.limit(each.kind)}" stroke-width="1.5" stroke-dasharray="6 3"/><text x="${x(first)}" y="${y(each.value)}" dx="4" dy="-3" fill="${paint.limit(each.kind)}">${escaped(each.parameter)}</text>`);
  }
  return parts.join("\n");
}

export function svgOf(track: Track, panels: readonly Panel[], begin: number, end: number, title: string, paint: Paint): string {
  const body = panels.map((each, i) => panelSvg(track, each, begin, end, 24 + i * height, paint)).join("\n");
  const tall = 24 + panels.length * height;
  return `<svg xmlns="http://www.w3.org/2000/svg" width="${width}" height="${tall}" viewBox="0 0 ${width} ${tall}" font-family="Inter, sans-serif" font-size="12" fill="${paint.ink}">
<rect width="${width}" height="${tall}" fill="${paint.ground}"/>
<text x="${left}" y="16" font-weight="600">${escaped(title)}</text>
${body}
</svg>
`;
}

export function saveFile(name: string, type: string, text: string): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([text], { type }));
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}
