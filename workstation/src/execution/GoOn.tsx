// After a stop or a fault: what has happened and why, what would be repeated, and from where to go on.
import { useReactFlow, type ReactFlowInstance } from "@xyflow/react";
import { useEffect, useRef, useState } from "react";
import { Button } from "react-aria-components";
import { amountText } from "../canvas/summary";
import { focusIcon } from "../canvas/keys";
import { iconOf } from "../model/operation";
import type { Result } from "../protocol/connection";
import { ask, run, runFrom } from "../state/acts";
import { causeOf, culprit } from "../state/cause";
import { call, useCell } from "../state/cell";
import { enter, walk, useDrawing } from "../state/drawing";
import { openIcon } from "../state/windows";
import { Symbol } from "../symbols/Symbol";
import { t } from "../words/words";

type Outlook = Result<"operation.outlook">;
type Choice = Outlook["choices"][number];

/** What was changed in the drawing since then counts, except where the same run goes on. */
async function take(choice: Choice): Promise<void> {
  if (choice.method === "operation.from") await runFrom(choice.icon);
  else if (choice.method === "operation.run") await run();
  else await ask(choice.method);
}

/** Paused by the person, nothing has gone wrong: the bar's own buttons are enough. */
const needed = (state: string | undefined, failed: string | undefined) => state === "stopped" || state === "failed" || (state === "ended" && failed !== undefined);

/** After an end by an exit the server offers the start alone; the icon that failed is as sensible. */
async function choicesOf(state: string | undefined, failed: string | undefined): Promise<readonly Choice[]> {
  const { choices } = await call("operation.outlook", {});
  if (state !== "ended" || failed === undefined) return choices;
  const all = [...(await call("operation.outlook", { icon: failed })).choices, ...choices];
  // The icon before the exit is the one that failed, as a rule: one choice, not two.
  return all.filter((each, i) => all.findIndex((one) => one.icon === each.icon && one.method === each.method) === i);
}

export function GoOn() {
  const name = useDrawing((state) => state.drawing.name);
  const state = useCell((cell) => (cell.present?.snapshot.operation === name && cell.present.snapshot.activity === "idle" ? cell.present.snapshot.state : undefined));
  const failed = useCell((cell) => culprit(cell.present));
  const reason = useCell((cell) => (failed === undefined ? "" : cell.present?.runs.get(failed)?.reason) || (cell.present?.snapshot.reason ?? ""));
  const code = useCell((cell) => cell.present?.snapshot.last_code ?? 0);
  const steps = useCell((cell) => cell.present?.snapshot.steps);
  const link = useCell((cell) => cell.link);
  const [choices, setChoices] = useState<readonly Choice[]>([]);
  const [hidden, setHidden] = useState("");
  const key = `${state}:${steps}:${reason}`;
  useEffect(() => {
    setChoices([]);
    if (!needed(state, failed) || link !== "ready") return;
    let current = true;
    choicesOf(state, failed).then((result) => current && setChoices(result), () => {});
    return () => void (current = false);
  }, [key, link, state, failed]);
  const flow = useReactFlow();
  const panel = useRef<HTMLElement>(null);
  const shown = needed(state, failed) && hidden !== key;
  useEffect(() => {
    if (shown && choices.length > 0) uncover(flow, panel.current, failed ?? useCell.getState().present?.snapshot.token ?? "");
  }, [shown, choices, failed, flow]);
  if (!shown) return null;
  const wrong = state !== "stopped";
  const cause = causeOf(reason);
  return (
    <section ref={panel} className="go-on" data-state={wrong ? "failed" : "stopped"} aria-label={t("goOn.title")}>
      <div className="go-on-head">
        <Symbol name={wrong ? "error" : "stop"} size={20} />
        <div>
          <h2>{state === "failed" ? t("goOn.failed", { icon: nested(failed ?? "") }) : state === "ended" ? t("goOn.ended", { icon: nested(failed ?? ""), code }) : t("goOn.stopped")}</h2>
          {wrong && cause.what !== "" && <p className="cause">{cause.what}</p>}
          {wrong && cause.where !== "" && <p className="hint">{t("goOn.where", { place: cause.where })}</p>}
        </div>
        <Button className="button quiet only" aria-label={t("goOn.hide")} onPress={() => setHidden(key)}><Symbol name="cross" size={18} /></Button>
      </div>
      {wrong && failed !== undefined && <Button className="button primary" onPress={() => show(failed)}><Symbol name="settings" size={16} />{t("goOn.open", { icon: nested(failed) })}</Button>}
      {choices.length > 0 && (
        <ul className="choices">
          {choices.map((each) => (
            <li key={`${each.place}:${each.icon}`}>
              <Button className={each.place === "here" ? "button primary" : "button"} onPress={() => void take(each)}>{t(`goOn.${each.place}`, { icon: each.place === "start" ? t("kind.start") : nested(each.icon) })}</Button>
              <div><First choice={each} /></div>
            </li>
          ))}
        </ul>
      )}
      {!wrong && <p className="hint">{t("stop.meaning")}</p>}
    </section>
  );
}

/** What happens first, with the values of the drawing as it is now. */
function First({ choice }: { choice: Choice }) {
  const drawing = useDrawing((state) => state.drawing);
  const skills = useCell((cell) => cell.skills);
  const parts = choice.icon.split("/");
  const icon = iconOf(walk(drawing, parts.slice(0, -1)).operation, parts.at(-1)!);
  const values = Object.entries((icon?.kind === "skill" ? icon.parameters : choice.parameters) ?? {})
    .map(([name, value]) => `${name} ${amountText(value, skills.get(choice.skill)?.parameters.find((each) => each.name === name)?.unit)}`).join(", ");
  const first = choice.skill === "" ? "" : values === "" ? t("goOn.first", { skill: choice.skill }) : t("goOn.firstWith", { skill: choice.skill, values });
  const must = skills.get(choice.skill)?.preconditions ?? choice.preconditions;
  return (
    <>
      <p>{[choice.repeats ? t("goOn.repeats") : "", first, choice.forgets ? t("goOn.forgets") : ""].filter(Boolean).join(" ")}</p>
      {must.length > 0 && <p className="hint">{t("goOn.must")} {must.join(" ")}</p>}
    </>
  );
}

/** Moves the canvas so that the icon of which the panel tells does not lie under it. */
function uncover(flow: ReactFlowInstance, panel: HTMLElement | null, path: string): void {
  const told = panel?.getBoundingClientRect(), canvas = document.querySelector(".canvas")?.getBoundingClientRect();
  const box = document.querySelector(`.icon[data-id="${CSS.escape(path.slice(path.lastIndexOf("/") + 1))}"]`)?.getBoundingClientRect();
  if (!told || !canvas || !box || box.left > told.right || box.top > told.bottom) return;
  const { x, y, zoom } = flow.getViewport(), room = 40;
  const down = told.bottom + room - box.top, right = told.right + room - box.left;
  if (box.bottom + down + room < canvas.bottom) void flow.setViewport({ x, y: y + down, zoom }, { duration: 160 });
  else void flow.setViewport({ x: x + right, y, zoom }, { duration: 160 });
}

const nested = (path: string): string => path.replaceAll("/", " › ");

function show(path: string): void {
  const parts = path.split("/");
  enter(parts.slice(0, -1), [parts.at(-1)!]);
  focusIcon(parts.at(-1));
  openIcon(walk(useDrawing.getState().drawing, parts.slice(0, -1)).operation.name, parts.at(-1)!);
}
