// A channel of numbers against time: a plot for each unit, its fields as switches with the values at the cursor. It
// follows the cell until it is held still, by its button or by zooming in.
import { useEffect, useMemo, useRef, useState, type KeyboardEvent } from "react";
import { ToggleButton } from "react-aria-components";
import type { Channel } from "../../generated/protocol";
import { useCell } from "../state/cell";
import { Symbol } from "../symbols/Symbol";
import { number, t, unitText } from "../words/words";
import { csvOf, saveFile, svgOf, type Field, type Panel } from "./export";
import { eachFrame } from "./eachFrame";
import { trackOf, watch } from "./live";
import { look, onLook, seriesColor, seriesDash } from "./look";
import { replayedTrack, useReplay } from "./replay";
import { makePlot, rangeOf, type Around, type Plot } from "./plot";
import { limitsOf, stepsWithin, useSteps } from "./steps";
import { lookAt, useInstant } from "./time";
import { ChartTools } from "./Tools";
import type { Track } from "./track";

export interface Source {
  title: string;
  fields: readonly Field[];
  track: Track;
  around: Around;
}

/** As fine as the screen can show it, in steps that people know. */
const periodFor = (span: number) => [0.001, 0.002, 0.005, 0.01, 0.02].find((each) => each >= span / 500) ?? 0.02;

export function ChannelChart({ channel }: { channel: Channel }) {
  const fields = useMemo(() => channel.fields.map(({ name, unit }, field) => ({ field, name, unit })), [channel]);
  const [span, setSpan] = useState(10);
  const period = periodFor(span);
  useEffect(() => watch(channel.channel, period), [channel.channel, period]);
  const around = useMemo<Around>(() => ({ steps: stepsWithin, limits: (begin, end) => stepsWithin(begin, end).flatMap((each) => limitsOf(each, channel)) }), [channel]);
  const loaded = useReplay((state) => state.loaded);
  // A run again: all of it, from what the server kept.
  const again = useMemo<Around | undefined>(() => loaded && ({
    steps: (begin, end) => loaded.steps.filter((each) => each.begin <= end && (each.end ?? Infinity) >= begin), limits: (begin, end) => loaded.steps.filter((each) => each.begin <= end && (each.end ?? Infinity) >= begin).flatMap((each) => limitsOf(each, channel)),
  }), [loaded, channel]);
  if (loaded && again)
    return (
      <>
        <p className="chart-replayed"><Symbol name="versions" size={16} />{t("scene.notLive")}</p>
        <TimeChart key={loaded.kept.run} source={{ title: channel.channel, fields, track: replayedTrack(channel.channel, fields.length), around: again }} span={span} onSpan={setSpan} within={loaded.kept} />
      </>
    );
  return <TimeChart source={{ title: channel.channel, fields, track: trackOf(channel.channel, fields.length), around }} span={span} onSpan={setSpan} />;
}

const digits = (unit: string) => (unit === "N" || unit === "mm" || unit === "deg" ? 2 : 3);

