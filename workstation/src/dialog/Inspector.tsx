// The panel at the right: what is selected, else the operation itself with its times and findings.
import { Button } from "react-aria-components";
import { title } from "../canvas/summary";
import { familyOf, symbolOf } from "../canvas/family";
import { iconOf, operationNamed, withOperation, type Operation } from "../model/operation";
import { useCell } from "../state/cell";
import { useChecks } from "../state/checks";
import { edit, shownOperation, useDrawing } from "../state/drawing";
import { openIcon, openWindow, useWindows } from "../state/windows";
import { Miniature } from "../palette/Miniature";
import { Symbol } from "../symbols/Symbol";
import { duration, t } from "../words/words";
import { FindingsList } from "./FindingsList";
import { IconForm } from "./IconForm";
import { IconHelpButton } from "./IconHelpButton";
import { TextBox } from "./TextBox";
import "./windows.css";

export function Inspector() {
  const operation = useDrawing(shownOperation);
  const selected = useDrawing((state) => state.selected);
  const only = selected.size === 1 ? iconOf(operation, [...selected][0]!) : undefined;
  const skill = useCell((state) => state.skills.get(only?.skill ?? ""));
  const family = only && familyOf(only, skill);
  return (
    <aside className="inspector panel" aria-label={t("inspector.label")}>
      <div className="panel-head">
        {only && family ? <Miniature family={family} symbol={symbolOf(only, family)} /> : <Symbol name="operation" />}
        <h2 className="panel-title">{only ? title(only) : selected.size > 1 ? t("inspector.several", { count: selected.size }) : operation.name}</h2>
        <Button className="button quiet only" aria-label={t("inspector.fold")} onPress={() => useWindows.setState({ inspector: false })}><Symbol name="right" /></Button>
      </div>
      <div className="panel-body">
        {only ? <One operation={operation.name} icon={only.id} /> : selected.size > 1 ? <p className="hint">{t("inspector.severalHint")}</p> : <Whole operation={operation} />}
      </div>
      {only && <div className="panel-foot"><IconHelpButton operation={operation.name} icon={only.id} /></div>}
    </aside>
  );
}

function One({ operation, icon }: { operation: string; icon: string }) {
  const count = useChecks((state) => state.findings.get(`${operation}/${icon}`)?.length ?? 0);
  // One form for one icon: not here what a window over the page already shows.
  const dialog = useWindows((state) => state.open.some((each) => each.kind === "icon" && each.about === `${operation}/${icon}`));
  return (
    <>
      {count > 0 && <FindingsList operation={operation} icon={icon} />}
      {dialog
        ? <><p className="hint">{t("inspector.inDialog")}</p><Button className="button" onPress={() => openIcon(operation, icon)}><Symbol name="settings" size={16} />{t("inspector.toDialog")}</Button></>
        : <IconForm operation={operation} id={icon} onRenamed={() => {}} />}
    </>
  );
}

function Whole({ operation }: { operation: Operation }) {
  const result = useChecks((state) => state.result);
  const main = useDrawing((state) => state.drawing.name === operation.name);
  const put = (changed: Partial<Operation>, run: string) => edit("edit.operation", (drawing) => {
    const now = operationNamed(drawing, operation.name);
    return now ? withOperation(drawing, operation.name, { ...now, ...changed }) : drawing;
  }, { run: `operation:${operation.name}:${run}` });
  return (
    <>
      {main && result && result.ways.length > 0 && <Times shortest={result.shortest_s} longest={result.longest_s} runs={result.runs} declared={result.ways.some((way) => way.declared)} />}
      <TextBox label={t("inspector.description")} long value={operation.description ?? ""} onChange={(description) => put({ description }, "description")} />
      <h3 className="section-title">{t("findings.all")}</h3>
      <FindingsList operation={operation.name} icon="" />
    </>
  );
}

function Times({ shortest, longest, runs, declared }: { shortest: number | null; longest: number | null; runs: boolean; declared: boolean }) {
  if (!runs) return null;
  return (
    <div className="times">
      <div><span>{t("times.shortest")}</span><b>{shortest === null || shortest < 0.005 ? t("times.unknown") : duration(shortest)}</b></div>
      <div><span>{t("times.longest")}</span><b>{longest === null ? t("times.unknown") : duration(longest)}</b></div>
      {declared && longest !== null && <p className="hint">{t("time.declared")}</p>}
      <Button className="button quiet small" onPress={() => openWindow("ways")}>{t("times.ways")}</Button>
    </div>
  );
}
