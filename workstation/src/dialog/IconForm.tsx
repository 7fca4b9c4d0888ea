// Everything that can be set at an icon, by its kind: the dialog box behind it.
import { useEffect, useState } from "react";
import { Button } from "react-aria-components";
import { meaningText } from "../canvas/CodeRows";
import { meaningsOf } from "../model/codes";
import { setField } from "../model/edit";
import { iconOf, operationNamed, type Icon } from "../model/operation";
import { outputs } from "../model/ports";
import { isLoaded } from "../canvas/runState";
import { pathsTo } from "../state/acts";
import { causeOf } from "../state/cause";
import { useCell } from "../state/cell";
import { useDrawing } from "../state/drawing";
import { change, rename } from "../state/edits";
import { Symbol } from "../symbols/Symbol";
import { t } from "../words/words";
import { AmountBox } from "./AmountBox";
import { CaseFields } from "./CaseFields";
import { Choose } from "./Choose";
import { NextField } from "./NextField";
import { NumberBox } from "./NumberBox";
import { ParameterFields } from "./ParameterFields";
import { PlannedFields } from "./PlannedFields";
import { QuestionFields } from "./QuestionFields";
import { ReadingFields } from "./ReadingFields";
import { TextBox } from "./TextBox";

interface Props {
  operation: string;
  id: string;
  onRenamed(id: string): void;
}

export function IconForm({ operation, id, onRenamed }: Props) {
  const drawing = useDrawing((state) => state.drawing);
  const owner = operationNamed(drawing, operation);
  const icon = owner && iconOf(owner, id);
  if (!icon) return <p className="nothing">{t("form.gone")}</p>;
  return (
    <div className="form">
      <Failed operation={operation} id={id} />
      <NameField key={id} operation={operation} id={id} onRenamed={onRenamed} />
      <Fields icon={icon} operation={operation} />
      {icon.kind !== "case" && icon.kind !== "question" && outputs(icon).length > 0 && (
        <details className="more">
          <summary>{t("form.lines")}</summary>
          {outputs(icon).map((port) => <NextField key={port.name} operation={operation} icon={icon} port={port.name} />)}
        </details>
      )}
      <TextBox label={t("form.note")} long value={icon.note ?? ""} onChange={(note) => change(operation, id, "edit.note", (each) => setField(each, "note", note || undefined), `${operation}/${id}/note`)} />
    </div>
  );
}

/** Why it came to nothing when it ran last: what is to be changed stands below. */
function Failed({ operation, id }: { operation: string; id: string }) {
  const drawing = useDrawing((state) => state.drawing);
  const run = useCell((cell) => {
    if (!isLoaded(cell, drawing.name)) return undefined;
    return pathsTo(drawing, operation).map((prefix) => cell.present?.runs.get(prefix + id)).find((each) => each?.kind !== undefined && each.kind !== "normal");
  });
  if (!run) return null;
  return (
    <div className="finding" data-severity="error">
      <Symbol name="error" size={18} />
      <div><p>{t("form.failed", { code: run.code ?? 0 })}</p>{run.reason !== "" && <p className="finding-hint">{causeOf(run.reason).what}</p>}</div>
    </div>
  );
}

/** The name is changed when the field is left: each key stroke would be another name. */
function NameField({ operation, id, onRenamed }: Props) {
  const [text, setText] = useState(id);
  useEffect(() => setText(id), [id]);
  const leave = () => {
    const wanted = text.replaceAll("/", "-").trim();
    if (wanted === "" || wanted === id) return setText(id);
    onRenamed(rename(operation, id, wanted));
  };
  return <TextBox label={t("form.name")} value={text} onChange={setText} onBlur={leave} />;
}

