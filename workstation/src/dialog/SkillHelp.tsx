// HELP: a skill's whole template, its requirements with their proved bounds, and its pictures.
import { useState } from "react";
import { Button } from "react-aria-components";
import type { Requirement } from "../../generated/protocol";
import { amountText } from "../canvas/summary";
import { useCell } from "../state/cell";
import { Symbol } from "../symbols/Symbol";
import { duration, number, t, type Word } from "../words/words";
import { rangeText } from "./NumberBox";

function List({ word, items }: { word: Word; items: readonly string[] }) {
  if (items.length === 0) return null;
  return <section><h3>{t(word)}</h3><ul className="bulleted">{items.map((each) => <li key={each}>{each}</li>)}</ul></section>;
}

function boundText(each: Requirement): string {
  const unit = each.unit;
  const show = (value: number) => (unit === "s" ? (value < 1 ? `${number(Math.round(value * 1e5) / 100)} ms` : duration(value)) : `${number(Math.round(value * 10) / 10)} ${unit}`);
  if (each.bound === null) return "–";
  return each.limit === null ? show(each.bound) : t("help.bound", { bound: show(each.bound), limit: show(each.limit) });
}

export default function SkillHelp({ about }: { about: string }) {
  const skill = useCell((state) => state.skills.get(about));
  if (!skill) return <p className="nothing">{t("help.unknown", { name: about })}</p>;
  return (
    <div className="help">
      {skill.descriptions.map((each) => <p key={each} className="lead">{each}</p>)}
      {!skill.able && <p className="unable"><Symbol name="warning" size={18} />{t("help.unable", { why: skill.unable })}</p>}
      <List word="help.preconditions" items={skill.preconditions} />
      <List word="help.postconditions" items={skill.postconditions} />
      <section>
        <h3>{t("help.parameters")}</h3>
        <table className="amounts">
          <thead><tr><th>{t("help.name")}</th><th>{t("help.default")}</th><th>{t("help.range")}</th><th>{t("help.meaning")}</th></tr></thead>
          <tbody>
            {skill.parameters.map((each) => (
              <tr key={each.name}>
                <th scope="row">{each.name}</th><td>{amountText(each.default, each.unit)}</td><td>{rangeText(each.low, each.high, each.unit)}</td><td>{each.description}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </section>
      <section>
        <h3>{t("help.codes")}</h3>
        <table>
          <thead><tr><th>{t("help.code")}</th><th>{t("help.kind")}</th><th>{t("help.meaning")}</th><th>{t("help.longest")}</th></tr></thead>
          <tbody>
            {skill.completions.map((each) => (
              <tr key={each.code}>
                <th scope="row">{each.code}</th><td>{t(`completion.${each.kind}`)}</td><td>{each.description}</td>
                <td>{each.longest_s === null || each.longest_s === undefined ? t("help.notProved") : <><span>≤ {duration(each.longest_s)}</span>{each.declared !== undefined && <span className="hint"> {t("help.declared", { formula: each.declared })}</span>}</>}</td>
              </tr>
            ))}
          </tbody>
        </table>
      </section>
      <List word="help.contingencies" items={skill.contingencies.map((each) => `${each.number}: ${each.description}`)} />
      {skill.requirements.length > 0 && (
        <section>
          <h3>{t("help.requirements")}</h3>
          <table>
            <thead><tr><th>{t("help.name")}</th><th>{t("help.proved")}</th><th>{t("help.verdict")}</th></tr></thead>
            <tbody>
              {skill.requirements.map((each) => (
                <tr key={each.name} title={each.text}><th scope="row">{each.name}</th><td>{boundText(each)}</td><td data-verdict={each.verdict}>{t(`verdict.${each.verdict}`)}</td></tr>
              ))}
            </tbody>
          </table>
        </section>
      )}
      <List word="help.resources" items={[...skill.model_data, ...(skill.tool === "" ? [] : [t("help.tool", { tool: skill.tool })])]} />
      <Pictures pictures={skill.pictures} />
    </div>
  );
}

function Pictures({ pictures }: { pictures: readonly { title: string; path: string }[] }) {
  const [shown, setShown] = useState<string>();
  // Whole at first; what is too small to be read is enlarged.
  const [large, setLarge] = useState(false);
  if (pictures.length === 0) return null;
  return (
    <section>
      <h3>{t("help.pictures")}</h3>
      <div className="chips">
        {pictures.map((each) => (
          <Button key={each.path} className="button small" data-selected={shown === each.path || undefined} onPress={() => setShown(shown === each.path ? undefined : each.path)}>{each.title}</Button>
        ))}
      </div>
      {shown && <Button className="button small quiet enlarge" onPress={() => setLarge(!large)}><Symbol name={large ? "minus" : "plus"} size={14} />{t(large ? "help.whole" : "help.large")}</Button>}
      {shown && <div className="picture" tabIndex={0} data-large={large || undefined}><img src={shown} alt={pictures.find((each) => each.path === shown)?.title ?? ""} /></div>}
    </section>
  );
}
