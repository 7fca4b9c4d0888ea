// How often the loaded operation has ended well in the last eight hours, and how it ended last.
import { useEffect, useState } from "react";
import type { Run } from "../../generated/protocol";
import { shiftOf, spreadOf } from "../production/shift";
import { causeOf } from "../state/cause";
import { call, onEvent } from "../state/cell";
import { Symbol } from "../symbols/Symbol";
import { duration, moment, number, t } from "../words/words";

const eight_hours = 8 * 3_600_000;

export function Today({ name }: { name: string }) {
  const [runs, setRuns] = useState<readonly Run[]>([]);
  useEffect(() => {
    let current = true;
    const read = () => void call("history.list", { name, limit: 200 }).then((page) => current && setRuns(page.runs), () => {});
    read();
    const stop = onEvent((event) => event.event === "state" && event.state !== "running" && read());
    return () => {
      current = false;
      stop();
    };
  }, [name]);
  const shift = shiftOf(runs, name, Date.now() - eight_hours, Date.now());
  const last = spreadOf(shift.cycles.slice(-1)), ended = runs.filter((each) => each.state !== "running").slice(0, 5);
  if (shift.runs === 0) return null;
  return (
    <section className="operator-today" aria-label={t("operator.today")}>
      <dl>
        <div><dt>{t("production.good")}</dt><dd>{number(shift.good)}</dd></div>
        <div><dt>{t("operator.notGood")}</dt><dd>{number(shift.other + shift.broken)}</dd></div>
        <div><dt>{t("operator.lastCycle")}</dt><dd>{last ? duration(last.median) : "–"}</dd></div>
      </dl>
      <ol>
        {ended.map((each) => {
          const good = each.state === "ended" && each.code === 0;
          return <li key={each.run} data-good={good || undefined}><Symbol name={good ? "tick" : "warning"} size={20} /><span>{moment(each.begun)}</span><b>{t(`production.state.${each.state === "broken off" ? "brokenOff" : each.state}` as "production.state.stopped", { code: each.code ?? 0 })}</b><span className="why">{good ? "" : causeOf(each.reason).what}</span></li>;
        })}
      </ol>
    </section>
  );
}
