// A number that is written, or one that is known when the operation runs: a count, an argument, a figure of a skill.
import { Button, Menu, MenuItem, MenuTrigger, Popover } from "react-aria-components";
import { sourceText } from "../canvas/summary";
import { isSource, operationNamed, type Source } from "../model/operation";
import { useDrawing } from "../state/drawing";
import { Symbol } from "../symbols/Symbol";
import { t } from "../words/words";
import { NumberBox } from "./NumberBox";

interface Props {
  label: string;
  operation: string;
  value: number | Source | undefined;
  onChange(value: number | Source | undefined): void;
  unit?: string;
  low?: number;
  high?: number;
  fallback?: number;
  whole?: boolean;
  optional?: boolean;
  hint?: string;
  refusal?: string;
}

const figures = ["x", "y", "z", "duration", "force", "greatest-force"];

export function sourcesIn(operation: ReturnType<typeof operationNamed>): { id: string; source: Source }[] {
  if (!operation) return [];
  const list: { id: string; source: Source }[] = Object.keys(operation.arguments ?? {}).map((name) => ({ id: `argument:${name}`, source: { argument: name } }));
  for (const icon of operation.icons) {
    if (icon.kind === "skill" || icon.kind === "operation") list.push({ id: `count:${icon.id}`, source: { "count-of": icon.id } });
    if (icon.kind === "skill") for (const name of figures) list.push({ id: `figure:${icon.id}:${name}`, source: { "output-of": icon.id, name } });
  }
  return list;
}

export function AmountBox({ label, operation, value, onChange, ...rest }: Props) {
  const sources = useDrawing((state) => state.drawing);
  const choices = sourcesIn(operationNamed(sources, operation));
  if (isSource(value))
    return (
      <div className="field">
        <span className="label">{label}</span>
        <div className="source-chip">
          <Symbol name="link" size={16} /><span>{sourceText(value)}</span>
          <Button className="button quiet small" onPress={() => onChange(rest.fallback ?? rest.low ?? 0)}>{t("source.write")}</Button>
        </div>
      </div>
    );
  return (
    <div className="amount">
      <NumberBox label={label} value={value} onChange={onChange} {...rest} />
      {choices.length > 0 && (
        <MenuTrigger>
          <Button className="button quiet only" aria-label={t("source.choose", { label })}><Symbol name="link" size={16} /></Button>
          <Popover className="popover" placement="bottom end">
            <Menu className="menu" onAction={(key) => onChange(choices.find((each) => each.id === key)?.source)}>
              {choices.map((each) => <MenuItem key={each.id} id={each.id} className="menu-item">{sourceText(each.source)}</MenuItem>)}
            </Menu>
          </Popover>
        </MenuTrigger>
      )}
    </div>
  );
}
