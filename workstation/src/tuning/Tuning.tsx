// The window in which a skill is tuned: its executions as rows with their figures, compared, plotted, taken back into
// the icon; and the same skill tried aside, in a simulator of its own.
import { useEffect, useMemo, useState } from "react";
import { Button, Checkbox } from "react-aria-components";
import type { Skill } from "../../generated/protocol";
import { Choose } from "../dialog/Choose";
import { iconOf, operationNamed } from "../model/operation";
import { setParameter } from "../model/edit";
import { pathsTo, setWhilePaused } from "../state/acts";
import { call, onEvent, useCell } from "../state/cell";
import { useDrawing, say } from "../state/drawing";
import { change } from "../state/edits";
import { Symbol } from "../symbols/Symbol";
import { moment, number, t } from "../words/words";
import { Aside } from "./Aside";
import { Scatter } from "./Scatter";
import { chosen, columnsOf, differing, rowOf, sorted, type Column, type Filter, type Row } from "./rows";

/** All executions of the skill that the cell keeps, the newest first. */
function useExecutions(skill: string): readonly Row[] | undefined {
  const [rows, setRows] = useState<readonly Row[]>();
  useEffect(() => {
    let current = true, waiting = false;
    const read = () => {
      waiting = false;
      call("history.steps", { skill, limit: 300 }).then((result) => current && setRows(result.rows.map(rowOf)), () => current && setRows([]));
    };
    const stop = onEvent((event) => {
      if (event.event !== "ends" || event.skill !== skill || waiting) return;
      waiting = true;
      setTimeout(read, 150);
    });
    read();
    return () => {
      current = false;
      stop();
    };
  }, [skill]);
  return rows;
}

export const valueText = (value: unknown): string => (typeof value === "number" ? number(Number(value.toPrecision(4))) : value === undefined ? "–" : typeof value === "boolean" ? t(value ? "tuning.yes" : "tuning.no") : String(value));

