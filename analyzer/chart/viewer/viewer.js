"use strict";
// Draws the runs that stand in the page as data, and lets a reader move in them. Times are nanoseconds.
(() => {
const data = JSON.parse(document.getElementById("runs").textContent);
const get = id => document.getElementById(id);
const canvas = get("canvas"), tip = get("tip"), pen = canvas.getContext("2d");
const colour = { computation: "#0072b2", message: "#56b4e9", condition: "#f0e442" };
const font = "DejaVu Sans, Verdana, sans-serif";
const laneHeight = 36, barHeight = 18, waveHeight = 26, axisHeight = 26, topRow = 26, dimensionRow = 24;

let chosen = 0;      // requirement
let shown = 0;       // which of its views
let from = 0, to = 1;
let left = 120;
let hits = [];       // what stands where, the last on top
let labels = [];     // where words stand

const requirement = () => data.requirements[chosen];
const view = () => requirement().views[shown];
const run = () => data.runs[view().run];
const clamp = (value, low, high) => Math.min(Math.max(value, low), high);

function duration(ns) {
  if (ns < 0) return "\u2212" + duration(-ns);
  const [size, name] = ns === 0 ? [1e6, "ms"] : ns < 1e3 ? [1, "ns"] : ns < 1e4 ? [1e3, "\u00b5s"] : ns < 1e9 ? [1e6, "ms"] : [1e9, "s"];
  const digits = Math.round(Math.log10(size));
  const text = (ns / size).toFixed(digits);
  return (digits ? text.replace(/\.?0+$/, "") : text) + " " + name;
}

// ---- the list of requirements, and the runs of one

function fillRequirements() {
  let heading = "";
  data.requirements.forEach((each, index) => {
    const group = each.skill + " in " + each.environment;
    if (group !== heading) {
      heading = group;
      get("requirements").append(Object.assign(document.createElement("h2"), { textContent: group }));
    }
    const button = document.createElement("button");
    button.append(each.name + " ", Object.assign(document.createElement("span"), { className: each.verdict, textContent: each.verdict }),
      Object.assign(document.createElement("small"), { textContent: each.brief }));
    button.addEventListener("click", () => choose(index, 0));
    get("requirements").append(button);
  });
}

function choose(index, which) {
  chosen = index;
  shown = which;
  const it = requirement();
  [...document.querySelectorAll("#requirements button")].forEach((button, i) => button.setAttribute("aria-current", i === index));
  get("title").textContent = it.name + " " + it.verdict;
  get("title").className = it.verdict;
  get("measure").textContent = it.measure;
  get("figures").textContent = it.figures;
  const select = get("run");
  select.replaceChildren(...it.views.map((each, i) => new Option(each.name, i, false, i === which)));
  select.disabled = it.views.length < 2;
  get("chart").hidden = get("tools").hidden = get("help").hidden = it.views.length === 0;
  get("none").hidden = it.views.length > 0;
  fillWhy();
  if (it.views.length > 0) fit(true);
  remember();
}

// The chosen requirement and run stay in the address, so that a link leads back to them.
function remember() {
  const it = requirement();
  const words = [it.skill, it.environment, it.name].map(encodeURIComponent).join("/");
  history.replaceState(null, "", "#" + words + (shown > 0 ? "/" + shown : ""));
}

function recall() {
  const [skill, environment, name, which] = location.hash.slice(1).split("/").map(decodeURIComponent);
  const index = data.requirements.findIndex(it => it.skill === skill && it.environment === environment && it.name === name);
  if (index < 0) return choose(data.first, 0);
  choose(index, clamp(Number(which) || 0, 0, Math.max(0, data.requirements[index].views.length - 1)));
}

// ---- why it takes so long

function letter(index) {
  const last = String.fromCharCode(97 + index % 26);
  return index < 26 ? last : letter(Math.floor(index / 26) - 1) + last;
}

function partNode(part, name, isLongest) {
  const line = [];
  if (name) line.push(Object.assign(document.createElement("b"), { textContent: name }));
  line.push(Object.assign(document.createElement("span"), { className: "time", textContent: duration(part.to - part.from) }));
  line.push((part.actor ? part.actor + ": " : "") + part.text);
  if (part.place) line.push(Object.assign(document.createElement("span"), { className: "place", textContent: " (" + part.place + ")" }));
  const show = event => {
    if (part.loose) return;
    const pad = Math.max((part.to - part.from) / 10, 1000);
    setWindow(part.from - pad, part.to + pad);
    event.stopPropagation();
  };
  if (part.inside.length === 0) {
    const leaf = Object.assign(document.createElement("div"), { className: "part" });
    leaf.append(...line);
    leaf.addEventListener("click", show);
    return leaf;
  }
  const details = document.createElement("details");
  details.open = isLongest;
  const summary = document.createElement("summary");
  summary.append(...line);
  summary.addEventListener("click", show);
  details.append(summary, ...partNodes(part.inside, false, isLongest));
  return details;
}

function partNodes(parts, lettered, unfold) {
  const most = Math.max(...parts.map(part => part.to - part.from));
  let open = unfold;
  return parts.map((part, i) => {
    const longest = open && part.to - part.from === most;
    if (longest) open = false;
    return partNode(part, lettered ? letter(i) : "", longest);
  });
}

function fillWhy() {
  const why = get("why");
  why.replaceChildren();
  const parts = requirement().views.length ? view().why : [];
  if (parts.length === 0) return;
  const highlight = view().highlight;
  const heading = highlight ? "How the " + duration(highlight.to - highlight.from) + " come about" : "How this comes about";
  why.append(Object.assign(document.createElement("h3"), { textContent: heading }), ...partNodes(parts, true, true));
}

/// The parts of the explanation at an instant, from the outermost to the innermost.
function whyAt(instant) {
  const path = [];
  for (let parts = view().why; parts.length > 0;) {
    const part = parts.find(each => instant >= each.from && instant < each.to);
    if (!part) break;
    path.push(part);
    parts = part.inside;
  }
  return path;
}

// ---- which part of the run is shown

function setWindow(begin, end) {
  const length = clamp(end - begin, 20, run().end * 1.1 + 100);
  const middle = (begin + end) / 2;
  const least = -run().end * 0.03, most = Math.max(run().end, view().highlight ? view().highlight.to : 0) * 1.05 + 10;
  from = clamp(middle - length / 2, least, Math.max(least, most - length));
  to = from + length;
  draw();
}

function fit(toInterval) {
  const { highlight, window: wanted } = view();
  if (toInterval && wanted) return setWindow(wanted[0], wanted[1]);
  if (!toInterval || !highlight) return setWindow(-run().end * 0.01, run().end * 1.01 + 10);
  const pad = Math.max((highlight.to - highlight.from) / 12, 1000);
  setWindow(highlight.from - pad, highlight.to + pad);
}

function zoom(factor, at) {
  const length = clamp((to - from) * factor, 20, run().end * 1.1 + 100);
  const share = (at - from) / (to - from);
  setWindow(at - share * length, at + (1 - share) * length);
}

const x = ns => left + (ns - from) / (to - from) * (canvas.clientWidth - left - 12);
const ns = place => from + (place - left) / (canvas.clientWidth - left - 12) * (to - from);

// ---- drawing

function text(words, at, y, style = "#000", align = "left", weight = "") {
  pen.font = weight + " 11px " + font;
  pen.fillStyle = style;
  pen.textAlign = align;
  pen.textBaseline = "middle";
  pen.fillText(words, at, y);
}

function width(words, weight = "") {
  pen.font = weight + " 11px " + font;
  return pen.measureText(words).width;
}

function hatch(ink, paper) {
  const tile = document.createElement("canvas");
  tile.width = tile.height = 8;
  const brush = tile.getContext("2d");
  brush.fillStyle = paper;
  brush.fillRect(0, 0, 8, 8);
  brush.strokeStyle = ink;
  brush.lineWidth = 2;
  brush.beginPath();
  for (const shift of [-8, 0, 8]) { brush.moveTo(shift, 8); brush.lineTo(shift + 8, 0); }
  brush.stroke();
  return pen.createPattern(tile, "repeat");
}
const readyFill = hatch("#e69f00", "#fff"), servingFill = hatch("#aaa", "#fff");

/// Whether a text of this width has room there; then nothing else has.
function claim(at, y, room) {
  if (at + room > canvas.clientWidth - 4) return false;
  if (labels.some(box => at < box[1] && at + room > box[0] && Math.abs(y - box[2]) < 12)) return false;
  labels.push([at - 2, at + room + 2, y]);
  return true;
}

function hit(box, words, actor) { hits.push({ box, words, actor }); }

function times(begin, end) { return duration(begin) + " to " + duration(end) + " (" + duration(end - begin) + ")"; }

/// The first of things in order of time that ends at or after an instant.
function firstFrom(things, instant, endOf) {
  let low = 0, high = things.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (endOf(things[middle]) < instant) low = middle + 1; else high = middle;
  }
  return low;
}

function drawGrid(bottom) {
  const rough = (to - from) / Math.max(2, (canvas.clientWidth - left) / 90);
  const power = 10 ** Math.floor(Math.log10(Math.max(rough, 1)));
  const step = Math.max(1, [1, 2, 5, 10].map(f => f * power).find(s => s >= rough));
  const [size, name] = to - from >= 5e9 ? [1e9, "s"] : to - from >= 5e4 ? [1e6, "ms"] : to - from >= 100 ? [1e3, "\u00b5s"] : [1, "ns"];
  const decimals = Math.max(0, Math.round(Math.log10(size)) - Math.floor(Math.log10(step)));
  pen.lineWidth = 1;
  for (let at = Math.ceil(from / step) * step; at <= to; at += step) {
    pen.strokeStyle = "#e0e0e0";
    pen.beginPath(); pen.moveTo(x(at), topRow); pen.lineTo(x(at), bottom); pen.stroke();
    pen.strokeStyle = "#000";
    pen.beginPath(); pen.moveTo(x(at), bottom); pen.lineTo(x(at), bottom + 5); pen.stroke();
    text((at / size).toFixed(decimals).replace("-", "\u2212"), x(at), bottom + 14, "#000", "center");
  }
  pen.strokeStyle = "#000";
  pen.beginPath(); pen.moveTo(left, bottom); pen.lineTo(canvas.clientWidth - 12, bottom); pen.stroke();
  text("time in " + name, 6, bottom + 14);
}

function drawHighlight(bottom) {
  const it = view().highlight;
  if (!it || it.to < from || it.from > to) return;
  const ink = it.fails ? "#d55e00" : "#009e73";
  const begin = clamp(x(it.from), left, canvas.clientWidth), end = clamp(x(it.to), left, canvas.clientWidth - 12);
  pen.globalAlpha = 0.12;
  pen.fillStyle = ink;
  pen.fillRect(begin, topRow, Math.max(end - begin, 1), bottom - topRow);
  pen.globalAlpha = 1;
}

function drawDimensions(y) {
  const it = view().highlight;
  if (!it) return;
  const ink = it.fails ? "#a63c00" : "#00563f";
  drawSpan(it.from, it.to, y, it.label + " " + duration(it.to - it.from), ink, 2);
  hit([left, y - 10, canvas.clientWidth, y + 10], it.label + "\n" + times(it.from, it.to));
  view().why.forEach((part, i) => {
    drawSpan(part.from, part.to, y + dimensionRow, letter(i) + "  " + duration(part.to - part.from) + "  " + part.text, "#000", 1, letter(i));
    const words = letter(i) + ": " + (part.actor ? part.actor + " " : "") + part.text + "\n" + times(part.from, part.to) +
      (part.place ? "\n" + part.place : "");
    hit([x(part.from), y + dimensionRow - 10, x(part.to), y + dimensionRow + 10], words);
  });
}

function drawSpan(begin, end, y, words, ink, thick, brief = "") {
  if (end < from || begin > to) return;
  const a = clamp(x(begin), left, canvas.clientWidth - 12), b = clamp(x(end), left, canvas.clientWidth - 12);
  pen.strokeStyle = ink;
  pen.lineWidth = thick;
  pen.beginPath();
  pen.moveTo(a, y); pen.lineTo(b, y);
  if (begin >= from) { pen.moveTo(a, y - 5); pen.lineTo(a, y + 5); }
  if (end <= to) { pen.moveTo(b, y - 5); pen.lineTo(b, y + 5); }
  pen.stroke();
  for (const shownWords of [words, brief]) {
    const room = width(shownWords, thick > 1 ? "bold" : "") + 12;
    if (!shownWords || room > b - a) continue;
    pen.fillStyle = "#fff";
    pen.fillRect((a + b - room) / 2, y - 8, room, 16);
    text(shownWords, (a + b) / 2, y, ink, "center", thick > 1 ? "bold" : "");
    break;
  }
}

function drawLane(lane, y) {
  const middle = y + laneHeight / 2, top = middle - barHeight / 2;
  for (let i = firstFrom(lane.gaps, from, gap => gap[1]); i < lane.gaps.length && lane.gaps[i][0] <= to; ++i) {
    const [begin, end, kind, what, gaveUp] = lane.gaps[i];
    const a = Math.max(x(begin), left), b = Math.min(x(end), canvas.clientWidth - 12);
    if (kind === "ready") {
      pen.fillStyle = readyFill;
      pen.fillRect(a, top, Math.max(b - a, 1), barHeight);
      pen.strokeStyle = "#000";
      pen.lineWidth = 0.5;
      pen.strokeRect(a, top, Math.max(b - a, 1), barHeight);
    } else {
      pen.strokeStyle = "#555";
      pen.lineWidth = 1.2;
      pen.beginPath(); pen.moveTo(a, middle); pen.lineTo(b, middle); pen.stroke();
      if (gaveUp && end <= to) text("\u2715", b, middle, "#000", "center", "bold");
      const words = "waits for " + what;
      if (width(words) + 20 < b - a && claim(a + 8, middle - 8, width(words))) text(words, a + 8, middle - 8, "#555");
    }
    const state = kind === "ready" ? " is ready, but its processor is taken: " : " waits for ";
    hit([a, top, b, top + barHeight], lane.name + state + what + (gaveUp ? ", and gives up" : "") + "\n" + times(begin, end), lane.name);
  }
  let last = -1;
  for (let i = firstFrom(lane.bars, from, bar => bar[1]); i < lane.bars.length && lane.bars[i][0] <= to; ++i) {
    const [begin, end, kind, number, flags] = lane.bars[i];
    const a = Math.max(x(begin), left), b = Math.max(Math.min(x(end), canvas.clientWidth - 12), a + 1.5);
    if (b < last + 0.7) continue;  // nothing more than what is drawn there already
    last = b;
    const statement = run().texts[number];
    pen.fillStyle = kind === "serving" ? servingFill : colour[kind];
    pen.fillRect(a, top, b - a, barHeight);
    pen.strokeStyle = "#000";
    pen.lineWidth = 0.6;
    if (b - a > 3) pen.strokeRect(a, top, b - a, barHeight);
    if (width(statement.text) + 8 < b - a) {
      if (kind === "serving") { pen.fillStyle = "#fff"; const room = width(statement.text) + 8; pen.fillRect((a + b - room) / 2, top + 3, room, barHeight - 6); }
      text(statement.text, (a + b) / 2, middle, kind === "computation" ? "#fff" : "#000", "center");
    }
    const state = (flags & 1 ? ", resumed" : "") + (flags & 2 ? ", not finished" : "");
    hit([a, top, b, top + barHeight], lane.name + ": " + statement.text + "\n" + times(begin, end) + state +
      (statement.place ? "\n" + statement.place : ""), lane.name);
  }
}

function cross(a, top, b, bottom) {
  pen.strokeStyle = "#d55e00";
  pen.lineWidth = 2.5;
  pen.beginPath();
  pen.moveTo(a, top); pen.lineTo(b, bottom); pen.moveTo(a, bottom); pen.lineTo(b, top);
  pen.stroke();
}

function drawLosses(laneTop) {
  for (const loss of view().losses) {
    const index = run().lanes.findIndex(lane => lane.name === loss.lane);
    if (index < 0 || loss.to < from || loss.from > to) continue;
    const y = laneTop(index) + laneHeight / 2;
    const a = Math.max(x(loss.from), left), b = Math.max(Math.min(x(loss.to), canvas.clientWidth - 12), a + 8);
    cross(a, y - barHeight / 2, b, y + barHeight / 2);
    hit([a, y - barHeight / 2, b, y + barHeight / 2], loss.lane + ": " + loss.text + "\n" + times(loss.from, loss.to), loss.lane);
  }
}

function drawArrows(laneTop) {
  const visible = run().arrows.filter(arrow => arrow[3] >= from && arrow[1] <= to && arrow[2] >= 0);
  if (visible.length > 3000) return;
  for (const [sender, put, receiver, arrives, taken, message, fate] of visible) {
    if (sender === receiver) continue;
    const down = sender < receiver, edge = barHeight / 2;
    const a = [x(put), laneTop(sender) + laneHeight / 2 + (down ? edge : -edge)];
    const b = [x(arrives), laneTop(receiver) + laneHeight / 2 + (down ? -edge : edge)];
    if (Math.min(a[0], b[0]) < left) continue;
    pen.strokeStyle = pen.fillStyle = "#333";
    pen.lineWidth = 0.9;
    pen.setLineDash(fate === "dropped" ? [3, 2] : []);
    pen.beginPath(); pen.moveTo(...a); pen.lineTo(...b); pen.stroke();
    pen.setLineDash([]);
    const angle = Math.atan2(b[1] - a[1], b[0] - a[0]);
    if (fate !== "dropped") {
      pen.beginPath();
      pen.moveTo(...b);
      for (const turn of [2.7, -2.7]) pen.lineTo(b[0] + 7 * Math.cos(angle + turn), b[1] + 7 * Math.sin(angle + turn));
      pen.fill();
    } else {
      text("\u2715", b[0], b[1], "#000", "center", "bold");
    }
    const words = message + ": " + run().lanes[sender].name + " to " + run().lanes[receiver].name + "\nput " + duration(put) +
      (fate === "dropped" ? ", withdrawn " : ", taken ") + duration(taken);
    for (let piece = 0; piece <= 8; ++piece) {
      const at = [a[0] + (b[0] - a[0]) * piece / 8, a[1] + (b[1] - a[1]) * piece / 8];
      hit([at[0] - 4, at[1] - 6, at[0] + 4, at[1] + 6], words);
    }
    if (visible.length > 150) continue;
    // Between two lanes, as near to the middle of the arrow as can be.
    const between = [];
    for (let row = Math.min(sender, receiver) + 1; row <= Math.max(sender, receiver); ++row) between.push(laneTop(row) + 1);
    between.sort((one, other) => Math.abs(one - (a[1] + b[1]) / 2) - Math.abs(other - (a[1] + b[1]) / 2));
    const beside = y => a[0] + (b[0] - a[0]) * (y - a[1]) / (b[1] - a[1]) + 4;
    const y = between.find(each => claim(beside(each), each, width(message)));
    if (y === undefined) continue;
    const place = [beside(y), y];
    pen.lineWidth = 3;
    pen.strokeStyle = "#fff";
    pen.font = "11px " + font;
    pen.textAlign = "left";
    pen.strokeText(message, place[0], place[1]);
    text(message, place[0], place[1], "#222");
  }
}

function drawMarks(laneTop, bottom) {
  for (const [at, kind, lane, what] of run().marks) {
    if (at < from || at > to) continue;
    const place = x(at);
    if (kind === "broken") {
      const middle = lane < 0 ? topRow : laneTop(lane) + laneHeight / 2;
      const who = lane < 0 ? "" : run().lanes[lane].name + ": ";
      pen.fillStyle = "#f6c8a8";
      pen.strokeStyle = "#d55e00";
      pen.lineWidth = 1.2;
      pen.beginPath();
      pen.moveTo(place, middle - 7); pen.lineTo(place + 7, middle); pen.lineTo(place, middle + 7); pen.lineTo(place - 7, middle);
      pen.closePath(); pen.fill(); pen.stroke();
      text("!", place, middle, "#000", "center");
      hit([place - 7, middle - 7, place + 7, middle + 7], who + "promise broken: " + what + "\n" + duration(at), lane < 0 ? undefined : run().lanes[lane].name);
      continue;
    }
    if (lane < 0 || kind === "completion" || kind === "fault") {
      pen.strokeStyle = kind === "fault" ? "#d55e00" : "#000";
      pen.lineWidth = 1.2;
      pen.beginPath(); pen.moveTo(place, topRow); pen.lineTo(place, bottom); pen.stroke();
      text(what, place > canvas.clientWidth - 100 ? place - 4 : place + 4, topRow - 8, "#000", place > canvas.clientWidth - 100 ? "right" : "left");
      hit([place - 4, topRow, place + 4, bottom], what + "\n" + duration(at));
      continue;
    }
    const y = laneTop(lane) + laneHeight / 2;
    if (kind === "event") {
      pen.fillStyle = "#000";
      pen.beginPath();
      pen.moveTo(place - 5, y - 9); pen.lineTo(place + 5, y - 9); pen.lineTo(place, y + 9);
      pen.fill();
    } else if (kind === "overrun") {
      cross(place - 6, y - 6, place + 6, y + 6);
    } else if (kind === "cancelled") {
      pen.fillStyle = "#000";
      pen.fillRect(place - 1.5, y - 9, 3, 18);
    }
    hit([place - 6, y - 10, place + 6, y + 10], run().lanes[lane].name + ": " + what + "\n" + duration(at), run().lanes[lane].name);
  }
}

function drawWave(wave, y) {
  const high = y + 6, low = y + waveHeight - 8, level = value => value ? high : low;
  pen.strokeStyle = "#000";
  pen.lineWidth = 1.5;
  pen.beginPath();
  let value = false;
  for (const [at, set] of wave.sets) if (at < from) value = set;
  pen.moveTo(left, level(value));
  const begins = value;
  for (const [at, set] of wave.sets) {
    if (at < from || at > to || set === value) continue;
    pen.lineTo(x(at), level(value)); pen.lineTo(x(at), level(set));
    value = set;
  }
  pen.lineTo(Math.min(x(run().end), canvas.clientWidth - 12), level(value));
  pen.stroke();
  text(begins ? "TRUE" : "FALSE", left - 6, (high + low) / 2, "#444", "right");
  for (const [things, verb] of [[wave.sets, "set to"], [wave.reads, "read as"]]) {
    for (const [at, now, lane] of things) {
      if (at < from || at > to) continue;
      pen.fillStyle = verb === "set to" ? "#000" : "#fff";
      pen.lineWidth = 1.2;
      pen.fillRect(x(at) - 3, level(now) - 3, 6, 6);
      pen.strokeRect(x(at) - 3, level(now) - 3, 6, 6);
      const who = lane < 0 ? "" : " by " + run().lanes[lane].name;
      hit([x(at) - 5, level(now) - 5, x(at) + 5, level(now) + 5], wave.name + " " + verb + (now ? " TRUE" : " FALSE") + who + "\n" + duration(at));
    }
  }
}

function drawNames(laneTop, laneBottom) {
  pen.fillStyle = "#fff";
  pen.fillRect(0, 0, left, laneBottom);
  const { lanes } = run();
  for (let i = 0; i < lanes.length;) {
    let end = i + 1;
    while (end < lanes.length && !lanes[i].device && !lanes[end].device && lanes[end].processor === lanes[i].processor) ++end;
    if (!lanes[i].device) {
      const top = laneTop(i) + 5, bottom = laneTop(end - 1) + laneHeight - 5;
      pen.strokeStyle = "#000";
      pen.lineWidth = 1.2;
      pen.beginPath();
      pen.moveTo(nameLeft - 6, top); pen.lineTo(nameLeft - 10, top); pen.lineTo(nameLeft - 10, bottom); pen.lineTo(nameLeft - 6, bottom);
      pen.stroke();
      text(lanes[i].processor, nameLeft - 14, (top + bottom) / 2, "#000", "right", "bold");
    }
    for (; i < end; ++i) {
      const name = lanes[i].name, y = laneTop(i) + laneHeight / 2;
      text(name, lanes[i].device ? 6 : nameLeft, y, "#000", "left", lanes[i].device ? "italic" : "");
      const about = lanes[i].device ? "device " + name : "thread " + name + " on processor " + lanes[i].processor + ", priority " + lanes[i].priority;
      hit([0, y - 12, left, y + 12], about);
    }
  }
}

let nameLeft = 60;

function draw() {
  hits = [];
  labels = [];
  const { lanes, waves } = run();
  nameLeft = 24 + Math.max(0, ...lanes.filter(lane => !lane.device).map(lane => width(lane.processor) * 1.15));
  left = 12 + Math.max(70, ...lanes.map(lane => width(lane.name) + (lane.device ? 10 : nameLeft)), ...waves.map(wave => width(wave.name) + 52));
  left = Math.min(left, canvas.clientWidth / 2);
  const laneTop = index => topRow + index * laneHeight;
  const laneBottom = laneTop(lanes.length), waveTop = laneBottom + 4;
  const dimensions = view().highlight ? dimensionRow * (view().why.length ? 2 : 1) + 8 : 0;
  const bottom = waveTop + waves.length * waveHeight + dimensions + 6;
  const height = bottom + axisHeight, ratio = window.devicePixelRatio || 1;
  canvas.style.height = height + "px";
  canvas.width = Math.round(canvas.clientWidth * ratio);
  canvas.height = Math.round(height * ratio);
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.fillStyle = "#fff";
  pen.fillRect(0, 0, canvas.clientWidth, height);
  drawHighlight(bottom);
  drawGrid(bottom);
  lanes.forEach((lane, i) => drawLane(lane, laneTop(i)));
  drawArrows(laneTop);
  drawLosses(laneTop);
  drawMarks(laneTop, laneBottom);
  waves.forEach((wave, i) => drawWave(wave, waveTop + i * waveHeight));
  drawNames(laneTop, laneBottom);
  waves.forEach((wave, i) => text(wave.name, 6, waveTop + i * waveHeight + waveHeight / 2 - 1));
  drawDimensions(bottom - dimensions + 8);
  const limit = view().highlight && view().highlight.limit >= 0 ? view().highlight.from + view().highlight.limit : -1;
  if (limit >= from && limit <= to) {
    pen.strokeStyle = "#000";
    pen.setLineDash([6, 3]);
    pen.lineWidth = 1.6;
    pen.beginPath(); pen.moveTo(x(limit), 14); pen.lineTo(x(limit), bottom); pen.stroke();
    pen.setLineDash([]);
    const words = "limit " + duration(view().highlight.limit), right = x(limit) + width(words) + 10 < canvas.clientWidth;
    text(words, x(limit) + (right ? 4 : -4), 8, "#000", right ? "left" : "right");
  }
  get("span").textContent = duration(Number((to - from).toPrecision(3))) + " shown";
}

// ---- the reader's hands

function point(event) {
  const box = canvas.getBoundingClientRect();
  return [event.clientX - box.left, event.clientY - box.top];
}

function showTip(event) {
  const [px, py] = point(event);
  const found = hits.findLast(({ box }) => px >= box[0] && px <= box[2] && py >= box[1] && py <= box[3]);
  tip.hidden = !found;
  if (!found) return;
  let words = found.words;
  const path = px > left && found.actor ? whyAt(ns(px)) : [];
  if (path.length > 0) words += "\n\nWhy it takes so long, at this instant:";
  path.forEach((part, depth) => { words += "\n" + "\u2003".repeat(depth) + duration(part.to - part.from) + ": " + (part.actor ? part.actor + " " : "") + part.text; });
  tip.textContent = words;
  tip.style.left = clamp(px + 14, 0, Math.max(0, canvas.clientWidth - tip.offsetWidth - 4)) + "px";
  tip.style.top = py + 16 + "px";
}

let drag = null;
canvas.addEventListener("pointerdown", event => {
  drag = { at: event.clientX, from, to };
  canvas.setPointerCapture(event.pointerId);
  canvas.classList.add("dragged");
});
canvas.addEventListener("pointermove", event => {
  if (!drag) return showTip(event);
  const moved = (event.clientX - drag.at) / (canvas.clientWidth - left - 12) * (drag.to - drag.from);
  tip.hidden = true;
  setWindow(drag.from - moved, drag.to - moved);
});
for (const end of ["pointerup", "pointercancel"])
  canvas.addEventListener(end, () => { drag = null; canvas.classList.remove("dragged"); });
canvas.addEventListener("pointerleave", () => { tip.hidden = true; });
canvas.addEventListener("dblclick", () => fit(true));
canvas.addEventListener("wheel", event => {
  event.preventDefault();
  const pixels = event.deltaMode === 1 ? 30 : 1;
  if (event.shiftKey || Math.abs(event.deltaX) > Math.abs(event.deltaY)) {
    const moved = (event.deltaX || event.deltaY) * pixels / canvas.clientWidth * (to - from);
    setWindow(from + moved, to + moved);
  } else {
    zoom(Math.exp(clamp(event.deltaY * pixels, -300, 300) / 400), ns(Math.max(point(event)[0], left)));
  }
}, { passive: false });
canvas.addEventListener("keydown", event => {
  const step = (to - from) / 5, keys = {
    ArrowLeft: () => setWindow(from - step, to - step), ArrowRight: () => setWindow(from + step, to + step),
    "+": () => zoom(0.7, (from + to) / 2), "=": () => zoom(0.7, (from + to) / 2), "-": () => zoom(1.4, (from + to) / 2),
    Home: () => fit(false), "0": () => fit(true),
  };
  if (!keys[event.key]) return;
  event.preventDefault();
  keys[event.key]();
});
get("closer").addEventListener("click", () => zoom(0.6, (from + to) / 2));
get("wider").addEventListener("click", () => zoom(1.6, (from + to) / 2));
get("interval").addEventListener("click", () => fit(true));
get("all").addEventListener("click", () => fit(false));
get("run").addEventListener("change", event => choose(chosen, Number(event.target.value)));
window.addEventListener("resize", () => { if (requirement().views.length) draw(); });
window.addEventListener("hashchange", recall);

fillRequirements();
recall();
})();
