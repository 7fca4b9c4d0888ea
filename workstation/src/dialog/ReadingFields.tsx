// What a test and a wait read, and what it is compared with: one sensor or several conditions.
import { Button } from "react-aria-components";
import { sourceText } from "../canvas/summary";
import { setField } from "../model/edit";
import { isSource, operationNamed, type Condition, type Icon, type Source } from "../model/operation";
import { useCell } from "../state/cell";
import { useDrawing } from "../state/drawing";
import { change } from "../state/edits";
import { Symbol } from "../symbols/Symbol";
import { number, t } from "../words/words";
import { AmountBox, sourcesIn } from "./AmountBox";
import { Choose } from "./Choose";
import { NumberBox } from "./NumberBox";

type Reading = Partial<Condition>;

/** A sensor, or a value that is known when it runs. */
function Subject({ operation, reading, onChange }: { operation: string; reading: Reading; onChange(next: Reading): void }) {
  const sensors = useCell((state) => state.sensors);
  const drawing = useDrawing((state) => state.drawing);
  const values = sourcesIn(operationNamed(drawing, operation));
  const of = (source: Source | undefined) => values.find((each) => JSON.stringify(each.source) === JSON.stringify(source))?.id ?? "";
  const options = [
    ...sensors.map((each) => ({ id: `sensor:${each.sensor}`, name: each.sensor, aside: each.value === undefined || each.value === null ? each.unit : `${number(each.value)} ${each.unit}` })),
    ...values.map((each) => ({ id: each.id, name: sourceText(each.source) })),
  ];
  const described = sensors.find((each) => each.sensor === reading.sensor)?.description;
  const choose = (id: string) => {
    const { sensor: _, value: __, ...rest } = reading;
    const source = values.find((each) => each.id === id)?.source;
    onChange(source ? { value: source, ...rest } : { sensor: id.slice("sensor:".length), ...rest });
  };
  return (
    <Choose label={t("reading.subject")} value={reading.sensor ? `sensor:${reading.sensor}` : isSource(reading.value) ? of(reading.value) : ""}
      onChange={choose} options={options} {...(described ? { hint: described } : {})} />
  );
}

function without<T extends object>(value: T, name: keyof T): T {
  const { [name]: _, ...rest } = value;
  return rest as T;
}

function Limits({ operation, reading, onChange }: { operation: string; reading: Reading; onChange(next: Reading): void }) {
  const sensor = useCell((state) => state.sensors.find((each) => each.sensor === reading.sensor));
  const put = (name: keyof Condition, value: unknown) => onChange(value === undefined ? without(reading, name) : { ...reading, [name]: value });
  const unit = sensor?.unit ?? "";
  return (
    <>
      <AmountBox label={t("reading.atLeast")} operation={operation} value={reading["at-least"]} onChange={(value) => put("at-least", value)} unit={unit} optional />
      <AmountBox label={t("reading.atMost")} operation={operation} value={reading["at-most"]} onChange={(value) => put("at-most", value)} unit={unit} optional />
      <More reading={reading} put={put} unit={unit} />
    </>
  );
}

function More({ reading, put, unit }: { reading: Reading; put(name: keyof Condition, value: unknown): void; unit: string }) {
  return (
    <>
      <NumberBox label={t("reading.mean")} value={reading["mean-of"]} onChange={(value) => put("mean-of", value === 1 ? undefined : value)} fallback={1} low={1} high={1000} whole hint={t("reading.meanHint")} />
      <NumberBox label={t("reading.hysteresis")} value={reading.hysteresis} onChange={(value) => put("hysteresis", value === 0 ? undefined : value)} fallback={0} low={0} unit={unit} hint={t("reading.hysteresisHint")} />
    </>
  );
}

const single = ["sensor", "value", "at-least", "at-most", "mean-of", "hysteresis", "limits"] as const;

