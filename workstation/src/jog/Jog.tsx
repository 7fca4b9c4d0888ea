// The window by which a person moves the arm by hand: frame, speed, step, and a pair of buttons for each axis. It says where
// the arm is, and how soon it stops when nobody is there any more.
import { useEffect, useRef, useState } from "react";
import { Button } from "react-aria-components";
import type { Skill } from "../../generated/protocol";
import { Choose } from "../dialog/Choose";
import { useChannels } from "../live/live";
import { shownUnit, useRequirements, watchRequirements } from "../live/requirements";
import { useCell } from "../state/cell";
import { openWindow } from "../state/windows";
import { Symbol } from "../symbols/Symbol";
import { useHere } from "../teaching/here";
import { number, t } from "../words/words";
import { HoldButton } from "./HoldButton";
import { useGamepad } from "./gamepad";
import { hold, letAllGo, letGo, set, useJog, type Axes, type Frame } from "./hold";
import "./jog.css";

const skill = "jog", stopping = "silence";
const frames: readonly Frame[] = ["tool", "world", "joints"];
const speeds = [2, 10, 30, 60, 100]; // per cent of the greatest
const steps = [0, 0.1, 1, 5, 10]; // mm, or degrees
/** A pair for each axis, plus and minus, in the place of the keys and not by their letters. */
const keys: readonly [string, string][] = [["KeyQ", "KeyA"], ["KeyW", "KeyS"], ["KeyE", "KeyD"], ["KeyR", "KeyF"], ["KeyT", "KeyG"], ["KeyY", "KeyH"]];
const letter = (code: string) => code.slice(3);
const shortest = (value: number) => number(value, Number.isInteger(value) ? 0 : 1);

const along = (axis: number, sign: number): Axes => [0, 1, 2, 3, 4, 5].map((each) => (each === axis ? sign : 0)) as Axes;
const greatest = (known: Skill, name: string) => known.parameters.find((each) => each.name === name)?.high ?? 0;

/** The axes of a frame as the robot's description names them. */
function useAxes(frame: Frame): { name: string; unit: string }[] {
  const channels = useChannels((state) => state.channels);
  const fieldsOf = (name: string) => channels?.find((each) => each.channel === name)?.fields ?? [];
  if (frame === "joints") return fieldsOf("joints").map(({ name, unit }) => ({ name, unit }));
  const places = fieldsOf("pose").slice(0, 3).map(({ name, unit }) => ({ name, unit }));
  return [...places, ...places.map(({ name }) => ({ name: `↻ ${name}`, unit: "deg" }))];
}

export default function Jog() {
  const known = useCell((cell) => cell.skills.get(skill));
  const offered = useCell((cell) => cell.present?.snapshot.offers.includes("jog") ?? false);
  if (!offered || !known?.able) return <p className="nothing">{t("jog.absent")}</p>;
  return <Panel known={known} />;
}

function Panel({ known }: { known: Skill }) {
  const [frame, setFrame] = useState<Frame>("tool"), [percent, setPercent] = useState(30), [step, setStep] = useState(0);
  const { held, moves, ended } = useJog();
  const ready = useCell((cell) => cell.link === "ready" && (cell.present?.snapshot.activity === "idle" || useJog.getState().moves));
  const role = useCell((cell) => cell.present?.snapshot.role);
  const may = role === "programmer", usable = may && (ready || moves);
  const axes = useAxes(frame);
  const gamepad = useGamepad(usable);
  const part = percent / 100;
  const speed = greatest(known, "speed") * part, turn = greatest(known, "turn") * part;
  useEffect(() => set({ frame, speed, turn, way: step, angle: step }), [frame, speed, turn, step]);
  useEffect(() => letAllGo, []);
  const box = useRef<HTMLDivElement>(null);
  useKeys(box, usable);
  return (
    <div className="jog" ref={box}>
      <div className="jog-choices">
        <Choose label={t("jog.frame")} value={frame} onChange={(now) => (letAllGo(), setFrame(now as Frame))} options={frames.map((each) => ({ id: each, name: t(`jog.frame.${each}`) }))} />
        <Choose label={t("jog.speed")} value={String(percent)} onChange={(now) => setPercent(Number(now))} options={speeds.map((each) => ({ id: String(each), name: `${each} %`, aside: frame === "joints" ? `${number((greatest(known, "turn") * each) / 100, 1)} °/s` : `${number((greatest(known, "speed") * each) / 100, 0)} mm/s` }))} />
        <Choose label={t("jog.step")} value={String(step)} onChange={(now) => setStep(Number(now))} options={steps.map((each) => ({ id: String(each), name: each === 0 ? t("jog.continuous") : frame === "joints" ? `${shortest(each)}°` : t("jog.stepOf", { way: shortest(each) }) }))} />
      </div>
      {!may && <p className="hint" role="note"><Symbol name="lock" size={16} /> {t("jog.role")}</p>}
      <div className="jog-axes" role="group" aria-label={t(`jog.frame.${frame}`)}>
        {axes.map(({ name }, i) => (
          <div key={`${frame} ${name}`} className="jog-axis" data-axis={i}>
            <HoldButton id={`button ${i} minus`} label={t("jog.minus", { axis: spoken(name) })} keyHint={letter(keys[i]![1])} sign="−" axes={along(i, -1)} disabled={!usable} />
            <b data-moves={(held?.[i] ?? 0) !== 0 || undefined}>{name}</b>
            <HoldButton id={`button ${i} plus`} label={t("jog.plus", { axis: spoken(name) })} keyHint={letter(keys[i]![0])} sign="+" axes={along(i, 1)} disabled={!usable} />
          </div>
        ))}
      </div>
      <p className="jog-state" role="status" data-moves={moves || undefined} data-bad={(ended && ended.code !== 0) || undefined}>
        {moves ? t(held ? "jog.moves" : "jog.stops") : ended && ended.code !== 0 ? said(known, ended) : t("jog.rests")}
      </p>
      <Place />
      <Bound />
      <p className="hint">{t("jog.hint")}{gamepad ? ` ${t("jog.gamepad")}` : ""}</p>
      <div className="chips"><Button className="button" onPress={() => openWindow("locations")}><Symbol name="target" size={16} />{t("jog.teach")}</Button></div>
    </div>
  );
}

