// Run, pause, resume, step, stop. Stop is never switched off: any client may stop whatever runs.
import { useLayoutEffect } from "react";
import { Button, Tooltip, TooltipTrigger } from "react-aria-components";
import { pause, restart, resume, run, step, stop } from "../state/acts";
import { useCell } from "../state/cell";
import { useChecks } from "../state/checks";
import { useDrawing } from "../state/drawing";
import type { SymbolName } from "../symbols/drawings";
import { Symbol } from "../symbols/Symbol";
import { t, type Word } from "../words/words";

interface ActProps {
  symbol: SymbolName;
  word: Word;
  tip: Word;
  keys: string;
  act(): Promise<unknown>;
  disabled?: boolean;
  look?: string;
}

function Act({ symbol, word, tip, keys, act, disabled = false, look = "" }: ActProps) {
  return (
    <TooltipTrigger delay={500}>
      <Button className={`button act ${look}`} onPress={() => void act()} isDisabled={disabled} data-act={word}><Symbol name={symbol} size={18} /><span>{t(word)}</span></Button>
      <Tooltip className="tooltip">{t(tip)}{keys !== "" && <kbd>{keys}</kbd>}</Tooltip>
    </TooltipTrigger>
  );
}

/** What can be done now. */
function useCan() {
  const name = useDrawing((state) => state.drawing.name);
  const link = useCell((cell) => cell.link);
  const state = useCell((cell) => cell.present?.snapshot.state);
  const activity = useCell((cell) => cell.present?.snapshot.activity);
  const loaded = useCell((cell) => cell.present?.snapshot.operation === name);
  const pausing = useCell((cell) => cell.present?.snapshot.pausing ?? false);
  const errors = useChecks((checks) => (checks.result?.errors ?? 0) > 0);
  const empty = useDrawing((each) => each.drawing.icons.length === 0);
  const ready = link === "ready", idle = activity !== "operation" && activity !== "skill";
  const halted = loaded && (state === "paused" || state === "stopped") && idle;
  return { run: ready && idle && !halted && !errors && !empty, step: ready && idle && !errors && !empty, resume: ready && halted, pause: ready && state === "running" && !pausing, halted, errors };
}

export function RunButtons() {
  const can = useCan();
  useLayoutEffect(() => {
    const pressed = (event: KeyboardEvent) => {
      if (event.key === "F5") void (can.halted ? resume() : can.run ? run() : undefined);
      else if (event.key === "F6") void (can.pause ? pause() : undefined);
      else if (event.key === "F8") void (can.step ? step() : undefined);
      else if (event.key === "F9") void stop();
      else return;
      event.preventDefault();
    };
    document.addEventListener("keydown", pressed);
    return () => document.removeEventListener("keydown", pressed);
  });
  return (
    <div className="run-buttons" role="group" aria-label={t("run.group")}>
      {can.halted
        ? <Act symbol="resume" word="run.resume" tip="run.resumeTip" keys="F5" act={resume} look="primary" />
        : <Act symbol="run" word="run.run" tip={can.errors ? "run.errorsTip" : "run.runTip"} keys="F5" act={run} disabled={!can.run} look="primary" />}
      <Act symbol="pause" word="run.pause" tip="run.pauseTip" keys="F6" act={pause} disabled={!can.pause} />
      <Act symbol="step" word="run.step" tip="run.stepTip" keys="F8" act={step} disabled={!can.step} />
      <Act symbol="stop" word="run.stop" tip="run.stopTip" keys="F9" act={stop} look="stop" />
      {can.halted && <Act symbol="restart" word="run.again" tip="run.againTip" keys="" act={restart} />}
    </div>
  );
}
