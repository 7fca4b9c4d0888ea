// All breakpoints: switched on and off, with the code at which they halt, removed, gone to.
import { Button, Checkbox } from "react-aria-components";
import type { Breakpoint } from "../../generated/protocol";
import { focusIcon } from "../canvas/keys";
import { NumberBox } from "../dialog/NumberBox";
import { ask } from "../state/acts";
import { useCell } from "../state/cell";
import { enter } from "../state/drawing";
import { Symbol } from "../symbols/Symbol";
import { t } from "../words/words";

function go(path: string): void {
  const parts = path.split("/");
  enter(parts.slice(0, -1), [parts.at(-1)!]);
  focusIcon(parts.at(-1));
}

export default function Breakpoints() {
  const breakpoints = useCell((cell) => cell.present?.snapshot.breakpoints ?? []);
  if (breakpoints.length === 0) return <p className="nothing">{t("breaks.none")}</p>;
  return (
    <div className="form">
      <ul className="breaks">{breakpoints.map((each) => <Row key={each.breakpoint} breakpoint={each} />)}</ul>
      <Button className="button" onPress={() => void ask("operation.clear")}><Symbol name="trash" size={16} />{t("breaks.clear")}</Button>
    </div>
  );
}

function Row({ breakpoint: each }: { breakpoint: Breakpoint }) {
  const put = (changed: Partial<Breakpoint>) => {
    const { hits: _, code, ...rest } = { ...each, ...changed };
    void ask("operation.break", { ...rest, ...(code === undefined ? {} : { code }) });
  };
  return (
    <li className="break">
      <Checkbox className="checkbox" isSelected={each.enabled} onChange={(enabled) => put({ enabled })} aria-label={t("breaks.on", { icon: each.icon })}>
        <span className="box"><Symbol name="tick" size={14} /></span>
      </Checkbox>
      <Button className="button quiet break-name" onPress={() => go(each.icon)}>{each.icon}</Button>
      <NumberBox label={t("breaks.code")} value={each.code} optional whole onChange={(code) => {
        const { code: _, hits: __, ...rest } = each;
        void ask("operation.break", code === undefined ? rest : { ...rest, code });
      }} />
      <span className="hint">{t("breaks.hits", { count: each.hits })}</span>
      <Button className="button quiet only" aria-label={t("breaks.remove", { icon: each.icon })} onPress={() => void ask("operation.unbreak", { breakpoint: each.breakpoint })}><Symbol name="trash" size={16} /></Button>
    </li>
  );
}
