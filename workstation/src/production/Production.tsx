// What a shift made: counts, cycle times beside the proved ones, and what stood, why and for how long. It can be printed.
import { useEffect, useState } from "react";
import { Button } from "react-aria-components";
import type { Run } from "../../generated/protocol";
import { Choose } from "../dialog/Choose";
import { ticks } from "../live/export";
import { causeOf } from "../state/cause";
import { call, onEvent } from "../state/cell";
import { useChecks } from "../state/checks";
import { useDrawing } from "../state/drawing";
import { Symbol } from "../symbols/Symbol";
import { duration, moment, number, t } from "../words/words";
import { ByWay } from "./ByWay";
import { shiftOf, spreadOf, type Cycle, type Shift } from "./shift";

const hour = 3_600_000;
const periods = { "1": hour, "8": 8 * hour, "24": 24 * hour, all: Infinity } as const;
type Period = keyof typeof periods;

async function runsSince(since: number): Promise<Run[]> {
  const all: Run[] = [];
  for (let before: number | undefined, more = true; more && all.length < 2000; ) {
    const page = await call("history.list", { limit: 200, ...(before === undefined ? {} : { before }) });
    all.push(...page.runs);
    before = page.runs.at(-1)?.run;
    more = page.more && before !== undefined && Date.parse(page.runs.at(-1)!.begun) >= since;
  }
  return all;
}

export default function Production() {
  const [period, setPeriod] = useState<Period>("8"), [name, setName] = useState("");
  const [runs, setRuns] = useState<readonly Run[]>();
  useEffect(() => {
    let current = true;
    const read = () => void runsSince(Date.now() - periods[period]).then((all) => current && setRuns(all), () => current && setRuns([]));
    read();
    const stop = onEvent((event) => event.event === "state" && event.state !== "running" && read());
    return () => {
      current = false;
      stop();
    };
  }, [period]);
  if (!runs) return <p className="nothing loading">{t("loading")}</p>;
  const since = period === "all" ? 0 : Date.now() - periods[period];
  const names = [...new Set(runs.filter((each) => each.kind === "operation").map((each) => each.name))];
  const shift = shiftOf(runs, name, since, Date.now());
  return (
    <div className="production">
      <div className="production-choice">
        <Choose label={t("production.period")} value={period} onChange={(value) => setPeriod(value as Period)} options={(Object.keys(periods) as Period[]).map((each) => ({ id: each, name: each === "all" ? t("production.always") : t("production.hours", { count: Number(each) }) }))} />
        <Choose label={t("production.operation")} value={name || "*"} onChange={(value) => setName(value === "*" ? "" : value)} options={[{ id: "*", name: t("production.all") }, ...names.map((each) => ({ id: each, name: each }))]} />
        <Button className="button" onPress={() => print()}><Symbol name="download" size={16} />{t("production.print")}</Button>
      </div>
      {shift.runs === 0 ? <p className="nothing">{t("production.none")}</p> : <><Counts shift={shift} /><Cycles shift={shift} name={name || (names.length === 1 ? names[0]! : "")} /><Stops shift={shift} /></>}
    </div>
  );
}

function Counts({ shift }: { shift: Shift }) {
  const tiles: [string, string][] = [
    [t("production.good"), number(shift.good)], [t("production.other"), number(shift.other)], [t("production.broken"), number(shift.broken)],
    [t("production.runs"), number(shift.runs)], [t("production.worked"), duration(shift.worked / 1000)],
  ];
  return <dl className="tiles">{tiles.map(([label, value]) => <div key={label}><dt>{label}</dt><dd>{value}</dd></div>)}</dl>;
}

