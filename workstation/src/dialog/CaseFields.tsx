// The dialog of a CASE: which codes go which way, in words; the codes that nobody handles yet can be added.
import { Button } from "react-aria-components";
import { meaningText, useMeanings } from "../canvas/CodeRows";
import type { Icon } from "../model/operation";
import { change } from "../state/edits";
import { Symbol } from "../symbols/Symbol";
import { t } from "../words/words";
import { NextField } from "./NextField";
import { TextBox } from "./TextBox";
import { useState } from "react";

type Way = NonNullable<Icon["ways"]>[number];

export function CaseFields({ icon, operation }: { icon: Icon; operation: string }) {
  const meanings = useMeanings(icon, operation);
  const ways = icon.ways ?? [];
  const put = (next: Way[]) => change(operation, icon.id, "edit.ways", (each) => ({ ...each, ways: next }));
  const handled = new Set(ways.flatMap((way) => way.codes));
  const open = [...new Map(meanings.filter((each) => !handled.has(each.code)).map((each) => [each.code, each])).values()];
  return (
    <div className="ways">
      {ways.map((way, i) => (
        <div key={i} role="group" className="way" aria-label={t("case.way", { number: i + 1 })}>
          <div className="way-head">
            <CodesBox codes={way.codes} onChange={(codes) => put(ways.map((each, j) => (j === i ? { ...each, codes } : each)))} label={t("case.codes", { number: i + 1 })} />
            <Button className="button quiet only" aria-label={t("case.remove", { number: i + 1 })} isDisabled={ways.length <= (icon.default === undefined ? 2 : 1)} onPress={() => put(ways.filter((_, j) => j !== i))}>
              <Symbol name="trash" size={16} />
            </Button>
          </div>
          <ul className="meanings">
            {meanings.filter((each) => way.codes.includes(each.code)).map((each, j) => (
              <li key={j} data-kind={each.kind}><b>{each.code}</b> {meaningText(each)} <span className="hint">{each.from}</span></li>
            ))}
          </ul>
          <NextField operation={operation} icon={icon} port={`way:${i}`} />
        </div>
      ))}
      <div className="way"><NextField operation={operation} icon={icon} port="default" /></div>
      {open.length > 0 && ways.length < 4 && (
        <div className="field">
          <span className="label">{t("case.unhandled")}</span>
          <div className="chips">
            {open.map((each) => (
              <Button key={each.code} className="button small" onPress={() => put([...ways, { codes: [each.code] }])}><Symbol name="plus" size={14} />{each.code} {meaningText(each)}</Button>
            ))}
          </div>
        </div>
      )}
      {ways.length < 4 && <Button className="button" onPress={() => put([...ways, { codes: [Math.max(-1, ...handled) + 1] }])}><Symbol name="plus" size={16} />{t("case.add")}</Button>}
    </div>
  );
}

/** Codes as they are typed: "0, 1". */
function CodesBox({ codes, onChange, label }: { codes: number[]; onChange(codes: number[]): void; label: string }) {
  const written = codes.join(", ");
  const [text, setText] = useState<string>();
  const typed = (now: string) => {
    setText(now);
    const parts = now.split(/[\s,;]+/).filter(Boolean);
    const parsed = parts.map(Number);
    if (parts.length > 0 && parsed.every((each) => Number.isInteger(each) && Math.abs(each) <= 1_000_000)) onChange([...new Set(parsed)]);
  };
  return <TextBox label={label} value={text ?? written} onChange={typed} onBlur={() => setText(undefined)} />;
}
