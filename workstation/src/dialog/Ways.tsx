// All ways through the operation with their shortest and longest times.
import { useChecks } from "../state/checks";
import { duration, t } from "../words/words";

export default function Ways() {
  const result = useChecks((state) => state.result);
  if (!result || result.ways.length === 0) return <p className="nothing">{t("ways.none")}</p>;
  return (
    <div className="help">
      <p className="hint">{t("ways.explain")}</p>
      <ul className="way-list">
        {result.ways.map((way, i) => (
          <li key={i}>
            <p className="way-times">
              {way.shortest_s >= 0.005 && <b>{t("ways.from", { time: duration(way.shortest_s) })}</b>}
              {way.longest_s === null ? <span className="hint">{t("ways.unknown", { why: way.unbounded.join(", ") })}</span> : <b>{t("ways.to", { time: duration(way.longest_s) })}</b>}
              {way.declared && way.longest_s !== null && <span className="hint">{t("time.declared")}</span>}
              {way.alike > 1 && <span className="hint">{t("ways.alike", { count: way.alike })}</span>}
            </p>
            <p className="way-icons">{[...way.icons, way.end].join(" → ")}</p>
          </li>
        ))}
      </ul>
      {!result.all_ways && <p className="hint">{t("ways.more")}</p>}
    </div>
  );
}
