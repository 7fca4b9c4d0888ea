// The row of tools over a chart: hold it still, how much of it is seen, save it.
import { Button, Menu, MenuTrigger, Popover } from "react-aria-components";
import { Item } from "../canvas/IconMenu";
import { Tool } from "../canvas/CanvasTools";
import { Symbol } from "../symbols/Symbol";
import { duration, t } from "../words/words";

interface Props {
  held: boolean;
  onHold(held: boolean): void;
  /** Of what is seen, s; undefined: there is no such choice. */
  span?: number;
  onSpan?(span: number): void;
  onSave(kind: "csv" | "svg"): void;
}

const shortest = 0.5, longest = 160;

export function ChartTools({ held, onHold, span, onSpan, onSave }: Props) {
  return (
    <div className="chart-tools">
      <Button className="button" data-selected={held || undefined} aria-pressed={held} onPress={() => onHold(!held)}>
        <Symbol name={held ? "resume" : "pause"} size={16} />{t(held ? "chart.goOn" : "chart.hold")}
      </Button>
      {span !== undefined && onSpan && (
        <div className="tool-group">
          <Tool symbol="minus" text={t("chart.wider")} onPress={() => onSpan(Math.min(longest, span * 2))} disabled={span >= longest} />
          <span className="chart-span">{duration(span)}</span>
          <Tool symbol="plus" text={t("chart.closer")} onPress={() => onSpan(Math.max(shortest, span / 2))} disabled={span <= shortest} />
        </div>
      )}
      <span className="grow" />
      <MenuTrigger>
        <Button className="button"><Symbol name="download" size={16} />{t("chart.save")}</Button>
        <Popover className="popover" placement="bottom end">
          <Menu className="menu" onAction={(key) => onSave(key as "csv" | "svg")}>
            <Item id="csv" symbol="list" word="chart.csv" />
            <Item id="svg" symbol="sense" word="chart.svg" />
          </Menu>
        </Popover>
      </MenuTrigger>
    </div>
  );
}