function Fields({ icon, operation }: { icon: Icon; operation: string }) {
  const put = <K extends keyof Icon>(field: K, value: Icon[K] | undefined) =>
    change(operation, icon.id, "edit.field", (each) => setField(each, field, value), `${operation}/${icon.id}/${field}`);
  switch (icon.kind) {
    case "skill":
      return <><ParameterFields icon={icon} operation={operation} /><Codes icon={icon} /><SkillRepeats icon={icon} operation={operation} put={put} /></>;
    case "operation":
      return (
        <>
          <ParameterFields icon={icon} operation={operation} />
          <AmountBox label={t("form.repeat")} operation={operation} value={icon.repeat} onChange={(value) => put("repeat", value === 1 ? undefined : value)} fallback={1} low={1} high={1_000_000} whole hint={t("form.repeatHint")} />
        </>
      );
    case "case": return <CaseFields icon={icon} operation={operation} />;
    case "question": return <QuestionFields icon={icon} operation={operation} />;
    case "planned": return <PlannedFields icon={icon} operation={operation} />;
    case "delay":
      return <AmountBox label={t("form.seconds")} operation={operation} value={icon.seconds} onChange={(value) => value !== undefined && put("seconds", value)} unit="s" low={0} high={86400} />;
    case "wait":
      return <><ReadingFields icon={icon} operation={operation} /><AmountBox label={t("form.timeout")} operation={operation} value={icon.timeout} onChange={(value) => put("timeout", value)} unit="s" low={0} high={86400} optional hint={t("form.timeoutHint")} /></>;
    case "test": return <ReadingFields icon={icon} operation={operation} />;
    case "zero": return <SensorField icon={icon} put={put} />;
    case "exit":
      return <AmountBox label={t("form.code")} operation={operation} value={icon.code} onChange={(value) => put("code", value)} low={-1_000_000} high={1_000_000} whole optional hint={t("form.codeHint")} />;
    default: return null;
  }
}

type Put = <K extends keyof Icon>(field: K, value: Icon[K] | undefined) => void;

function SensorField({ icon, put }: { icon: Icon; put: Put }) {
  const sensors = useCell((state) => state.sensors);
  return <Choose label={t("reading.subject")} value={icon.sensor ?? ""} onChange={(value) => put("sensor", value)} options={sensors.map((each) => ({ id: each.sensor, name: each.sensor, aside: each.unit }))} />;
}

/** Codes with which the skill ends, in words. */
function Codes({ icon }: { icon: Icon }) {
  const drawing = useDrawing((state) => state.drawing);
  const skills = useCell((state) => state.skills);
  const meanings = meaningsOf(drawing, icon, skills);
  if (meanings.length === 0) return null;
  return (
    <div className="field">
      <span className="label">{t("form.codes")}</span>
      <ul className="meanings">{meanings.map((each) => <li key={each.code} data-kind={each.kind}><b>{each.code}</b> {meaningText(each)}</li>)}</ul>
    </div>
  );
}

function SkillRepeats({ icon, operation, put }: { icon: Icon; operation: string; put: Put }) {
  const set = icon.repeat !== undefined || icon["time-limit"] !== undefined || icon.retries !== undefined;
  const [open, setOpen] = useState(set);
  if (!open && !set) return <Button className="button quiet" onPress={() => setOpen(true)}><Symbol name="plus" size={16} />{t("form.repeats")}</Button>;
  return (
    <>
      <AmountBox label={t("form.repeat")} operation={operation} value={icon.repeat} onChange={(value) => put("repeat", value === 1 ? undefined : value)} fallback={1} low={1} high={1_000_000} whole hint={t("form.repeatHint")} />
      <AmountBox label={t("form.timeLimit")} operation={operation} value={icon["time-limit"]} onChange={(value) => put("time-limit", value)} unit="s" low={0.001} high={86400} optional hint={t("form.timeLimitHint")} />
      <NumberBox label={t("form.retries")} value={icon.retries} onChange={(value) => put("retries", value === 0 ? undefined : value)} fallback={0} low={0} high={1000} whole hint={t("form.retriesHint")} />
    </>
  );
}
