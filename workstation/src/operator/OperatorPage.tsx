// The operator's page, to be read from two metres: what the cell does, the acts that an operator has, questions, and the
// parameters that the operation sets free. Everything else is shown, locked.
import { useEffect, useMemo, useState } from "react";
import { Button } from "react-aria-components";
import type { Methods } from "../../generated/protocol";
import { Question } from "../execution/Question";
import { ControlsButton } from "../execution/ControlsButton";
import { operationNamed, iconOf, type Drawing, type Operation } from "../model/operation";
import { ask, pause, resume, stop } from "../state/acts";
import { causeOf, culprit } from "../state/cause";
import { call, useCell } from "../state/cell";
import { setTheme, theme } from "../state/theme";
import type { SymbolName } from "../symbols/drawings";
import { Symbol } from "../symbols/Symbol";
import { clock, currentLanguage, languages, setLanguage, t, type Language } from "../words/words";
import { FreeParameters } from "./FreeParameters";
import { lookAsOperator } from "./mode";
import { partsOf } from "./parts";
import { Today } from "./Today";

type Look = "idle" | "acting" | "halted" | "stopped" | "failed" | "ended" | "away";

const symbols: Record<Look, SymbolName> = { idle: "minus", acting: "run", halted: "pause", stopped: "hand", failed: "error", ended: "tick", away: "warning" };

const nested = (path: string) => path.replaceAll("/", " › ");

/** The operation that the cell has loaded. */
function useLoaded(): Drawing | undefined {
  const loaded = useCell((cell) => cell.present?.snapshot.loaded);
  const text = loaded?.files[loaded.main];
  return useMemo(() => {
    if (text === undefined) return undefined;
    try {
      return JSON.parse(text) as Drawing;
    } catch {
      return undefined;
    }
  }, [text]);
}

/** The operation in which an icon lies. */
function ownerOf(drawing: Drawing, path: string): Operation | undefined {
  let operation: Operation | undefined = drawing as Operation;
  for (const part of path.split("/").slice(0, -1)) operation = operationNamed(drawing, (operation && iconOf(operation, part)?.operation) ?? "");
  return operation;
}

export default function OperatorPage() {
  const link = useCell((cell) => cell.link);
  const snapshot = useCell((cell) => cell.present?.snapshot);
  const failed = useCell((cell) => culprit(cell.present));
  const reason = useCell((cell) => (failed === undefined ? "" : cell.present?.runs.get(failed)?.reason) || (cell.present?.snapshot.reason ?? ""));
  const drawing = useLoaded();
  if (!snapshot) return <div className="operator"><Headline look="away" headline={t("state.connecting")} detail="" /></div>;
  const running = snapshot.activity === "operation" || snapshot.activity === "skill";
  const look: Look = link !== "ready" ? "away" : snapshot.hold || snapshot.stopping ? "stopped" : running ? "acting" : snapshot.state === "paused" ? "halted"
    : snapshot.state === "stopped" ? "stopped" : snapshot.state === "failed" || (snapshot.state === "ended" && snapshot.last_code !== 0) ? "failed" : snapshot.state === "ended" ? "ended" : "idle";
  const word = link !== "ready" ? t("state.away") : snapshot.hold ? t("state.hold") : snapshot.stopping ? t("state.stopping") : running ? t(snapshot.pausing ? "state.pausing" : "state.running")
    : snapshot.operation === "" ? t("operator.choose") : t(`state.${snapshot.state}` as "state.ready");
  const here = snapshot.here?.icon ?? snapshot.token;
  const icon = drawing && here !== "" ? iconOf(ownerOf(drawing, here) ?? (drawing as Operation), here.split("/").at(-1)!) : undefined;
  const detail = look === "failed" ? [failed && nested(failed), causeOf(reason).what].filter(Boolean).join(": ") : snapshot.hold ? `${snapshot.hold.by}${snapshot.hold.reason ? `: ${snapshot.hold.reason}` : ""}` : running || look === "halted" ? nested(here) : "";
  return (
    <div className="operator" data-look={look}>
      <header className="operator-bar">
        <h1>{snapshot.operation === "" ? t("state.cell", { name: snapshot.cell }) : snapshot.operation}</h1>
        <span className="grow" />
        <ControlsButton />
        {(Object.keys(languages) as Language[]).filter((each) => each !== currentLanguage()).map((each) => <Button key={each} className="button quiet" onPress={() => setLanguage(each)}>{languages[each]}</Button>)}
        <Button className="button quiet only" aria-label={t("settings.theme")} onPress={() => setTheme(theme() === "dark" ? "light" : "dark")}><Symbol name="contrast" /></Button>
        {snapshot.role === "programmer" && <Button className="button" onPress={() => lookAsOperator(false)}><Symbol name="operation" size={18} />{t("operator.leave")}</Button>}
      </header>
      <main className="operator-middle">
        <section className="operator-now" aria-label={t("operator.now")}>
          <Headline look={look} headline={word} detail={detail} running={running} />
          {icon?.note && running && <p className="operator-note">{icon.note}</p>}
          <Acts look={look} mayAct={snapshot.role !== "viewer"} loaded={snapshot.operation !== ""} running={running} />
          <Choices look={look} mayAct={snapshot.role !== "viewer"} />
          <Question />
          {snapshot.operation !== "" && <Today name={snapshot.operation} />}
        </section>
        <section className="operator-side" aria-label={t("operator.parameters")}>
          <Operations current={snapshot.operation} idle={!running && link === "ready" && snapshot.role !== "viewer"} />
          {drawing && <FreeParameters parts={partsOf(drawing)} idle={!running && link === "ready" && snapshot.role !== "viewer"} />}
        </section>
      </main>
    </div>
  );
}

