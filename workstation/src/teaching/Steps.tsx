// The arm moved by steps along and about the tool's axes. Each press is one skill, which ends at rest.
import { useState } from "react";
import { Button } from "react-aria-components";
import { NumberBox } from "../dialog/NumberBox";
import { ask } from "../state/acts";
import { useCell } from "../state/cell";
import { t } from "../words/words";

const skill = "relative-move";
const axes = ["x", "y", "z"] as const;

export function Steps({ idle: rests }: { idle: boolean }) {
  const known = useCell((cell) => cell.skills.get(skill));
  const [way, setWay] = useState(10), [turn, setTurn] = useState(5), [speed, setSpeed] = useState(50);
  // From the press on, not only when the cell has told that it works: what is pressed meanwhile would be refused.
  const [moving, setMoving] = useState(false), idle = rests && !moving;
  if (!known?.able) return null;
  const range = (name: string) => {
    const each = known.parameters.find((one) => one.name === name);
    return { ...(each?.low === undefined ? {} : { low: Math.max(0.1, each.low) }), ...(each?.high === undefined ? {} : { high: each.high }) };
  };
  const move = (name: string, value: number) => {
    setMoving(true);
    void ask("skill.run", { skill, parameters: { [name]: value, speed } }).finally(() => setMoving(false));
  };
  const row = (prefix: "d" | "r", step: number, unit: string) => axes.map((axis) => (
    <div key={axis} className="step-axis">
      <Button className="button" isDisabled={!idle} aria-label={t("steps.move", { name: prefix === "d" ? axis : t("steps.about", { axis }), amount: `−${step} ${unit}` })} onPress={() => move(prefix + axis, -step)}>−</Button>
      <span>{prefix === "d" ? axis : `↻ ${axis}`}</span>
      <Button className="button" isDisabled={!idle} aria-label={t("steps.move", { name: prefix === "d" ? axis : t("steps.about", { axis }), amount: `+${step} ${unit}` })} onPress={() => move(prefix + axis, step)}>+</Button>
    </div>
  ));
  return (
    <div className="steps" role="group" aria-label={t("steps.title")}>
      <div className="steps-sizes">
        <NumberBox label={t("steps.way")} value={way} unit="mm" {...range("dx")} onChange={(now) => now !== undefined && setWay(now)} />
        <NumberBox label={t("steps.turn")} value={turn} unit="deg" {...range("rx")} onChange={(now) => now !== undefined && setTurn(now)} />
        <NumberBox label={t("steps.speed")} value={speed} unit="mm/s" {...range("speed")} onChange={(now) => now !== undefined && setSpeed(now)} />
      </div>
      <div className="step-axes">{row("d", way, "mm")}</div>
      <div className="step-axes">{row("r", turn, "°")}</div>
      <p className="hint">{t("steps.hint")}</p>
    </div>
  );
}
