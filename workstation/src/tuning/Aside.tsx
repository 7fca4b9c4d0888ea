// The skill tried aside, in a simulator of its own that begins as the live cell began: over one or two parameters. The
// live cell goes on meanwhile, and nothing of it is touched.
import { useEffect, useRef, useState } from "react";
import { Button } from "react-aria-components";
import type { Skill, Value } from "../../generated/protocol";
import { Choose } from "../dialog/Choose";
import { NumberBox } from "../dialog/NumberBox";
import { isSource } from "../model/operation";
import { Refused } from "../protocol/connection";
import { beginCall, call } from "../state/cell";
import { Symbol } from "../symbols/Symbol";
import { t } from "../words/words";
import { sweep, type Row } from "./rows";

interface Props {
  skill: Skill;
  /** Its path in the operation; empty: none. */
  icon: string;
  now: Readonly<Record<string, unknown>>;
  /** Rows there are already. */
  count: number;
  onRow(row: Row): void;
}

interface Swept {
  name: string;
  from: number;
  to: number;
  count: number;
}

type Before = { skill: string; parameters: Record<string, Value> }[];

/** What the cell did before the icon's last execution: the simulator does it first, so that the skill begins where it began. */
async function preludeOf(skill: string, icon: string): Promise<Before> {
  const { rows } = await call("history.steps", { skill, limit: 100 });
  const last = rows.find((each) => icon === "" || each.step.icon === icon);
  if (!last) return [];
  const { steps } = await call("history.read", { run: last.run, limit: 200 });
  return steps.filter((each) => each.step.step < last.step.step && each.step.skill).map((each) => ({ skill: each.step.skill!, parameters: each.parameters as Record<string, Value> }));
}

export function Aside({ skill, icon, now, count, onRow }: Props) {
  const numeric = skill.parameters.filter((each) => each.type === "real" || each.type === "integer");
  const first = (name: string): Swept => {
    const each = numeric.find((one) => one.name === name)!, value = Number(typeof now[name] === "number" ? now[name] : each.default);
    const low = each.low ?? value / 2, high = each.high ?? value * 2;
    return { name, from: Math.max(low, Number((value - (high - low) / 10).toPrecision(3))), to: Math.min(high, Number((value + (high - low) / 10).toPrecision(3))), count: 5 };
  };
  const [one, setOne] = useState<Swept | undefined>(() => (numeric[0] ? first(numeric.find((each) => each.name in now)?.name ?? numeric[0].name) : undefined));
  const [two, setTwo] = useState<Swept>();
  const [done, setDone] = useState<{ of: number; all: number }>(), [problem, setProblem] = useState("");
  const halt = useRef<(() => void) | undefined>(undefined);
  useEffect(() => () => halt.current?.(), []);
  if (!one) return null;
  const run = async () => {
    const points = sweep(one.from, one.to, one.count).flatMap((a) => (two ? sweep(two.from, two.to, two.count).map((b) => ({ [one.name]: a, [two.name]: b })) : [{ [one.name]: a }]));
    let wanted = true, cancel = () => {};
    halt.current = () => {
      wanted = false;
      cancel();
    };
    setProblem("");
    setDone({ of: 0, all: points.length });
    try {
      const before = await preludeOf(skill.skill, icon);
      for (let i = 0; i < points.length && wanted; ++i) {
        const parameters: Record<string, Value> = {};
        for (const each of skill.parameters) {
          const set = now[each.name];
          parameters[each.name] = (points[i] as Record<string, number>)[each.name] ?? (set === undefined || isSource(set as never) ? each.default : (set as Value));
        }
        const begun = beginCall("study.try", { skill: skill.skill, parameters, before });
        cancel = begun.cancel;
        const result = await begun.answer;
        onRow({
          id: `aside.${count + i + 1}`, aside: true, icon, begun: "", run: 0, step: 0, parameters, figures: result.figures, measured: result.measured,
          kind: result.kind, code: result.code, reason: result.reason, duration: result.duration_s,
        });
        setDone({ of: i + 1, all: points.length });
      }
    } catch (refused) {
      if (!(refused instanceof Refused && refused.why === "cancelled")) setProblem(refused instanceof Error ? refused.message : String(refused));
    }
    halt.current = undefined;
    setDone(undefined);
  };
  return (
    <section className="aside-study">
      <h3 className="section-title">{t("aside.title")}</h3>
      <p className="hint">{t("aside.hint")}</p>
      <Sweep skill={skill} names={numeric.map((each) => each.name)} swept={one} onChange={(name) => setOne(first(name))} onSet={setOne} />
      {two && <Sweep skill={skill} names={numeric.map((each) => each.name).filter((each) => each !== one.name)} swept={two} onChange={(name) => setTwo(first(name))} onSet={setTwo} />}
      <div className="aside-acts">
        {done ? <>
          <progress value={done.of} max={done.all} aria-label={t("aside.title")} /><span>{t("aside.done", done)}</span>
          <Button className="button" onPress={() => halt.current?.()}><Symbol name="stop" size={16} />{t("aside.end")}</Button>
        </> : <>
          <Button className="button primary" onPress={() => void run()}><Symbol name="run" size={16} />{t("aside.run")}</Button>
          {numeric.length > 1 && <Button className="button quiet" onPress={() => setTwo(two ? undefined : first(numeric.find((each) => each.name !== one.name)!.name))}>{t(two ? "aside.one" : "aside.two")}</Button>}
        </>}
      </div>
      {problem !== "" && <p className="refusal" role="alert"><Symbol name="error" size={14} />{problem}</p>}
    </section>
  );
}

function Sweep({ skill, names, swept, onChange, onSet }: { skill: Skill; names: readonly string[]; swept: Swept; onChange(name: string): void; onSet(swept: Swept): void }) {
  const each = skill.parameters.find((one) => one.name === swept.name)!;
  const limits = { ...(each.low === undefined ? {} : { low: each.low }), ...(each.high === undefined ? {} : { high: each.high }) };
  return (
    <div className="sweep">
      <Choose label={t("aside.parameter")} value={swept.name} onChange={onChange} options={names.map((name) => ({ id: name, name }))} />
      <NumberBox label={t("aside.from")} value={swept.from} unit={each.unit} {...limits} onChange={(from) => from !== undefined && onSet({ ...swept, from })} />
      <NumberBox label={t("aside.to")} value={swept.to} unit={each.unit} {...limits} onChange={(to) => to !== undefined && onSet({ ...swept, to })} />
      <NumberBox label={t("aside.count")} value={swept.count} whole low={1} high={50} onChange={(count) => count !== undefined && onSet({ ...swept, count })} />
    </div>
  );
}
