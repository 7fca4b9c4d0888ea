// One plot over time on a canvas: lines with the span from least to greatest behind them, the steps that acted, the
// limits that their parameters set.
import uPlot from "uplot";
import { number } from "../words/words";
import { look, seriesColor, seriesDash } from "./look";
import type { Acted, LimitLine } from "./steps";
import { lookAt } from "./time";
import type { Track } from "./track";

export interface Shown {
  /** In the channel, the field. */
  field: number;
  name: string;
}

export interface Around {
  steps(begin: number, end: number): readonly Acted[];
  limits(begin: number, end: number): readonly LimitLine[];
}

export interface Plot {
  draw(begin: number, end: number): void;
  /** Where the cursor is put, s; undefined: it goes. */
  point(time: number | undefined): void;
  resize(width: number, height: number): void;
  redraw(): void;
  end(): void;
}

const none = new Float64Array(0);
export const axisTick = (value: number): string => number(Number(value.toPrecision(6)));

/** The range of the plot's own lines and of limits near them, with a little air. */
export function rangeOf(track: Track, shown: readonly Shown[], from: number, to: number, limits: readonly LimitLine[]): [number, number] {
  let low = Infinity, high = -Infinity;
  for (const { field } of shown)
    for (let i = from; i < to; ++i) {
      low = Math.min(low, track.low[field]![i]!);
      high = Math.max(high, track.high[field]![i]!);
    }
  if (low > high) [low, high] = [0, 1];
  // A limit far away would press the lines flat: one within their own reach is shown.
  const reach = Math.max(high - low, 1e-3) * 1.5 + Math.max(Math.abs(low), Math.abs(high)) * 0.6;
  for (const each of limits) {
    if (!shown.some((one) => one.name === each.field)) continue;
    if (each.value > high + reach || each.value < low - reach) continue;
    low = Math.min(low, each.value);
    high = Math.max(high, each.value);
  }
  const air = Math.max((high - low) * 0.08, 1e-3 * Math.max(1, Math.abs(high)));
  return [low - air, high + air];
}

