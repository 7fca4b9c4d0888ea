// Whether an operator may set a parameter, and within which limits. It stands in the operation's file, and the server
// holds operators to it.
import { Button } from "react-aria-components";
import type { Parameter } from "../../generated/protocol";
import { setField } from "../model/edit";
import type { Icon } from "../model/operation";
import { change } from "../state/edits";
import { Symbol } from "../symbols/Symbol";
import { t } from "../words/words";
import { NumberBox } from "./NumberBox";

export function OperatorField({ icon, operation, parameter }: { icon: Icon; operation: string; parameter: Parameter }) {
  const free = icon.operator?.[parameter.name];
  const put = (limits: { from?: number; to?: number } | undefined) =>
    change(operation, icon.id, "edit.operator", (each) => {
      const { [parameter.name]: _, ...others } = each.operator ?? {};
      const all = limits === undefined ? others : { ...others, [parameter.name]: limits };
      return setField(each, "operator", Object.keys(all).length > 0 ? (all as NonNullable<Icon["operator"]>) : undefined);
    }, `${operation}/${icon.id}/operator/${parameter.name}`);
  const numeric = parameter.type === "real" || parameter.type === "integer";
  const range = { ...(parameter.low === undefined ? {} : { low: parameter.low }), ...(parameter.high === undefined ? {} : { high: parameter.high }) };
  const limit = (end: "from" | "to", value: number | undefined) => {
    const { [end]: _, ...other } = (free ?? {}) as { from?: number; to?: number };
    put(value === undefined ? other : { ...other, [end]: value });
  };
  const { from, to } = (free ?? {}) as { from?: number; to?: number };
  return (
    <div className="operator-field" data-free={free !== undefined || undefined}>
      <Button className="button quiet small" aria-pressed={free !== undefined} onPress={() => put(free ? undefined : {})}>
        <Symbol name={free ? "person" : "lock"} size={14} /><span className="operator-word"><span className="hidden">{parameter.name}: </span>{t(free ? "operator.isFree" : "operator.isLocked")}</span>
      </Button>
      {free && numeric && (
        <div className="operator-limits">
          <NumberBox label={t("operator.from", { name: parameter.name })} value={from} optional unit={parameter.unit} {...range} onChange={(value) => limit("from", value)} />
          <NumberBox label={t("operator.to", { name: parameter.name })} value={to} optional unit={parameter.unit} {...range} onChange={(value) => limit("to", value)} />
        </div>
      )}
    </div>
  );
}
