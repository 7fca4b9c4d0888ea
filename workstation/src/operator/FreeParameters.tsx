// Parameters of the loaded operation: those set free can be changed within their limits, the others are shown, locked.
import { useState } from "react";
import { Button, Checkbox } from "react-aria-components";
import { amountText } from "../canvas/summary";
import { NumberBox, rangeText } from "../dialog/NumberBox";
import { TextBox } from "../dialog/TextBox";
import { useCell } from "../state/cell";
import { Symbol } from "../symbols/Symbol";
import { t } from "../words/words";
import type { Part } from "./parts";
import { set, useValues } from "./values";

export function FreeParameters({ parts, idle }: { parts: readonly Part[]; idle: boolean }) {
  const [all, setAll] = useState(false);
  const free = parts.filter((each) => each.free), locked = parts.filter((each) => !each.free);
  return (
    <section>
      <h2>{t("operator.parameters")}</h2>
      {free.length === 0 && <p className="nothing">{t("operator.nothingFree")}</p>}
      {free.map((each) => <Icon key={each.path} part={each} idle={idle} />)}
      {locked.length > 0 && <Button className="button quiet" onPress={() => setAll(!all)}><Symbol name="lock" size={18} />{t(all ? "operator.hideLocked" : "operator.showLocked", { count: locked.length })}</Button>}
      {all && locked.map((each) => <Icon key={each.path} part={each} idle={false} />)}
    </section>
  );
}

function Icon({ part, idle }: { part: Part; idle: boolean }) {
  const values = useValues(part.path);
  const skill = useCell((cell) => cell.skills.get(part.icon.skill ?? ""));
  const sorted = [...(values ?? [])].sort((a, b) => Number(b.operator !== undefined) - Number(a.operator !== undefined));
  const limitsOf = (name: string) => part.icon.operator?.[name];
  return (
    <div className="operator-icon" data-icon={part.path}>
      <h3>{part.path.replaceAll("/", " › ")}</h3>
      <ul className="operator-fields">
        {sorted.map((each) => {
          const parameter = skill?.parameters.find((one) => one.name === each.name), limits = each.operator, unit = parameter?.unit ?? "";
          if (limitsOf(each.name) === undefined)
            return <li key={each.name} className="locked"><span><Symbol name="lock" size={16} />{each.name}</span><b>{each.value === null ? t("operator.later") : amountText(each.value, unit)}</b></li>;
          if (typeof each.value === "boolean")
            return <li key={each.name}><Checkbox className="checkbox" isSelected={each.value} isDisabled={!idle} onChange={(now) => void set(part.path, each.name, now)}><span className="box"><Symbol name="tick" size={14} /></span>{each.name}</Checkbox></li>;
          if (typeof each.value === "string") return <li key={each.name}><TextBox label={each.name} value={each.value} onChange={(now) => void set(part.path, each.name, now)} /></li>;
          const low = limits?.low ?? parameter?.low, high = limits?.high ?? parameter?.high;
          return (
            <li key={each.name} className="free">
              <NumberBox label={each.name} value={typeof each.value === "number" ? each.value : undefined} unit={unit} low={low} high={high} isDisabled={!idle} hint={rangeText(low, high, unit)}
                whole={parameter?.type === "integer"} onChange={(now) => now !== undefined && void set(part.path, each.name, now)} />
            </li>
          );
        })}
      </ul>
    </div>
  );
}
