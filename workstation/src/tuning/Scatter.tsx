// Rows as points over a parameter: which figure follows which parameter. A point chooses its row.
import { useState } from "react";
import { Choose } from "../dialog/Choose";
import { ticks } from "../live/export";
import { number, t } from "../words/words";
import type { Column, Row } from "./rows";

const width = 640, height = 240, left = 60, right = 14, top = 12, bottom = 40;

interface Props {
  rows: readonly Row[];
  columns: readonly Column[];
  varied: ReadonlySet<Column>;
  picked: ReadonlySet<string>;
  onPick(row: Row): void;
  limit(column: Column): number | undefined;
}

const air = (values: readonly number[]): [number, number] => {
  const low = Math.min(...values), high = Math.max(...values), more = (high - low) * 0.08 || Math.max(Math.abs(high) * 0.1, 0.5);
  return [low - more, high + more];
};

export function Scatter({ rows, columns, varied, picked, onPick, limit }: Props) {
  const numeric = columns.filter((each) => rows.some((row) => typeof each.of(row) === "number"));
  const [acrossName, setAcross] = useState(""), [upName, setUp] = useState("");
  const across = numeric.find((each) => each.id === acrossName) ?? numeric.find((each) => each.group === "parameter" && varied.has(each)) ?? numeric[0];
  const up = numeric.find((each) => each.id === upName) ?? numeric.find((each) => each.id === "figure:greatest-force") ?? numeric.find((each) => each.id === "figure:duration") ?? numeric[0];
  if (!across || !up) return null;
  const points = rows.flatMap((row) => {
    const x = across.of(row), y = up.of(row);
    return typeof x === "number" && typeof y === "number" ? [{ row, x, y }] : [];
  });
  const line = limit(up);
  const xs = air(points.map((each) => each.x)), ys = air([...points.map((each) => each.y), ...(line === undefined ? [] : [line])]);
  const px = (value: number) => left + ((value - xs[0]) / (xs[1] - xs[0])) * (width - left - right), py = (value: number) => height - bottom - ((value - ys[0]) / (ys[1] - ys[0])) * (height - top - bottom);
  const named = (column: Column) => (column.unit === "" ? column.name : `${column.name}, ${column.unit}`);
  const options = numeric.map((each) => ({ id: each.id, name: each.name, aside: each.unit }));
  return (
    <div className="scatter">
      <div className="scatter-axes">
        <Choose label={t("tuning.up")} value={up.id} onChange={setUp} options={options} />
        <Choose label={t("tuning.across")} value={across.id} onChange={setAcross} options={options} />
      </div>
      <svg viewBox={`0 0 ${width} ${height}`} role="group" aria-label={t("tuning.plot", { up: up.name, across: across.name, count: points.length })}>
        {ticks(ys[0], ys[1]).map((each) => <g key={each}><path className="grid" d={`M${left} ${py(each)}H${width - right}`} /><text x={left - 8} y={py(each)} textAnchor="end" dominantBaseline="middle">{number(each)}</text></g>)}
        {ticks(xs[0], xs[1]).map((each) => <g key={each}><path className="grid" d={`M${px(each)} ${top}V${height - bottom}`} /><text x={px(each)} y={height - bottom + 16} textAnchor="middle">{number(each)}</text></g>)}
        <text x={width - right} y={height - 6} textAnchor="end" className="axis">{named(across)}</text>
        <text x={left} y={height - 6} className="axis">{named(up)}</text>
        {line !== undefined && <path className="limit" d={`M${left} ${py(line)}H${width - right}`} />}
        {points.map(({ row, x, y }) => (
          <g key={row.id} className="point" data-aside={row.aside || undefined} data-picked={picked.has(row.id) || undefined} data-kind={row.kind} transform={`translate(${px(x).toFixed(1)} ${py(y).toFixed(1)})`} onClick={() => onPick(row)}>
            <circle className="reach" r="12" />
            <path d={row.kind !== "normal" ? "M-5 -5L5 5M5 -5L-5 5" : row.aside ? "M0 -6L6 0L0 6L-6 0Z" : "M-5 0a5 5 0 1 0 10 0a5 5 0 1 0 -10 0Z"} />
            <title>{`${row.id}: ${number(x)} → ${number(Number(y.toPrecision(5)))}`}</title>
          </g>
        ))}
      </svg>
    </div>
  );
}
