// Cycle times by the way that each run has taken, beside the longest time of that way.
import { useEffect, useState } from "react";
import type { Way } from "../../generated/protocol";
import { call } from "../state/cell";
import { duration, t } from "../words/words";
import { byWay, lastOf, type Passed } from "./ways";
import type { Cycle } from "./shift";

/** What acted in a run does not change when it has ended. */
const known = new Map<number, readonly Passed[]>();
const most = 200;

async function stepsOf(run: number): Promise<void> {
  const passed: Passed[] = [];
  for (let after = 0, more = true; more; ) {
    const page = await call("history.read", { run, after, limit: 1000 });
    for (const { step } of page.steps) passed.push({ icon: step.icon ?? "", code: step.code });
    after = page.steps.at(-1)?.step.step ?? after;
    more = page.more && page.steps.length > 0;
  }
  known.set(run, passed);
}

export function ByWay({ cycles, ways, all }: { cycles: readonly Cycle[]; ways: readonly Way[]; all: boolean }) {
  const [, read] = useState(0);
  const last = cycles.slice(-most), wanted = last.map((each) => each.run).join();
  useEffect(() => {
    let current = true;
    void (async () => {
      for (const { run } of last) {
        if (!current) return;
        // A run that the history has dropped meanwhile is left out.
        if (!known.has(run)) await stepsOf(run).catch(() => {});
      }
      if (current) read((count) => count + 1);
    })();
    return () => void (current = false);
    // eslint-disable-next-line -- the runs are told by their numbers
  }, [wanted]);
  const taken = byWay(ways, last, known);
  if (taken.length === 0) return null;
  const time = (value: number | null | undefined) => (typeof value === "number" && value >= 0.005 ? duration(value) : "–");
  return (
    <section className="by-way">
      <h3 className="section-title">{t("production.byWay")}</h3>
      <table className="cycles">
        <thead><tr><th>{t("production.way")}</th><th>{t("production.count")}</th><th>{t("production.shortest")}</th><th>{t("production.median")}</th><th>{t("production.longest")}</th><th>{t("production.limit")}</th></tr></thead>
        <tbody>
          {taken.map(({ way, count, spread }, i) => {
            const limit = way?.longest_s, over = typeof limit === "number" && spread.longest > limit;
            return (
              <tr key={i} data-over={over || undefined}>
                <th>{way ? <>{way.end}<small>{t("production.last", { icon: lastOf(way) })}</small></> : t(all ? "production.otherWay" : "production.unknownWay")}</th>
                <td>{count}</td><td>{time(spread.shortest)}</td><td>{time(spread.median)}</td><td>{time(spread.longest)}</td>
                <td>{way ? <>{time(limit)}{way.declared && typeof limit === "number" && <small>{t("time.declared")}</small>}</> : "–"}</td>
              </tr>
            );
          })}
        </tbody>
      </table>
    </section>
  );
}
