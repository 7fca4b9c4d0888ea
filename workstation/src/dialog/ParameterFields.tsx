// The parameters of a skill or of a sub-operation: each with its unit, range, default and words. While the operation
// is paused a change also reaches the cell, and counts from the icon's next run on.
import { Button, Checkbox } from "react-aria-components";
import type { Finding, Parameter } from "../../generated/protocol";
import { amountText } from "../canvas/summary";
import { setParameter } from "../model/edit";
import { isSource, operationNamed, type Icon, type Source, type Value } from "../model/operation";
import { setWhilePaused } from "../state/acts";
import { useCell } from "../state/cell";
import { useChecks } from "../state/checks";
import { useDrawing } from "../state/drawing";
import { change } from "../state/edits";
import { HereButtons } from "../teaching/HereButtons";
import { Symbol } from "../symbols/Symbol";
import { t } from "../words/words";
import { AmountBox } from "./AmountBox";
import { Choose } from "./Choose";
import { rangeText } from "./NumberBox";
import { OperatorField } from "./OperatorField";
import { TextBox } from "./TextBox";

function parametersOf(icon: Icon, skills: ReturnType<typeof useCell.getState>["skills"]): Parameter[] {
  if (icon.kind === "skill") return skills.get(icon.skill ?? "")?.parameters ?? [];
  const sub = icon.operation && !icon.file ? operationNamed(useDrawing.getState().drawing, icon.operation) : undefined;
  return Object.entries(sub?.arguments ?? {}).map(([name, each]): Parameter => ({
    name, default: each.default, description: each.note ?? "", location: false, unit: "unit" in each ? (each.unit ?? "") : "",
    type: typeof each.default === "boolean" ? "boolean" : typeof each.default === "string" ? "text" : "whole" in each && each.whole ? "integer" : "real",
    ...("from" in each ? { low: each.from, high: each.to } : {}),
  }));
}

export function ParameterFields({ icon, operation }: { icon: Icon; operation: string }) {
  const skills = useCell((state) => state.skills);
  const findings = useChecks((state) => state.findings.get(`${operation}/${icon.id}`));
  const parameters = parametersOf(icon, skills);
  if (parameters.length === 0) return <p className="hint">{t("parameters.none")}</p>;
  return (
    <div className="parameters">
      {parameters.map((each) => <Field key={each.name} icon={icon} operation={operation} parameter={each} findings={findings ?? []} />)}
    </div>
  );
}

interface FieldProps {
  icon: Icon;
  operation: string;
  parameter: Parameter;
  findings: readonly Finding[];
}

function Field({ icon, operation, parameter, findings }: FieldProps) {
  const locations = useCell((state) => state.locations);
  const value = icon.parameters?.[parameter.name];
  const set = (now: Value | Source | undefined) => {
    const before = useDrawing.getState().drawing;
    change(operation, icon.id, "edit.parameter", (each) => setParameter(each, parameter.name, now), `${operation}/${icon.id}/${parameter.name}`);
    if (!isSource(now)) void setWhilePaused(operation, icon.id, parameter.name, now ?? parameter.default, before);
  };
  const refusal = findings.find((each) => each.field === `parameters/${parameter.name}` && each.severity === "error")?.message;
  const changed = value !== undefined;
  const range = rangeText(parameter.low, parameter.high, parameter.unit);
  const hint = [parameter.description, range].filter(Boolean).join(" · ");
  return (
    <div className="parameter" data-changed={changed || undefined}>
      <Control {...{ parameter, value, set, hint, operation, locations: locations?.map((each) => each.location), ...(refusal ? { refusal } : {}) }} />
      <OperatorField icon={icon} operation={operation} parameter={parameter} />
      {changed && (
        <Button className="button quiet small reset" onPress={() => set(undefined)}>
          <Symbol name="undo" size={14} /><span className="hidden">{parameter.name}</span>{t("parameters.default", { value: amountText(parameter.default, parameter.unit) })}
        </Button>
      )}
    </div>
  );
}

interface ControlProps {
  parameter: Parameter;
  value: Value | Source | undefined;
  set(value: Value | Source | undefined): void;
  hint: string;
  operation: string;
  /** Undefined: the cell does not tell, so a name is typed. */
  locations: readonly string[] | undefined;
  refusal?: string;
}

function Control({ parameter, value, set, hint, operation, locations, refusal }: ControlProps) {
  if (parameter.type === "boolean" && !isSource(value))
    return (
      <div className="field">
        <Checkbox className="checkbox" isSelected={(value ?? parameter.default) === true} onChange={(now) => set(now === parameter.default ? undefined : now)}>
          <span className="box"><Symbol name="tick" size={14} /></span>{parameter.name}
        </Checkbox>
        <span className="hint">{hint}</span>
      </div>
    );
  if (parameter.type === "text" && parameter.location && locations && !isSource(value))
    return (
      <div className="field">
        <Choose label={parameter.name} value={String(value ?? parameter.default)} onChange={set} hint={refusal ?? hint} options={locations.map((id) => ({ id, name: id }))} />
        <HereButtons name={parameter.name} onTaught={set} />
      </div>
    );
  if (parameter.type === "text" && !isSource(value))
    return <TextBox label={parameter.name} value={String(value ?? parameter.default)} onChange={set} hint={refusal ?? hint} />;
  return (
    <AmountBox label={parameter.name} operation={operation} value={value as number | Source | undefined} onChange={set} unit={parameter.unit} hint={hint}
      whole={parameter.type === "integer"} {...(typeof parameter.default === "number" ? { fallback: parameter.default } : {})}
      {...(parameter.low === undefined ? {} : { low: parameter.low })} {...(parameter.high === undefined ? {} : { high: parameter.high })} {...(refusal ? { refusal } : {})} />
  );
}
