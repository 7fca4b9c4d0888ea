// All ways through the operation with their shortest and longest times: grouped by the end that they lead to, the slowest first.
import { Fragment } from "react";
import type { Way } from "../../generated/protocol";
import { useChecks } from "../state/checks";
import { duration, t } from "../words/words";

const slowest = (way: Way) => way.longest_s ?? Infinity;

export default function Ways() {
  const result = useChecks((state) => state.result);
  if (!result || result.ways.length === 0) return <p className="nothing">{t("ways.none")}</p>;
  const ends = byEnd(result.ways);
  const declared = result.ways.every((way) => way.declared || way.longest_s === null);
  return (
    <div className="help">
      <p className="hint">{t("ways.explain")}{declared && ` ${t("ways.allDeclared")}`}</p>
      {[...ends].map(([end, ways]) => (
        <section key={end}>
          <h3>{end}</h3>
          <ul className="way-list">
            {[...ways].sort((a, b) => slowest(b) - slowest(a)).map((way, i) => <li key={i}><Times way={way} telling={!declared} /><Icons way={way} /></li>)}
          </ul>
        </section>
      ))}
      {!result.all_ways && <p className="hint">{t("ways.more")}</p>}
    </div>
  );
}

function byEnd(ways: readonly Way[]): Map<string, Way[]> {
  const ends = new Map<string, Way[]>();
  for (const way of ways) ends.set(way.end, [...(ends.get(way.end) ?? []), way]);
  return ends;
}

/** `telling`: not all longest times are of one kind, so each says of which it is. */
function Times({ way, telling }: { way: Way; telling: boolean }) {
  return (
    <p className="way-times">
      {way.longest_s === null ? <span className="hint">{t("ways.unknown", { why: way.unbounded.join(", ") })}</span> : <b>{t("ways.to", { time: duration(way.longest_s) })}</b>}
      {way.shortest_s >= 0.005 && <span>{t("ways.from", { time: duration(way.shortest_s) })}</span>}
      {telling && way.declared && way.longest_s !== null && <span className="hint">{t("time.declared")}</span>}
      {way.alike > 1 && <span className="hint">{t("ways.alike", { count: way.alike })}</span>}
    </p>
  );
}

function Icons({ way }: { way: Way }) {
  return <p className="way-icons">{way.icons.map((each, i) => <Fragment key={i}>{i > 0 && " → "}<span>{each.replaceAll("/", " › ")}</span></Fragment>)}</p>;
}