/** Cycle times one after the other, with the proved shortest and longest of the operation that is drawn. */
function Cycles({ shift, name }: { shift: Shift; name: string }) {
  const result = useChecks((state) => state.result);
  const drawn = useDrawing((state) => state.drawing.name);
  const good = shift.cycles.filter((each) => each.code === 0), spread = spreadOf(good);
  const proved = result && drawn === name && result.ways.length > 0 ? { shortest: result.shortest_s, longest: result.longest_s, declared: result.ways.some((way) => way.declared) } : undefined;
  if (!spread) return proved && result ? <ByWay cycles={shift.cycles} ways={result.ways} all={result.all_ways} /> : null;
  const cell = (value: number | null | undefined) => (typeof value === "number" && value >= 0.005 ? duration(value) : "–");
  return (
    <section>
      <h3 className="section-title">{t("production.cycles")}</h3>
      <table className="cycles">
        <thead><tr><th>{t("production.cycle")}</th><th>{t("production.shortest")}</th><th>{t("production.median")}</th><th>{t("production.longest")}</th></tr></thead>
        <tbody>
          <tr><th>{t("production.measured", { count: good.length })}</th><td>{cell(spread.shortest)}</td><td>{cell(spread.median)}</td><td>{cell(spread.longest)}</td></tr>
          <tr><th>{t(proved?.declared ? "production.declared" : "production.proved")}</th><td>{cell(proved?.shortest)}</td><td>–</td><td>{cell(proved?.longest)}</td></tr>
        </tbody>
      </table>
      <Bars cycles={good.slice(-60)} longest={proved?.longest ?? undefined} />
      {proved && result && <ByWay cycles={shift.cycles} ways={result.ways} all={result.all_ways} />}
    </section>
  );
}

const width = 640, height = 140, left = 48, bottom = 8;

function Bars({ cycles, longest }: { cycles: readonly Cycle[]; longest: number | undefined }) {
  const measured = Math.max(...cycles.map((each) => each.took));
  // A bound far away would press the bars flat; the table has it.
  const line = longest !== undefined && longest < 4 * measured ? longest : undefined;
  const top = Math.max(measured, line ?? 0) * 1.1, y = (value: number) => height - bottom - (value / top) * (height - bottom - 8);
  const each = (width - left) / Math.max(cycles.length, 12);
  return (
    <svg className="cycle-bars" viewBox={`0 0 ${width} ${height}`} role="img" aria-label={t("production.bars", { count: cycles.length })}>
      {ticks(0, top).map((at) => <g key={at}><path className="grid" d={`M${left} ${y(at)}H${width}`} /><text x={left - 6} y={y(at)} textAnchor="end" dominantBaseline="middle">{number(at)} s</text></g>)}
      {cycles.map((one, i) => <rect key={one.run} x={left + i * each + 1} width={Math.max(1, each - 2)} y={y(one.took)} height={height - bottom - y(one.took)}><title>{`${one.run}: ${duration(one.took)}`}</title></rect>)}
      {line !== undefined && <path className="limit" d={`M${left} ${y(line)}H${width}`} />}
    </svg>
  );
}

function Stops({ shift }: { shift: Shift }) {
  if (shift.stops.length === 0) return <p className="nothing good"><Symbol name="tick" size={18} />{t("production.noStops")}</p>;
  return (
    <section>
      <h3 className="section-title">{t("production.stops", { count: shift.stops.length })}</h3>
      <table className="stops">
        <thead><tr><th>{t("production.when")}</th><th>{t("production.what")}</th><th>{t("production.why")}</th><th>{t("production.stood")}</th></tr></thead>
        <tbody>
          {[...shift.stops].reverse().slice(0, 100).map((each) => (
            <tr key={each.run} data-run={each.run}>
              <td>{moment(new Date(each.from).toISOString())}</td><td>{each.name}</td>
              <td><b>{t(`production.state.${each.state === "broken off" ? "brokenOff" : each.state}` as "production.state.stopped", { code: each.code ?? 0 })}</b> {causeOf(each.reason).what}</td>
              <td className="figure">{each.until === undefined ? t("production.still") : duration((each.until - each.from) / 1000)}</td>
            </tr>
          ))}
        </tbody>
      </table>
    </section>
  );
}