function Headline({ look, headline, detail, running = false }: { look: Look; headline: string; detail: string; running?: boolean }) {
  return (
    <div className="operator-state" data-look={look} role="status">
      <Symbol name={symbols[look]} size={56} />
      <div><span className="state-headline">{headline}</span>{detail !== "" && <span className="operator-detail">{detail}</span>}</div>
      {running && <Since />}
    </div>
  );
}

function Since() {
  const began = useCell((cell) => cell.present?.beganAt ?? 0);
  const [now, setNow] = useState(Date.now());
  useEffect(() => {
    const timer = setInterval(() => setNow(Date.now()), 500);
    return () => clearInterval(timer);
  }, []);
  return <span className="operator-clock" aria-hidden="true">{clock((now - began) / 1000)}</span>;
}

function Acts({ look, mayAct, loaded, running }: { look: Look; mayAct: boolean; loaded: boolean; running: boolean }) {
  const halted = look === "halted" || look === "stopped";
  const act = (name: string, symbol: SymbolName, text: string, what: () => Promise<unknown>, disabled: boolean, kind = "") => (
    <Button className={`button operator-act ${kind}`} data-act={name} isDisabled={disabled} onPress={() => void what()}><Symbol name={symbol} size={32} /><span>{text}</span></Button>
  );
  const away = look === "away";
  return (
    <div className="operator-acts" role="group" aria-label={t("run.group")}>
      {halted ? act("run.resume", "resume", t("run.resume"), resume, !mayAct || running || away, "primary") : act("run.run", "run", t("run.run"), () => ask("operation.run"), !mayAct || !loaded || running || away, "primary")}
      {act("run.pause", "pause", t("run.pause"), pause, !running || away)}
      {act("run.stop", "stop", t("run.stop"), stop, away, "stop")}
    </div>
  );
}

type Choice = Methods["operation.outlook"]["result"]["choices"][number];

/** After a stop or a fault: from where to go on, in large. */
function Choices({ look, mayAct }: { look: Look; mayAct: boolean }) {
  const steps = useCell((cell) => cell.present?.snapshot.steps);
  const [choices, setChoices] = useState<readonly Choice[]>([]);
  useEffect(() => {
    setChoices([]);
    if (look !== "failed" && look !== "stopped") return;
    let current = true;
    call("operation.outlook", {}).then((result) => current && setChoices(result.choices), () => {});
    return () => void (current = false);
  }, [look, steps]);
  if (choices.length === 0 || !mayAct) return null;
  const take = async (choice: Choice) => {
    if (choice.method === "operation.from") {
      if (await ask("operation.from", { icon: choice.icon })) await ask("operation.run");
    } else {
      await ask(choice.method);
    }
  };
  return (
    <ul className="operator-choices">
      {choices.map((each) => (
        <li key={`${each.place}:${each.icon}`}>
          <Button className="button" onPress={() => void take(each)}>{t(`goOn.${each.place}`, { icon: each.place === "start" ? t("kind.start") : nested(each.icon) })}</Button>
          <p>{each.preconditions.length > 0 ? `${t("goOn.must")} ${each.preconditions.join(" ")}` : ""}</p>
        </li>
      ))}
    </ul>
  );
}

/** The operations of the store: an operator loads one by its name. */
function Operations({ current, idle }: { current: string; idle: boolean }) {
  const stored = useCell((cell) => cell.stored);
  const name = useCell((cell) => cell.present?.snapshot.loaded?.stored?.name);
  if (!stored || stored.length === 0) return current === "" ? <p className="nothing">{t("operator.none")}</p> : null;
  return (
    <section>
      <h2>{t("operator.operations")}</h2>
      <ul className="operator-stored">
        {stored.map((each) => (
          <li key={each.name}>
            <Button className="button" data-selected={each.name === name || undefined} isDisabled={!idle} onPress={() => void ask("operation.load", { name: each.name })}>
              <Symbol name={each.name === name ? "tick" : "operation"} size={20} /><span>{each.name}</span>
            </Button>
          </li>
        ))}
      </ul>
    </section>
  );
}
