// A field for a number with its unit and range. What lies beyond the range is refused while it is typed, and the
// value stays what it was.
import { NumberParser } from "@internationalized/number";
import { useEffect, useId, useMemo, useState, type KeyboardEvent } from "react";
import { Button, Group, Input, Label, TextField } from "react-aria-components";
import { Symbol } from "../symbols/Symbol";
import { number, t, useLanguage } from "../words/words";

interface Props {
  label: string;
  /** Undefined: nothing is set, so the default counts. */
  value: number | undefined;
  /** Undefined: back to the default. */
  onChange(value: number | undefined): void;
  fallback?: number | undefined;
  unit?: string;
  low?: number | undefined;
  high?: number | undefined;
  whole?: boolean;
  /** It may be left empty. */
  optional?: boolean;
  hint?: string;
  refusal?: string;
  isDisabled?: boolean;
}

/** 1, 2 or 5 by a power of ten: about a fiftieth of the range. */
function stepOf(low: number | undefined, high: number | undefined, whole: boolean): number {
  if (low === undefined || high === undefined || high <= low) return 1;
  const rough = (high - low) / 50, power = 10 ** Math.floor(Math.log10(rough));
  const step = [1, 2, 5, 10].map((each) => each * power).find((each) => each >= rough) ?? power;
  return whole ? Math.max(1, Math.round(step)) : step;
}

export function rangeText(low: number | undefined, high: number | undefined, unit: string): string {
  const tail = unit === "" ? "" : ` ${unit}`;
  if (low !== undefined && high !== undefined) return t("range.both", { low: number(low), high: number(high) + tail });
  if (low !== undefined) return t("range.low", { low: number(low) + tail });
  return high === undefined ? "" : t("range.high", { high: number(high) + tail });
}

export function NumberBox({ label, value, onChange, fallback, unit = "", low, high, whole = false, optional = false, hint, refusal, isDisabled = false }: Props) {
  const language = useLanguage();
  const parser = useMemo(() => new NumberParser(language, { style: "decimal" }), [language]);
  const shown = value ?? fallback;
  const written = shown === undefined ? "" : number(shown);
  const [text, setText] = useState(written);
  const [refused, setRefused] = useState("");
  const id = useId();
  useEffect(() => {
    setText(written);
    setRefused("");
  }, [written]);

  const why = (parsed: number): string => {
    if (Number.isNaN(parsed)) return t("range.noNumber");
    if (whole && !Number.isInteger(parsed)) return t("range.whole");
    return (low !== undefined && parsed < low) || (high !== undefined && parsed > high) ? t("range.refused", { range: rangeText(low, high, unit) }) : "";
  };
  const typed = (now: string) => {
    setText(now);
    if (now.trim() === "" && (optional || fallback !== undefined)) return setRefused(""), onChange(undefined);
    const parsed = parser.parse(now.trim());
    const reason = why(parsed);
    setRefused(reason);
    if (reason === "" && parsed !== shown) onChange(parsed);
  };
  const step = stepOf(low, high, whole);
  const by = (count: number) => {
    const from = shown ?? low ?? 0;
    const next = Math.min(high ?? Infinity, Math.max(low ?? -Infinity, Number((Math.round(from / step + count) * step).toPrecision(12))));
    if (next !== shown) onChange(next);
  };
  const pressed = (event: KeyboardEvent) => {
    const count = { ArrowUp: 1, ArrowDown: -1, PageUp: 10, PageDown: -10 }[event.key];
    if (count === undefined) return;
    event.preventDefault();
    by(count);
  };
  const problem = refused || refusal || "";
  return (
    <TextField className="field" value={text} onChange={typed} isInvalid={problem !== ""} isDisabled={isDisabled} aria-describedby={`${id}-hint`}
      onBlur={() => (refused !== "" ? (setText(written), setRefused("")) : setText(written))}>
      <Label>{label}</Label>
      <Group className="number-group" isInvalid={problem !== ""} isDisabled={isDisabled}>
        <Input className="input" inputMode="decimal" autoComplete="off" onKeyDown={pressed} />
        {unit !== "" && <span className="unit">{unit}</span>}
        <Button excludeFromTabOrder aria-label={t("number.less", { label })} onPress={() => by(-1)} isDisabled={isDisabled || (shown !== undefined && low !== undefined && shown <= low)}><Symbol name="minus" size={14} /></Button>
        <Button excludeFromTabOrder aria-label={t("number.more", { label })} onPress={() => by(1)} isDisabled={isDisabled || (shown !== undefined && high !== undefined && shown >= high)}><Symbol name="plus" size={14} /></Button>
      </Group>
      <span id={`${id}-hint`} className={problem === "" ? "hint" : "refusal"} role={problem === "" ? undefined : "alert"}>
        {problem === "" ? hint : <><Symbol name="error" size={14} />{problem}</>}
      </span>
    </TextField>
  );
}
