// All breakpoints of the drawing: switched on and off, with the code and the condition at which they halt, removed, gone
// to. Below them those that somebody else has set in the cell alone.
import { useState } from "react";
import { Button, Checkbox } from "react-aria-components";
import type { Breakpoint } from "../../generated/protocol";
import { focusIcon } from "../canvas/keys";
import { breakText, sourceText } from "../canvas/summary";
import { sourcesIn } from "../dialog/AmountBox";
import { Choose } from "../dialog/Choose";
import { NumberBox } from "../dialog/NumberBox";
import { operationNamed, operationsOf, type Icon } from "../model/operation";
import { ask, pathsTo } from "../state/acts";
import { inCell, setBreakpoint, type KeptBreakpoint } from "../state/breakpoints";
import { useCell } from "../state/cell";
import { enter, useDrawing } from "../state/drawing";
import { Symbol } from "../symbols/Symbol";
import { t } from "../words/words";

function go(path: string): void {
  const parts = path.split("/");
  enter(parts.slice(0, -1), [parts.at(-1)!]);
  focusIcon(parts.at(-1));
}

export default function Breakpoints() {
  const drawing = useDrawing((state) => state.drawing);
  const cell = useCell((state) => state.present?.snapshot.breakpoints);
  const kept = operationsOf(drawing).flatMap((operation) => operation.icons.filter((icon) => icon.break).map((icon) => ({ operation: operation.name, icon })));
  const paths = new Set(kept.flatMap(({ operation, icon }) => pathsTo(drawing, operation).map((prefix) => prefix + icon.id)));
  const others = cell ? inCell(drawing).filter((each) => !paths.has(each.icon)) : [];
  if (kept.length === 0 && others.length === 0) return <p className="nothing">{t("breaks.none")}</p>;
  return (
    <div className="form">
      <ul className="breaks">{kept.map((each) => <Row key={`${each.operation}/${each.icon.id}`} {...each} />)}</ul>
      {others.length > 0 && <><h3 className="section-title">{t("breaks.others")}</h3><ul className="breaks">{others.map((each) => <OtherRow key={each.breakpoint} breakpoint={each} />)}</ul></>}
      {kept.length + others.length > 1 && (
        <Button className="button" onPress={() => {
          for (const each of kept) setBreakpoint(each.operation, each.icon.id, undefined);
          if (others.length > 0) void ask("operation.clear");
        }}><Symbol name="trash" size={16} />{t("breaks.clear")}</Button>
      )}
    </div>
  );
}

/** Without what is not set. */
const without = <K extends keyof KeptBreakpoint>(kept: KeptBreakpoint, ...fields: K[]): KeptBreakpoint =>
  Object.fromEntries(Object.entries(kept).filter(([name]) => !fields.includes(name as K)));

function Row({ operation, icon }: { operation: string; icon: Icon }) {
  const drawing = useDrawing((state) => state.drawing);
  const paths = pathsTo(drawing, operation).map((prefix) => prefix + icon.id);
  const hits = useCell((cell) => cell.present?.snapshot.operation === drawing.name
    ? cell.present.snapshot.breakpoints.filter((each) => paths.includes(each.icon)).reduce((sum, each) => sum + each.hits, 0) : 0);
  const kept = icon.break!;
  const [open, setOpen] = useState(false);
  const put = (next: KeptBreakpoint) => setBreakpoint(operation, icon.id, next, `${operation}/${icon.id}/break`);
  const text = breakText(kept);
  return (
    <li className="break">
      <div className="break-head">
        <Checkbox className="checkbox" isSelected={kept.enabled ?? true} onChange={(on) => put(on ? without(kept, "enabled") : { ...kept, enabled: false })} aria-label={t("breaks.on", { icon: icon.id })}>
          <span className="box"><Symbol name="tick" size={14} /></span>
        </Checkbox>
        <Button className="button quiet break-name" onPress={() => paths[0] !== undefined && go(paths[0])}>{paths[0] ?? icon.id}</Button>
        <span className="hint break-text">{[text === "" ? t("breaks.always") : text, hits > 0 ? t("breaks.hits", { count: hits }) : ""].filter(Boolean).join(" · ")}</span>
        <Button className="button quiet only" aria-label={t("breaks.when", { icon: icon.id })} aria-expanded={open} onPress={() => setOpen(!open)}><Symbol name={open ? "up" : "down"} size={16} /></Button>
        <Button className="button quiet only" aria-label={t("breaks.remove", { icon: icon.id })} onPress={() => setBreakpoint(operation, icon.id, undefined)}><Symbol name="trash" size={16} /></Button>
      </div>
      {open && <When operation={operation} kept={kept} put={put} />}
    </li>
  );
}

function When({ operation, kept, put }: { operation: string; kept: KeptBreakpoint; put(next: KeptBreakpoint): void }) {
  const drawing = useDrawing((state) => state.drawing);
  const sources = sourcesIn(operationNamed(drawing, operation));
  const chosen = kept.value ? sources.find((each) => sourceText(each.source) === sourceText(kept.value!)) : undefined;
  return (
    <div className="break-when">
      <NumberBox label={t("breaks.code")} value={kept.code} optional whole hint={t("breaks.codeHint")} onChange={(code) => put(code === undefined ? without(kept, "code") : { ...kept, code })} />
      <NumberBox label={t("breaks.every")} value={kept.every} fallback={1} low={1} high={1_000_000} whole hint={t("breaks.everyHint")} onChange={(every) => put(every === undefined || every === 1 ? without(kept, "every") : { ...kept, every })} />
      {sources.length > 0 && (
        <Choose label={t("breaks.condition")} value={chosen?.id ?? ""} options={[{ id: "none", name: t("breaks.noCondition") }, ...sources.map((each) => ({ id: each.id, name: sourceText(each.source) }))]}
          onChange={(id) => {
            const source = sources.find((each) => each.id === id)?.source;
            put(source ? { ...kept, value: source, "at-least": kept["at-least"] ?? 1 } : without(kept, "value", "at-least", "at-most"));
          }} />
      )}
      {kept.value && (
        <>
          <NumberBox label={t("reading.atLeast")} value={kept["at-least"]} optional onChange={(low) => put(low === undefined ? (kept["at-most"] === undefined ? kept : without(kept, "at-least")) : { ...kept, "at-least": low })} />
          <NumberBox label={t("reading.atMost")} value={kept["at-most"]} optional onChange={(high) => put(high === undefined ? (kept["at-least"] === undefined ? kept : without(kept, "at-most")) : { ...kept, "at-most": high })} />
        </>
      )}
    </div>
  );
}

function OtherRow({ breakpoint: each }: { breakpoint: Breakpoint }) {
  const { hits: _, ...rest } = each;
  return (
    <li className="break">
      <div className="break-head">
        <Checkbox className="checkbox" isSelected={each.enabled} onChange={(enabled) => void ask("operation.break", { ...rest, enabled })} aria-label={t("breaks.on", { icon: each.icon })}>
          <span className="box"><Symbol name="tick" size={14} /></span>
        </Checkbox>
        <Button className="button quiet break-name" onPress={() => go(each.icon)}>{each.icon}</Button>
        <span className="hint break-text">{each.code === undefined ? t("breaks.always") : t("break.code", { code: each.code })}</span>
        <Button className="button quiet only" aria-label={t("breaks.remove", { icon: each.icon })} onPress={() => void ask("operation.unbreak", { breakpoint: each.breakpoint })}><Symbol name="trash" size={16} /></Button>
      </div>
    </li>
  );
}
