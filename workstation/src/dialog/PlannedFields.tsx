// The dialog of a skill that nobody has written yet: what it is to be called, to be told and to end with. It runs as a
// question to a person. When the cell has the skill, the icon can become one of it.
import { Button } from "react-aria-components";
import { setField } from "../model/edit";
import type { Arguments, Icon } from "../model/operation";
import { useCell } from "../state/cell";
import { change } from "../state/edits";
import { Symbol } from "../symbols/Symbol";
import { t } from "../words/words";
import { NumberBox } from "./NumberBox";
import { TextBox } from "./TextBox";

type Argument = Arguments[string];

/** The values of its parameters go along where the skill has a parameter of that name. */
function become(icon: Icon, names: ReadonlySet<string>): Icon {
  const { codes: _, arguments: planned, kind: __, ...rest } = icon;
  const parameters = Object.fromEntries(Object.entries(planned ?? {}).filter(([name]) => names.has(name)).map(([name, each]) => [name, each.default]));
  return { ...rest, kind: "skill", ...(Object.keys(parameters).length > 0 ? { parameters } : {}) } as Icon;
}

export function PlannedFields({ icon, operation }: { icon: Icon; operation: string }) {
  const skill = useCell((state) => state.skills.get(icon.skill ?? ""));
  const codes = icon.codes ?? [];
  const put = <K extends keyof Icon>(field: K, value: Icon[K] | undefined) =>
    change(operation, icon.id, "edit.field", (each) => setField(each, field, value), `${operation}/${icon.id}/${field}`);
  return (
    <div className="ways">
      <p className="hint">{t("planned.explain")}</p>
      {skill && (
        <Button className="button primary" onPress={() => change(operation, icon.id, "edit.field", (each) => become(each, new Set(skill.parameters.map((one) => one.name))))}>
          <Symbol name="tick" size={16} />{t("planned.become", { skill: skill.skill })}
        </Button>
      )}
      <TextBox label={t("planned.skill")} value={icon.skill ?? ""} onChange={(text) => put("skill", text)} />
      <h3 className="section-title">{t("form.codes")}</h3>
      {codes.map((each, i) => (
        <div key={i} role="group" className="way planned-code" aria-label={t("planned.code", { number: i + 1 })}>
          <NumberBox label={t("planned.code", { number: i + 1 })} value={each.code} whole low={0} high={1_000_000} onChange={(code) => code !== undefined && put("codes", codes.map((one, j) => (j === i ? { ...one, code } : one)))} />
          <TextBox label={t("planned.meaning", { number: i + 1 })} value={each.text} onChange={(text) => put("codes", codes.map((one, j) => (j === i ? { ...one, text } : one)))} />
          <Button className="button quiet only" aria-label={t("planned.removeCode", { number: i + 1 })} isDisabled={codes.length <= 1} onPress={() => put("codes", codes.filter((_, j) => j !== i))}><Symbol name="trash" size={16} /></Button>
        </div>
      ))}
      {codes.length < 8 && <Button className="button" onPress={() => put("codes", [...codes, { code: Math.max(-1, ...codes.map((each) => each.code)) + 1, text: "" }])}><Symbol name="plus" size={16} />{t("planned.addCode")}</Button>}
      <h3 className="section-title">{t("help.parameters")}</h3>
      <PlannedArguments planned={icon.arguments ?? {}} put={(next) => put("arguments", Object.keys(next).length > 0 ? next : undefined)} />
    </div>
  );
}

function PlannedArguments({ planned, put }: { planned: Arguments; put(next: Arguments): void }) {
  const all = Object.entries(planned);
  const replaced = (index: number, name: string, value: Argument) => put(Object.fromEntries(all.map((each, i) => (i === index ? [name, value] : each))));
  const fresh = () => {
    let i = all.length + 1;
    while (planned[`parameter-${i}`]) ++i;
    put({ ...planned, [`parameter-${i}`]: { default: 0, from: 0, to: 100, unit: "mm" } });
  };
  return (
    <>
      {all.map(([name, each], i) => (
        <div key={i} role="group" className="way planned-argument" aria-label={name}>
          <div className="way-head">
            <TextBox label={t("form.name")} value={name} onChange={(now) => now !== "" && !(now in planned) && replaced(i, now, each)} />
            <Button className="button quiet only" aria-label={t("planned.removeParameter", { name })} onPress={() => put(Object.fromEntries(all.filter((_, j) => j !== i)))}><Symbol name="trash" size={16} /></Button>
          </div>
          {"from" in each && (
            <div className="planned-range">
              <NumberBox label={t("help.default")} value={each.default} low={each.from} high={each.to} onChange={(value) => value !== undefined && replaced(i, name, { ...each, default: value })} />
              <NumberBox label={t("planned.from")} value={each.from} high={each.default} onChange={(value) => value !== undefined && replaced(i, name, { ...each, from: value })} />
              <NumberBox label={t("planned.to")} value={each.to} low={each.default} onChange={(value) => value !== undefined && replaced(i, name, { ...each, to: value })} />
              <TextBox label={t("planned.unit")} value={each.unit ?? ""} onChange={(unit) => replaced(i, name, unit === "" ? (({ unit: _, ...rest }) => rest)(each) : { ...each, unit })} />
            </div>
          )}
        </div>
      ))}
      <Button className="button" onPress={fresh}><Symbol name="plus" size={16} />{t("planned.addParameter")}</Button>
    </>
  );
}
