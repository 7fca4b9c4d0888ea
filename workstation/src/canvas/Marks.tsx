// The small marks at an icon: breakpoint, findings, what came of its last run, a note.
import { memo } from "react";
import type { Icon } from "../model/operation";
import { useCell } from "../state/cell";
import { useChecks } from "../state/checks";
import { useDrawing } from "../state/drawing";
import { openFindings } from "../state/windows";
import { Symbol } from "../symbols/Symbol";
import { t } from "../words/words";
import { breakText } from "./summary";
import { isLoaded, type RunState } from "./runState";

interface Props {
  icon: Icon;
  operation: string;
  path: string;
  run: RunState;
}

export const Marks = memo(function Marks({ icon, operation, path, run }: Props) {
  return (
    <>
      <BreakMark icon={icon} path={path} />
      <FindingMark icon={icon} operation={operation} />
      <RunMark path={path} run={run} />
      {icon.note && <span className="mark-note" title={icon.note}><Symbol name="note" size={14} /></span>}
    </>
  );
});

function BreakMark({ icon, path }: { icon: Icon; path: string }) {
  const name = useDrawing((state) => state.drawing.name);
  // Set in the cell by somebody else: the drawing does not have it.
  const others = useCell((cell) => icon.break === undefined && isLoaded(cell, name) ? cell.present?.snapshot.breakpoints.find((each) => each.icon === path) : undefined);
  const kept = icon.break ?? others;
  if (kept === undefined) return null;
  const on = kept.enabled ?? true, text = breakText(icon.break ?? { ...(others?.code === undefined ? {} : { code: others.code }) });
  return (
    <span className="mark-break" data-off={!on || undefined} title={text}>
      <Symbol name={on ? "breakpoint" : "breakpoint-off"} size={16} />
      {text !== "" && <span className="mark-code">{text}</span>}
    </span>
  );
}

function FindingMark({ icon, operation }: { icon: Icon; operation: string }) {
  const findings = useChecks((state) => state.findings.get(`${operation}/${icon.id}`));
  const real = findings?.filter((each) => each.severity !== "note") ?? [];
  if (real.length === 0) return null;
  const error = real.some((each) => each.severity === "error");
  return (
    <button type="button" tabIndex={-1} className="mark-finding nodrag" data-error={error || undefined} title={real.map((each) => each.message).join("\n")}
      aria-label={t("findings.at", { count: real.length, icon: icon.id })} onClick={() => openFindings(operation, icon.id)}>
      <Symbol name={error ? "error" : "warning"} size={16} />
      {real.length > 1 && <span>{real.length}</span>}
    </button>
  );
}

function RunMark({ path, run }: { path: string; run: RunState }) {
  const code = useCell((cell) => cell.present?.runs.get(path)?.code);
  const visits = useCell((cell) => cell.present?.runs.get(path)?.visits ?? 0);
  if (run === "none") return null;
  return (
    <span className="mark-run" data-run={run}>
      <Symbol name={run === "passed" ? "tick" : run === "failed" ? "cross" : run === "halted" ? "pause" : "run"} size={14} />
      {run !== "acting" && code !== undefined && <span>{code}</span>}
      {visits > 1 && <span className="visits">×{visits}</span>}
    </span>
  );
}
