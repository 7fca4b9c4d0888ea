// The line below an icon: the longest time that it may take; while it acts, how long it has; how it failed.
import { memo, useEffect, useState } from "react";
import type { Icon } from "../model/operation";
import { causeOf } from "../state/cause";
import { useCell } from "../state/cell";
import { useChecks } from "../state/checks";
import { clock, duration, t } from "../words/words";
import type { RunState } from "./runState";

interface Props {
  icon: Icon;
  operation: string;
  path: string;
  run: RunState;
}

export const Caption = memo(function Caption({ icon, operation, path, run }: Props) {
  const times = useChecks((state) => state.times.get(`${operation}/${icon.id}`));
  const reason = useCell((cell) => cell.present?.runs.get(path)?.reason ?? "");
  const acts = icon.kind === "skill" || icon.kind === "operation" || icon.kind === "delay" || icon.kind === "wait" || icon.kind === "test" || icon.kind === "zero" || icon.kind === "planned";
  if (!acts) return null;
  const longest = times?.longest_s;
  const proved = !times ? "" : longest === null || longest === undefined ? t("time.unknown") : t(times.declared ? "time.mostDeclared" : "time.most", { time: duration(longest) });
  if (run === "acting") return <div className="caption acting"><Since /> {proved}</div>;
  if (run === "failed" && reason !== "") return <div className="caption failed" title={reason}>{causeOf(reason).what}</div>;
  return <div className="caption" data-unknown={longest === null || undefined} title={times?.unknown || (times?.declared ? t("time.declared") : undefined)}>{proved}</div>;
});

/** Seconds since what acts had begun, once a quarter of a second. */
function Since() {
  const began = useCell((cell) => cell.present?.beganAt ?? 0);
  const [now, setNow] = useState(Date.now());
  useEffect(() => {
    const timer = setInterval(() => setNow(Date.now()), 250);
    return () => clearInterval(timer);
  }, []);
  return <span className="since">{clock((now - began) / 1000)}</span>;
}
