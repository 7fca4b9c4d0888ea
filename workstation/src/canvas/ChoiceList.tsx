// A small list with a field over it: arrows move, Enter chooses, Escape closes.
import { useEffect, useId, useRef, useState, type KeyboardEvent, type ReactNode } from "react";
import type { Point } from "../model/operation";

export interface Choice<T> {
  key: string;
  name: string;
  aside: string;
  picture: ReactNode;
  value: T;
}

interface Props<T> {
  label: string;
  title: string;
  text: string;
  onText(text: string): void;
  screen: Point;
  choices: readonly Choice<T>[];
  nothing: string;
  onChoose(value: T): void;
  onClose(): void;
}

export function ChoiceList<T>({ label, title, text, onText, screen, choices, nothing, onChoose, onClose }: Props<T>) {
  const [marked, setMarked] = useState(0);
  const input = useRef<HTMLInputElement>(null);
  const list = useRef<HTMLUListElement>(null);
  const id = useId();
  const at = Math.min(marked, choices.length - 1);
  useEffect(() => void input.current?.focus(), []);
  useEffect(() => setMarked(0), [text]);
  useEffect(() => void list.current?.querySelector("[aria-selected=true]")?.scrollIntoView({ block: "nearest" }), [at]);
  const pressed = (event: KeyboardEvent) => {
    const move = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (move !== undefined) setMarked(Math.max(0, Math.min(choices.length - 1, at + move)));
    else if (event.key === "Enter" && choices[at]) onChoose(choices[at].value);
    else if (event.key === "Escape" || event.key === "Tab") onClose();
    else return;
    event.preventDefault();
    event.stopPropagation();
  };
  const left = Math.max(8, Math.min(screen[0], innerWidth - 336)), top = Math.max(8, Math.min(screen[1], innerHeight - 396));
  return (
    <div className="floating" style={{ left, top }} onBlur={(event) => !event.currentTarget.contains(event.relatedTarget) && onClose()}>
      <div className="floating-head">
        <div className="floating-title" id={`${id}-title`}>{title}</div>
        <input ref={input} className="input" role="combobox" aria-label={label} aria-expanded={choices.length > 0} aria-controls={choices.length > 0 ? `${id}-list` : undefined} autoComplete="off" spellCheck={false}
          {...(choices[at] ? { "aria-activedescendant": `${id}-${at}` } : {})} value={text} onChange={(event) => onText(event.target.value)} onKeyDown={pressed} />
      </div>
      {choices.length === 0 ? <p className="nothing">{nothing}</p> : (
        <ul className="listbox" role="listbox" id={`${id}-list`} aria-labelledby={`${id}-title`} ref={list}>
          {choices.map((each, i) => (
            <li key={each.key} id={`${id}-${i}`} role="option" aria-selected={i === at} className="option" data-focused={i === at || undefined}
              onPointerMove={() => setMarked(i)} onPointerDown={(event) => event.preventDefault()} onClick={() => onChoose(each.value)}>
              {each.picture}
              <span className="name">{each.name}</span>
              {each.aside !== "" && <span className="aside">{each.aside}</span>}
            </li>
          ))}
        </ul>
      )}
    </div>
  );
}