export function ReadingFields({ icon, operation }: { icon: Icon; operation: string }) {
  const several = icon.all ?? icon.any;
  const name = icon.all ? "all" : "any";
  const put = (how: (each: Icon) => Icon, run?: string) => change(operation, icon.id, "edit.reading", how, run && `${operation}/${icon.id}/${run}`);
  const rewrite = (reading: Reading & { limits?: Icon["limits"] }) => put((each) => {
    const { ...rest } = each;
    for (const field of single) delete rest[field];
    return { ...rest, ...reading } as Icon;
  }, "reading");
  const reading = Object.fromEntries(single.filter((field) => icon[field] !== undefined).map((field) => [field, icon[field]])) as Reading & { limits?: Icon["limits"] };
  if (!several)
    return (
      <>
        <Subject operation={operation} reading={reading} onChange={rewrite} />
        {icon.kind === "test" && reading.limits ? <TestLimits {...{ icon, operation, reading, rewrite }} /> : <Limits operation={operation} reading={reading} onChange={rewrite} />}
        <Button className="button" onPress={() => put((each) => {
          const { limits: _, ...first } = reading;
          const condition = { sensor: "", ...first, ...(first["at-least"] === undefined && first["at-most"] === undefined ? { "at-least": 0 } : {}) } as Condition;
          const { ...rest } = each;
          for (const field of single) delete rest[field];
          return setField(rest as Icon, "all", [condition, condition]);
        })}><Symbol name="plus" size={16} />{t("reading.several")}</Button>
      </>
    );
  const list = (next: Condition[]) => put((each) => ({ ...each, [name]: next }), "reading");
  return (
    <>
      <Choose label={t("reading.combine")} value={name} options={[{ id: "all", name: t("reading.all") }, { id: "any", name: t("reading.any") }]}
        onChange={(to) => put((each) => { const { all, any, ...rest } = each; return { ...rest, [to]: all ?? any } as Icon; })} />
      {several.map((each, i) => (
        <div key={i} role="group" className="way" aria-label={t("reading.condition", { number: i + 1 })}>
          <div className="way-head">
            <Subject operation={operation} reading={each} onChange={(next) => list(several.map((one, j) => (j === i ? (next as Condition) : one)))} />
            <Button className="button quiet only" aria-label={t("reading.remove", { number: i + 1 })} isDisabled={several.length <= 2} onPress={() => list(several.filter((_, j) => j !== i))}><Symbol name="trash" size={16} /></Button>
          </div>
          <Limits operation={operation} reading={each} onChange={(next) => list(several.map((one, j) => (j === i ? (next as Condition) : one)))} />
        </div>
      ))}
      {several.length < 8 && <Button className="button" onPress={() => list([...several, several.at(-1)!])}><Symbol name="plus" size={16} />{t("reading.add")}</Button>}
    </>
  );
}

function TestLimits({ icon, operation, reading, rewrite }: { icon: Icon; operation: string; reading: Reading & { limits?: Icon["limits"] }; rewrite(next: Reading & { limits?: Icon["limits"] }): void }) {
  const unit = useCell((state) => state.sensors.find((each) => each.sensor === reading.sensor)?.unit ?? "");
  const limits = icon.limits ?? [];
  const put = (next: typeof limits) => rewrite({ ...reading, limits: next });
  const last = limits.at(-1);
  return (
    <>
      {limits.map((each, i) => (
        <div key={i} className="way-head">
          <AmountBox label={t("reading.limit", { number: i + 1 })} operation={operation} value={each} unit={unit} onChange={(value) => value !== undefined && put(limits.map((one, j) => (j === i ? value : one)))} />
          <Button className="button quiet only" aria-label={t("reading.removeLimit", { number: i + 1 })} isDisabled={limits.length <= 1} onPress={() => put(limits.filter((_, j) => j !== i))}><Symbol name="trash" size={16} /></Button>
        </div>
      ))}
      {limits.length < 3 && <Button className="button" onPress={() => put([...limits, typeof last === "number" ? last + 10 : 0])}><Symbol name="plus" size={16} />{t("reading.addLimit")}</Button>}
      <More reading={reading} unit={unit} put={(name, value) => rewrite(value === undefined ? without(reading, name) : { ...reading, [name]: value })} />
    </>
  );
}