export default function Tuning({ about }: { about: string }) {
  const [operation, id] = [about.slice(0, about.lastIndexOf("/")), about.slice(about.lastIndexOf("/") + 1)];
  const drawing = useDrawing((state) => state.drawing);
  const owner = operationNamed(drawing, operation), icon = owner && iconOf(owner, id);
  const name = icon?.skill ?? id;
  const skill = useCell((state) => state.skills.get(name));
  const executed = useExecutions(name);
  const [aside, setAside] = useState<readonly Row[]>([]);
  const [filter, setFilter] = useState<Filter>({ icon: "", code: undefined, where: "all" });
  const [order, setOrder] = useState<{ column: string; down: boolean }>({ column: "", down: true });
  const [picked, setPicked] = useState<ReadonlySet<string>>(new Set());
  const [onlyPicked, setOnlyPicked] = useState(false), [all, setAll] = useState(false);
  const rows = useMemo(() => [...aside].reverse().concat(executed ?? []), [aside, executed]);
  const columns = useMemo(() => columnsOf(skill, rows), [skill, rows]);
  if (!executed) return <p className="nothing loading">{t("loading")}</p>;
  const matching = chosen(rows, filter).filter((row) => !onlyPicked || picked.has(row.id));
  const varied = new Set(differing(columns, matching));
  const usual = new Set(["figure:duration", "figure:greatest-force", "figure:rms-force", "figure:mean-force"]);
  const shown = all ? columns : columns.filter((each) => (each.group === "figure" ? usual.has(each.id) : each.group === "parameter" ? varied.has(each) : true));
  const lines = sorted(matching, columns.find((each) => each.id === order.column), order.down);
  const icons = [...new Set(rows.map((row) => row.icon))].filter(Boolean), codes = [...new Set(rows.map((row) => row.code))].sort((a, b) => a - b);
  const toggle = (row: Row) => {
    const next = new Set(picked);
    if (!next.delete(row.id)) next.add(row.id);
    if (next.size < 2) setOnlyPicked(false);
    setPicked(next);
  };
  const take = icon && ((row: Row) => {
    const before = useDrawing.getState().drawing;
    change(operation, id, "edit.taken", (each) => Object.entries(row.parameters).reduce((now, [parameter, value]) => {
      const usually = skill?.parameters.find((one) => one.name === parameter)?.default;
      return setParameter(now, parameter, value === usually ? undefined : (value as string | number | boolean));
    }, each));
    for (const [parameter, value] of Object.entries(row.parameters)) void setWhilePaused(operation, id, parameter, value as string | number | boolean, before);
    say(t("tuning.taken", { icon: id }));
  });
  const here = icon ? pathsTo(drawing, operation).map((prefix) => prefix + id) : [];
  return (
    <div className="tuning">
      <div className="tuning-filters">
        <Choose label={t("tuning.icon")} value={filter.icon || "*"} onChange={(value) => setFilter({ ...filter, icon: value === "*" ? "" : value })} options={[{ id: "*", name: t("tuning.all") }, ...icons.map((each) => ({ id: each, name: each, ...(here.includes(each) ? { aside: t("tuning.this") } : {}) }))]} />
        <Choose label={t("tuning.code")} value={filter.code === undefined ? "*" : String(filter.code)} onChange={(value) => setFilter({ ...filter, code: value === "*" ? undefined : Number(value) })} options={[{ id: "*", name: t("tuning.all") }, ...codes.map((each) => ({ id: String(each), name: String(each) }))]} />
        <Choose label={t("tuning.where")} value={filter.where} onChange={(value) => setFilter({ ...filter, where: value as Filter["where"] })} options={(["all", "cell", "aside"] as const).map((each) => ({ id: each, name: t(`tuning.${each}`) }))} />
        <Checkbox className="checkbox" isSelected={onlyPicked} isDisabled={picked.size < 2} onChange={setOnlyPicked}><span className="box"><Symbol name="tick" size={14} /></span>{t("tuning.compare", { count: picked.size })}</Checkbox>
        <Checkbox className="checkbox" isSelected={all} onChange={setAll}><span className="box"><Symbol name="tick" size={14} /></span>{t("tuning.columns")}</Checkbox>
      </div>
      {rows.length === 0 ? <p className="nothing">{t("tuning.none", { skill: name })}</p> : (
        <div className="tuning-table" tabIndex={0} role="region" aria-label={t("tuning.table", { skill: name })}>
          <table>
            <thead>
              <tr>
                <th><span className="hidden">{t("tuning.choose")}</span></th><th>{t("tuning.when")}</th><th>{t("tuning.code")}</th>
                {shown.map((column) => <Head key={column.id} column={column} order={order} onOrder={setOrder} bound={bound(skill, column)} />)}
                <th><span className="hidden">{t("tuning.take")}</span></th>
              </tr>
            </thead>
            <tbody>
              {lines.map((row) => (
                <tr key={row.id} data-row={row.id} data-picked={picked.has(row.id) || undefined}>
                  <td><Checkbox className="checkbox" aria-label={t("tuning.pick", { row: row.id })} isSelected={picked.has(row.id)} onChange={() => toggle(row)}><span className="box"><Symbol name="tick" size={14} /></span></Checkbox></td>
                  <td title={row.icon}>{row.aside ? <span className="aside-mark">{t("tuning.aside")}</span> : moment(row.begun)}<small>{row.aside ? row.id : `${row.icon || row.run}`}</small></td>
                  <td title={row.reason} data-kind={row.kind}><span className="code">{row.kind !== "normal" && <Symbol name={row.kind === "stopped" ? "stop" : "warning"} size={14} />}{row.code}</span></td>
                  {shown.map((column) => <td key={column.id} className="figure" data-column={column.id} data-broken={broken(skill, column, row) || undefined}>{valueText(column.of(row))}</td>)}
                  <td>{take && <Button className="button small" aria-label={t("tuning.takeRow", { row: row.id })} onPress={() => take(row)}>{t("tuning.take")}</Button>}</td>
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      )}
      {matching.length > 1 && <Scatter rows={matching} columns={columns} varied={varied} picked={picked} onPick={toggle} limit={(column) => bound(skill, column)?.limit} />}
      {skill && <Aside skill={skill} icon={here[0] ?? ""} now={icon?.parameters ?? {}} count={aside.length} onRow={(row) => setAside((before) => [...before, row])} />}
    </div>
  );
}

interface Bound {
  bound: number | undefined;
  limit: number | undefined;
}

function bound(skill: Skill | undefined, column: Column): Bound | undefined {
  const found = column.group === "requirement" ? skill?.requirements.find((each) => each.name === column.name) : undefined;
  if (!found) return undefined;
  const factor = found.unit === "s" ? 1000 : 1, of = (value: number | null) => (value === null ? undefined : value * factor);
  return { bound: of(found.bound), limit: of(found.limit) };
}

function broken(skill: Skill | undefined, column: Column, row: Row): boolean {
  const limit = bound(skill, column)?.limit, value = column.of(row);
  return limit !== undefined && typeof value === "number" && value > limit;
}

function Head({ column, order, onOrder, bound: known }: { column: Column; order: { column: string; down: boolean }; onOrder(order: { column: string; down: boolean }): void; bound: Bound | undefined }) {
  const by = order.column === column.id;
  return (
    <th className="figure" data-group={column.group} aria-sort={by ? (order.down ? "descending" : "ascending") : "none"}>
      <Button className="sort" onPress={() => onOrder({ column: column.id, down: by ? !order.down : true })}>
        <span>{column.name}{by && <Symbol name={order.down ? "down" : "up"} size={14} />}</span>
        <small>{column.unit}{known?.bound !== undefined && ` · ${t("tuning.proved", { bound: number(Number(known.bound.toPrecision(4))) })}`}</small>
      </Button>
    </th>
  );
}