/** `within`: what is seen first, in place of what comes now. */
export function TimeChart({ source, span, onSpan, within }: { source: Source; span: number; onSpan(span: number): void; within?: { begin: number; end: number } }) {
  const { fields, track, around } = source;
  const units = [...new Set(fields.map((each) => each.unit))];
  const [hidden, setHidden] = useState<ReadonlySet<number>>(new Set());
  const [held, setHeld] = useState<{ begin: number; end: number } | undefined>(within && { begin: within.begin, end: within.end });
  const hosts = useRef(new Map<string, HTMLDivElement>());
  const plots = useRef<{ unit: string; plot: Plot }[]>([]);
  const view = useRef({ begin: 0, end: 1 });
  const state = useRef({ held, span });
  state.current = { held, span };
  const [empty, setEmpty] = useState(track.size === 0);

  const shown = fields.filter((each) => !hidden.has(each.field));
  const key = shown.map((each) => each.field).join();
  useEffect(() => {
    const zoomed = (begin: number, end: number) => setHeld({ begin, end });
    const made = units.flatMap((unit) => {
      const host = hosts.current.get(unit), of = shown.filter((each) => each.unit === unit);
      return host && of.length > 0 ? [{ unit, host, plot: makePlot(host, track, of, around, zoomed, () => setHeld(within && { begin: within.begin, end: within.end }), host.clientHeight) }] : [];
    });
    plots.current = made;
    let seen = -1, drawn = "", was = useSteps.getState().steps, asked: number | undefined, filled = false;
    const draw = (force = false) => {
      const { held: fixed, span: wanted } = state.current;
      const end = fixed?.end ?? track.end ?? useCell.getState().present?.snapshot.time_s ?? wanted;
      const begin = fixed?.begin ?? end - wanted;
      const { steps } = useSteps.getState();
      const now = `${begin}:${end}`;
      const fresh = force || track.version !== seen || now !== drawn || steps !== was;
      if (fresh && !(fixed && !within && now === drawn && !force)) {
        view.current = { begin, end };
        for (const { plot } of made) plot.draw(begin, end);
        // Once: React keeps each update, also one that changes nothing, until the component is rendered again.
        if (track.size > 0 && !filled) (filled = true, setEmpty(false));
      }
      [seen, drawn, was] = [track.version, now, steps];
      const { time } = useInstant.getState();
      if (time !== asked || fresh) for (const { plot } of made) plot.point(time);
      asked = time;
    };
    const stop = eachFrame(draw);
    const stopLook = onLook(() => draw(true));
    const sizes = new ResizeObserver(() => {
      for (const { host, plot } of made) plot.resize(host.clientWidth, host.clientHeight);
      draw(true);
    });
    for (const { host } of made) sizes.observe(host);
    return () => {
      stop();
      stopLook();
      sizes.disconnect();
      for (const { plot } of made) plot.end();
    };
    // eslint-disable-next-line -- the plots are made anew for other fields only
  }, [track, around, key]);

  const hold = (still: boolean) => setHeld(still ? { ...view.current } : undefined);
  const zoom = (wanted: number) => {
    if (held) {
      const middle = Math.min(held.end, Math.max(held.begin, useInstant.getState().time ?? (held.begin + held.end) / 2));
      const part = (middle - held.begin) / (held.end - held.begin);
      setHeld({ begin: middle - wanted * part, end: middle + wanted * (1 - part) });
    } else {
      onSpan(wanted);
    }
  };
  const save = (kind: "csv" | "svg") => {
    const { begin, end } = view.current, colours = look();
    if (kind === "csv") return saveFile(`${source.title}.csv`, "text/csv", csvOf(track, shown, begin, end));
    const panels = units.map((unit): Panel => {
      const of = shown.filter((each) => each.unit === unit), limits = around.limits(begin, end).filter((each) => of.some((one) => one.name === each.field));
      const [from, to] = track.within(begin, end);
      return { unit, fields: of, range: rangeOf(track, of, from, to, limits), limits };
    }).filter((each) => each.fields.length > 0);
    saveFile(`${source.title}.svg`, "image/svg+xml", svgOf(track, panels, begin, end, source.title, {
      ink: colours.ink, ground: getComputedStyle(document.documentElement).getPropertyValue("--surface").trim(), grid: colours.grid, color: seriesColor, dash: seriesDash,
      limit: (limit) => (limit === "error" ? colours.error : limit === "stop" ? colours.warn : colours.accent),
    }));
  };
  const move = (event: KeyboardEvent) => {
    const by = { ArrowLeft: -1, ArrowRight: 1, PageUp: -20, PageDown: 20 }[event.key];
    if (event.key === "Escape" && useInstant.getState().time !== undefined) return event.preventDefault(), lookAt(undefined);
    if (by === undefined || track.size === 0) return;
    event.preventDefault();
    const at = track.at(useInstant.getState().time ?? view.current.end) ?? track.size - 1;
    lookAt(track.times[Math.min(track.size - 1, Math.max(0, at + by))]);
  };
  const { begin, end } = held ?? view.current;
  return (
    <div className="chart" data-held={held !== undefined || undefined}>
      <ChartTools held={held !== undefined} onHold={hold} span={held ? held.end - held.begin : span} onSpan={zoom} onSave={save} />
      <Values source={source} hidden={hidden} onHidden={setHidden} />
      <div className="chart-plots" role="slider" tabIndex={0} aria-label={t("chart.cursor", { name: source.title })} aria-valuemin={begin} aria-valuemax={end} aria-valuenow={useInstant.getState().time ?? end}
        onKeyDown={move} onPointerLeave={() => lookAt(undefined)}>
        {units.map((unit) => (
          <div key={unit} className="chart-panel" hidden={!shown.some((each) => each.unit === unit)}>
            <span className="chart-unit">{unitText(unit)}</span>
            <div className="chart-plot" ref={(host) => void (host ? hosts.current.set(unit, host) : hosts.current.delete(unit))} />
          </div>
        ))}
        {empty && <p className="nothing chart-empty">{t("chart.empty")}</p>}
      </div>
    </div>
  );
}

/** The span at the cursor, else the last one; -1: there is none. */
const shownAt = (track: Track, time: number | undefined): number => (time === undefined ? track.size - 1 : (track.at(time) ?? -1));

/** A text of what is shown now. It alone is made anew, ten times a second, which is as much as people read. */
function Now({ track, of }: { track: Track; of(at: number): string }) {
  const time = useInstant((state) => state.time);
  const [, setVersion] = useState(track.version);
  useEffect(() => {
    // A version that is shown already is not set again: React would keep each such update until there is a new one.
    let shown = -1;
    const timer = setInterval(() => track.version !== shown && setVersion((shown = track.version)), 100);
    return () => clearInterval(timer);
  }, [track]);
  return of(shownAt(track, time));
}

/** The fields with their values at the cursor, else now. Each can be switched off. */
function Values({ source: { fields, track }, hidden, onHidden }: { source: Source; hidden: ReadonlySet<number>; onHidden(hidden: ReadonlySet<number>): void }) {
  const toggle = (field: number) => {
    const next = new Set(hidden);
    if (!next.delete(field)) next.add(field);
    if (next.size < fields.length) onHidden(next);
  };
  const inWords = (value: number, unit: string) => number(Math.abs(value) < 10 ** -digits(unit) / 2 ? 0 : value, digits(unit));
  return (
    <div className="chart-fields">
      {fields.map(({ field, name, unit }) => (
        <ToggleButton key={field} className="chart-field" isSelected={!hidden.has(field)} onChange={() => toggle(field)} data-field={name}>
          <svg width="18" height="8" aria-hidden="true"><line x1="0" x2="18" y1="4" y2="4" stroke={`var(--series-${(field % 6) + 1})`} strokeWidth="2.5" strokeDasharray={seriesDash(field).join(" ")} /></svg>
          <span>{name}</span><b><Now track={track} of={(at) => (at < 0 ? "–" : inWords(track.last[field]![at]!, unit))} /></b>
        </ToggleButton>
      ))}
      <span className="chart-time"><Now track={track} of={(at) => (at < 0 ? "" : `${number(track.times[at]!, 3)} s`)} /></span>
    </div>
  );
}
