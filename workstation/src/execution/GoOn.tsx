// After a stop, a pause or a fault: what has happened, what would be repeated, and from where to go on.
import { useEffect, useState } from "react";
import { Button } from "react-aria-components";
import type { Result } from "../protocol/connection";
import { ask } from "../state/acts";
import { call, useCell } from "../state/cell";
import { useDrawing } from "../state/drawing";
import { Symbol } from "../symbols/Symbol";
import { t } from "../words/words";

type Outlook = Result<"operation.outlook">;
type Choice = Outlook["choices"][number];

async function take(choice: Choice): Promise<void> {
  if (choice.method === "operation.from") {
    if (await ask("operation.from", { icon: choice.icon })) await ask("operation.run");
  } else {
    await ask(choice.method);
  }
}

/** Paused by the person, nothing has gone wrong: the bar's own buttons are enough. */
const needed = (state: string | undefined) => state === "stopped" || state === "failed";

export function GoOn() {
  const name = useDrawing((state) => state.drawing.name);
  const state = useCell((cell) => (cell.present?.snapshot.operation === name && cell.present.snapshot.activity === "idle" ? cell.present.snapshot.state : undefined));
  const reason = useCell((cell) => cell.present?.snapshot.reason ?? "");
  const steps = useCell((cell) => cell.present?.snapshot.steps);
  const link = useCell((cell) => cell.link);
  const [outlook, setOutlook] = useState<Outlook>();
  const [hidden, setHidden] = useState("");
  const key = `${state}:${steps}:${reason}`;
  useEffect(() => {
    setOutlook(undefined);
    if (!needed(state) || link !== "ready") return;
    let current = true;
    call("operation.outlook", {}).then((result) => current && setOutlook(result), () => {});
    return () => void (current = false);
  }, [key, link, state]);
  if (!needed(state) || hidden === key) return null;
  return (
    <section className="go-on" data-state={state} aria-label={t("goOn.title")}>
      <div className="go-on-head">
        <Symbol name={state === "failed" ? "error" : "stop"} size={20} />
        <div>
          <h2>{t(state === "failed" ? "goOn.failed" : "goOn.stopped")}</h2>
          {reason !== "" && <p>{reason}</p>}
        </div>
        <Button className="button quiet only" aria-label={t("goOn.hide")} onPress={() => setHidden(key)}><Symbol name="cross" size={18} /></Button>
      </div>
      {outlook && outlook.choices.length > 0 && (
        <ul className="choices">
          {outlook.choices.map((each) => (
            <li key={`${each.place}:${each.icon}`}>
              <Button className={each.place === "here" ? "button primary" : "button"} onPress={() => void take(each)}>{t(`goOn.${each.place}`, { icon: each.icon })}</Button>
              <div>
                <p>{each.text}</p>
                {each.preconditions.length > 0 && <p className="hint">{t("goOn.must")} {each.preconditions.join(" ")}</p>}
              </div>
            </li>
          ))}
        </ul>
      )}
      <p className="hint">{t("stop.meaning")}</p>
    </section>
  );
}
