// The cell's state, the loudest thing on the page.
import { useEffect, useState } from "react";
import { Button } from "react-aria-components";
import { useFollow } from "../canvas/Follow";
import { causeOf, culprit } from "../state/cause";
import { useCell } from "../state/cell";
import { useChecks } from "../state/checks";
import { useDrawing } from "../state/drawing";
import { openWindow } from "../state/windows";
import type { SymbolName } from "../symbols/drawings";
import { Symbol } from "../symbols/Symbol";
import { clock, duration, t } from "../words/words";

type Look = "idle" | "acting" | "halted" | "stopped" | "failed" | "ended" | "away";

interface Told {
  look: Look;
  symbol: SymbolName;
  headline: string;
  detail: string;
}

/** An icon within others: "rub-in-square › side-1". */
const nested = (path: string): string => path.replaceAll("/", " › ");

function useTold(): Told {
  const link = useCell((cell) => cell.link);
  const snapshot = useCell((cell) => cell.present?.snapshot);
  const name = useDrawing((state) => state.drawing.name);
  const failed = useCell((cell) => {
    const icon = culprit(cell.present);
    const cause = causeOf((icon === undefined ? "" : cell.present?.runs.get(icon)?.reason) || (cell.present?.snapshot.state === "failed" ? cell.present.snapshot.reason : "")).what;
    return icon === undefined ? cause : cause === "" ? nested(icon) : `${nested(icon)}: ${cause}`;
  });
  if (link === "no-token") return { look: "away", symbol: "lock", headline: t("state.noToken"), detail: "" };
  if (link !== "ready" || !snapshot) return { look: "away", symbol: "warning", headline: t(link === "connecting" ? "state.connecting" : "state.away"), detail: t("state.awayDetail") };
  if (snapshot.hold) return { look: "stopped", symbol: "hand", headline: t("state.hold"), detail: snapshot.hold.by + (snapshot.hold.reason ? `: ${snapshot.hold.reason}` : "") };
  if (snapshot.stopping) return { look: "stopped", symbol: "stop", headline: t("state.stopping"), detail: snapshot.token };
  if (snapshot.activity === "skill") return { look: "acting", symbol: "run", headline: t("state.skill"), detail: snapshot.running?.skill ?? "" };
  if (snapshot.operation === "" || snapshot.operation !== name) {
    const other = snapshot.operation !== "" && (snapshot.state === "running" || snapshot.state === "paused" || snapshot.state === "stopped");
    if (!other) return { look: "idle", symbol: "minus", headline: t("state.idle"), detail: t("state.cell", { name: snapshot.cell }) };
  }
  const other = snapshot.operation === name ? "" : `${snapshot.operation}: `;
  switch (snapshot.state) {
    case "running": return { look: "acting", symbol: "run", headline: t(snapshot.pausing ? "state.pausing" : "state.running"), detail: other + nested(snapshot.here?.icon ?? snapshot.token) };
    case "paused": return { look: "halted", symbol: "pause", headline: t("state.paused"), detail: other + t("state.before", { icon: nested(snapshot.token) }) };
    case "stopped": return { look: "stopped", symbol: "stop", headline: t("state.stopped"), detail: other + nested(snapshot.token) };
    case "failed": return { look: "failed", symbol: "error", headline: t("state.failed"), detail: failed };
    case "ended": return snapshot.last_code !== 0
      ? { look: "failed", symbol: "error", headline: t("state.ended"), detail: [t("state.code", { code: snapshot.last_code }), failed].filter(Boolean).join(" · ") }
      : { look: "ended", symbol: "tick", headline: t("state.ended"), detail: t("state.code", { code: snapshot.last_code }) };
    default: return { look: "idle", symbol: "minus", headline: t("state.ready"), detail: t("state.cell", { name: snapshot.cell }) };
  }
}

export function StateBlock() {
  const { look, symbol, headline, detail } = useTold();
  const here = useCell((cell) => cell.present?.snapshot.here?.icon);
  return (
    <div className="state" data-look={look} role="status">
      <Symbol name={symbol} size={24} />
      <div className="state-words">
        <span className="state-headline">{headline}</span>
        <span className="state-detail" title={detail}>{detail}</span>
      </div>
      {look === "acting" && <Running />}
      {look !== "idle" && look !== "ended" && look !== "away" && here && (
        <Button className="button quiet only state-jump" aria-label={t("state.jump")} onPress={() => useFollow.setState((state) => ({ jump: state.jump + 1 }))}><Symbol name="target" /></Button>
      )}
      {(look === "idle" || look === "ended") && <Bounds />}
    </div>
  );
}

function Running() {
  const began = useCell((cell) => cell.present?.beganAt ?? 0);
  const [now, setNow] = useState(Date.now());
  useEffect(() => {
    const timer = setInterval(() => setNow(Date.now()), 250);
    return () => clearInterval(timer);
  }, []);
  return <span className="state-clock" aria-hidden="true">{clock((now - began) / 1000)}</span>;
}

/** A length of time that no line breaks. */
const whole = (seconds: number) => duration(seconds).replaceAll(" ", "\u00a0");

/** How long the operation takes, at least and at most; or what stands in its way. */
function Bounds() {
  const result = useChecks((state) => state.result);
  const empty = useDrawing((state) => state.drawing.icons.length === 0);
  // Nothing is wrong with an empty canvas.
  if (!result || empty) return null;
  if (result.errors > 0)
    return <Button className="button quiet small state-findings" data-error onPress={() => openWindow("findings", "/")}><Symbol name="error" size={16} />{t("state.errors", { count: result.errors })}</Button>;
  // Nothing is proved yet: a time would say nothing.
  if (result.shortest_s === null || result.ways.length === 0 || (result.shortest_s < 0.005 && result.longest_s === null)) return null;
  return (
    <Button className="button quiet small state-bounds" onPress={() => openWindow("ways")}>
      {result.longest_s === null ? t("state.atLeast", { time: whole(result.shortest_s) })
        // Nobody proves a shortest time: none but that of delays is known.
        : result.shortest_s < 0.005 ? t("state.atMost", { time: whole(result.longest_s) }) : t("state.bounds", { low: whole(result.shortest_s), high: whole(result.longest_s) })}
    </Button>
  );
}