const spoken = (name: string) => (name.startsWith("↻ ") ? t("steps.about", { axis: name.slice(2) }) : name);

function said(known: Skill, { kind, code, reason }: { kind: string; code: number; reason: string }): string {
  if (kind === "error" || reason !== "") return reason;
  return known.completions.find((each) => each.code === code)?.description ?? String(code);
}

/** Keys hold while they are down and this window has the focus; what a field takes is not a key to it. */
function useKeys(box: React.RefObject<HTMLDivElement | null>, usable: boolean): void {
  useEffect(() => {
    const region = box.current?.closest<HTMLElement>(".window") ?? box.current;
    if (!region || !usable) return;
    const find = (code: string): [string, Axes] | undefined => {
      for (const [i, [plus, minus]] of keys.entries()) {
        if (code === plus) return [`key ${code}`, along(i, 1)];
        if (code === minus) return [`key ${code}`, along(i, -1)];
      }
      return undefined;
    };
    const down = (event: KeyboardEvent) => {
      if (event.ctrlKey || event.altKey || event.metaKey || (event.target as Element).closest("input, textarea, [role=listbox]")) return;
      const found = find(event.code);
      if (!found) return;
      event.preventDefault();
      event.stopPropagation();
      if (!event.repeat) hold(...found);
    };
    const up = (event: KeyboardEvent) => {
      const found = find(event.code);
      if (found) letGo(found[0]);
    };
    const left = (event: FocusEvent) => {
      if (!region.contains(event.relatedTarget as Node | null)) letAllGo();
    };
    region.addEventListener("keydown", down);
    addEventListener("keyup", up, true);
    region.addEventListener("focusout", left);
    return () => {
      region.removeEventListener("keydown", down);
      removeEventListener("keyup", up, true);
      region.removeEventListener("focusout", left);
      letAllGo();
    };
  }, [box, usable]);
}

function Place() {
  const here = useHere();
  const channels = useChannels((state) => state.channels);
  if (!here) return <p className="hint">{t("teach.unknown")}</p>;
  const row = (channel: string, figures: readonly number[]) => (
    <dl className="figures">
      {(channels?.find((each) => each.channel === channel)?.fields ?? []).map(({ name, unit }, i) => <div key={name}><dt>{name}</dt><dd>{number(figures[i] ?? 0, 1)}{unit === "deg" ? "°" : ""}</dd></div>)}
    </dl>
  );
  return <div className="jog-place" aria-label={t("teach.here")} role="group">{row("pose", here.pose)}{row("joints", here.joints)}</div>;
}

/** How soon nothing moves the arm on when its person is gone. */
function Bound() {
  useEffect(watchRequirements, []);
  const found = useRequirements((state) => state.all)?.find((each) => each.skill === skill)?.requirements.find((each) => each.name === stopping);
  if (!found) return null;
  const { unit, factor } = shownUnit(found.unit);
  const shown = (value: number) => `${number(value * factor, 0)} ${unit}`;
  return (
    <Button className="jog-bound" onPress={() => openWindow("requirement", `${skill}/${stopping}`)}>
      <Symbol name={found.verdict === "holds" ? "tick" : "gauge"} size={18} />
      <span>{found.verdict === "holds" && typeof found.bound === "number" ? t("jog.proved", { time: shown(Math.ceil(found.bound * factor) / factor) }) : t("jog.required", { time: typeof found.limit === "number" ? shown(found.limit) : "?" })}</span>
      <Symbol name="chart" size={16} />
    </Button>
  );
}