export function makePlot(host: HTMLElement, track: Track, shown: readonly Shown[], around: Around, zoomed: (begin: number, end: number) => void, follow: () => void, height: number): Plot {
  let begin = 0, end = 1, own = false, from = 0, to = 0;
  const limits = () => around.limits(begin, end).filter((each) => shown.some((one) => one.name === each.field));

  const behind = (plot: uPlot) => {
    const { ctx, bbox } = plot, colours = look();
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    around.steps(begin, end).forEach((step, i) => {
      const left = plot.valToPos(Math.max(step.begin, begin), "x", true), right = plot.valToPos(Math.min(step.end ?? end, end), "x", true);
      ctx.fillStyle = colours.step;
      if (i % 2 === 0) ctx.fillRect(left, bbox.top, right - left, bbox.height);
      ctx.fillStyle = colours.grid;
      ctx.fillRect(left, bbox.top, devicePixelRatio, bbox.height);
    });
    // A band is filled between its two ends.
    const bands = new Map<number, LimitLine[]>();
    for (const each of limits()) if (each.kind === "band") bands.set(each.begin, [...(bands.get(each.begin) ?? []), each]);
    for (const [, pair] of bands) {
      if (pair.length < 2) continue;
      const values = pair.map((each) => plot.valToPos(each.value, "y", true));
      const left = plot.valToPos(Math.max(pair[0]!.begin, begin), "x", true), right = plot.valToPos(Math.min(pair[0]!.end ?? end, end), "x", true);
      ctx.fillStyle = colours.band;
      ctx.fillRect(left, Math.min(...values), right - left, Math.max(...values) - Math.min(...values));
    }
    ctx.restore();
  };
  /** From the least to the greatest of each span, where one can see a difference. */
  const spans = (plot: uPlot) => {
    const { ctx, bbox } = plot, { min, max } = plot.scales["y"]!;
    const x = (i: number) => bbox.left + ((track.times[i]! - begin) / (end - begin)) * bbox.width;
    const y = (value: number) => bbox.top + ((max! - value) / (max! - min!)) * bbox.height;
    const least = ((max! - min!) / bbox.height) * devicePixelRatio;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    for (const { field } of shown) {
      const low = track.low[field]!, high = track.high[field]!, wide = (i: number) => high[i]! - low[i]! > least;
      ctx.fillStyle = `${seriesColor(field)}38`;
      ctx.beginPath();
      for (let i = from; i < to; ++i) {
        if (!wide(i)) continue;
        // With its neighbours, where it becomes narrow again.
        const first = Math.max(from, i - 1);
        while (i < to && wide(i)) ++i;
        const last = Math.min(to - 1, i);
        ctx.moveTo(x(first), y(high[first]!));
        for (let at = first + 1; at <= last; ++at) ctx.lineTo(x(at), y(high[at]!));
        for (let at = last; at >= first; --at) ctx.lineTo(x(at), y(low[at]!));
        ctx.closePath();
      }
      ctx.fill();
    }
    ctx.restore();
  };
  const before = (plot: uPlot) => {
    const { ctx, bbox } = plot, colours = look(), scale = devicePixelRatio;
    ctx.save();
    ctx.beginPath();
    ctx.rect(bbox.left, bbox.top, bbox.width, bbox.height);
    ctx.clip();
    ctx.lineWidth = 1.5 * scale;
    ctx.font = `500 ${11 * scale}px "Inter Variable", sans-serif`;
    ctx.textAlign = "left";
    ctx.textBaseline = "bottom";
    const written = new Set<string>();
    for (const each of limits()) {
      const y = plot.valToPos(each.value, "y", true);
      const left = plot.valToPos(Math.max(each.begin, begin), "x", true), right = plot.valToPos(Math.min(each.end ?? end, end), "x", true);
      ctx.strokeStyle = ctx.fillStyle = each.kind === "error" ? colours.error : each.kind === "stop" ? colours.warn : colours.accent;
      ctx.setLineDash(each.kind === "error" ? [2 * scale, 3 * scale] : each.kind === "stop" ? [8 * scale, 4 * scale] : []);
      ctx.beginPath();
      ctx.moveTo(left, y);
      ctx.lineTo(right, y);
      ctx.stroke();
      // Its name once for a height, where it begins.
      const key = `${each.parameter}:${each.value}`;
      if (written.has(key) || right - left < ctx.measureText(each.parameter).width + 8 * scale) continue;
      written.add(key);
      ctx.fillText(each.parameter, left + 4 * scale, y - 2 * scale);
    }
    // Which icon acted.
    ctx.fillStyle = colours.ink2;
    ctx.setLineDash([]);
    ctx.textBaseline = "top";
    for (const step of around.steps(begin, end)) {
      const left = plot.valToPos(Math.max(step.begin, begin), "x", true), right = plot.valToPos(Math.min(step.end ?? end, end), "x", true);
      const name = step.icon === "" ? step.skill : step.icon.slice(step.icon.lastIndexOf("/") + 1);
      if (right - left > ctx.measureText(name).width + 10 * scale) ctx.fillText(name, left + 5 * scale, bbox.top + 3 * scale);
    }
    ctx.restore();
  };

  const series: uPlot.Series[] = [{}, ...shown.map(({ field }): uPlot.Series => ({ stroke: () => seriesColor(field), width: 1.25, dash: seriesDash(field), points: { show: false } }))];
  const axis: uPlot.Axis = {
    stroke: () => look().ink2, grid: { stroke: () => look().grid, width: 1 }, ticks: { stroke: () => look().grid, width: 1, size: 4 }, font: '12px "Inter Variable", sans-serif',
  };
  const plot = new uPlot({
    width: Math.max(200, host.clientWidth), height, series,
    legend: { show: false },
    scales: { x: { time: false, auto: false }, y: { auto: false } },
    axes: [
      { ...axis, size: 26, space: 72, values: (_, ticks) => ticks.map((each) => `${axisTick(each)} s`) },
      { ...axis, size: 56, space: 30, values: (_, ticks) => ticks.map(axisTick) },
    ],
    cursor: { y: false, points: { show: false }, drag: { x: true, y: false, setScale: false }, dataIdx: (_, __, at) => at, bind: { dblclick: () => () => (follow(), null) } },
    hooks: {
      drawClear: [behind], drawAxes: [spans], draw: [before],
      setCursor: [(it) => {
        if (own) return;
        const left = it.cursor.left ?? -1;
        lookAt(left < 0 ? undefined : it.posToVal(left, "x"));
      }],
      setSelect: [(it) => {
        if (it.select.width < 8) return;
        const to = it.posToVal(it.select.left + it.select.width, "x"), at = it.posToVal(it.select.left, "x");
        it.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
        zoomed(at, to);
      }],
    },
  }, [none, ...shown.map(() => none)] as unknown as uPlot.AlignedData, host);

  return {
    draw(first, last) {
      [begin, end] = [first, last];
      [from, to] = track.within(begin, end);
      from = Math.max(0, from - 1);
      to = Math.min(track.size, to + 1);
      const part = (row: Float64Array) => row.subarray(from, to);
      const data = [part(track.times), ...shown.map(({ field }) => part(track.last[field]!))];
      const [low, high] = rangeOf(track, shown, from, to, limits());
      plot.batch(() => {
        plot.setData(data as unknown as uPlot.AlignedData, false);
        plot.setScale("x", { min: begin, max: end });
        plot.setScale("y", { min: low, max: high });
      });
    },
    point(time) {
      own = true;
      const left = time === undefined || time < begin || time > end ? -10 : plot.valToPos(time, "x");
      if (Math.abs((plot.cursor.left ?? -10) - left) > 0.5) plot.setCursor({ left, top: left < 0 ? -10 : 4 });
      own = false;
    },
    resize: (width, tall) => plot.setSize({ width, height: tall }),
    redraw: () => plot.redraw(false),
    end: () => plot.destroy(),
  };
}
