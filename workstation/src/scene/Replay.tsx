// A run again: which one, its steps as a strip, the slider over it, play and pause at two paces.
import { useEffect, useState } from "react";
import { Button } from "react-aria-components";
import { Choose } from "../dialog/Choose";
import { eachFrame } from "../live/eachFrame";
import { actedAt, endReplay, keptRuns, replay, show, useReplay, type KeptRun, type Loaded } from "../live/replay";
import { onEvent, useCell } from "../state/cell";
import { useReplayed } from "../state/replayed";
import { Symbol } from "../symbols/Symbol";
import { moment, number, t } from "../words/words";

const paces = [1, 0.25];

/** Read again when a run has ended. */
function useKept(): readonly KeptRun[] | undefined {
  const [kept, setKept] = useState<readonly KeptRun[]>();
  const link = useCell((state) => state.link);
  useEffect(() => {
    let current = true;
    const read = () => void keptRuns().then((runs) => current && setKept(runs), () => current && setKept([]));
    read();
    const stop = onEvent((event) => {
      if (event.event === "ends" || (event.event === "state" && event.state !== "running")) setTimeout(read, 200);
    });
    return () => {
      current = false;
      stop();
    };
  }, [link]);
  return kept;
}

export function Replay() {
  const kept = useKept(), loaded = useReplay((state) => state.loaded);
  const [reading, setReading] = useState(false), [failed, setFailed] = useState(false);
  useEffect(() => endReplay, []);
  if (!kept) return null;
  if (kept.length === 0 && !loaded) return <p className="scene-replay nothing">{t("scene.noRun")}</p>;
  const begin = (run: KeptRun | undefined) => {
    if (!run) return;
    setReading(true);
    setFailed(false);
    replay(run).catch(() => setFailed(true)).finally(() => setReading(false));
  };
  const wordOf = (each: KeptRun) => t("scene.run", { name: each.name, run: each.run, time: moment(each.begun), length: number(each.end - each.begin, 1) });
  if (!loaded)
    return (
      <div className="scene-replay">
        <Button className="button" isDisabled={reading} data-act="scene.replay" onPress={() => begin(kept[0])}><Symbol name="versions" size={16} />{t("scene.replay")}</Button>
        <span className="scene-last">{reading ? t("loading") : failed ? t("scene.unread") : wordOf(kept[0]!)}</span>
      </div>
    );
  return (
    <div className="scene-replay" data-on>
      <div className="scene-run">
        <Choose label={t("scene.which")} value={String(loaded.kept.run)} onChange={(run) => begin(kept.find((each) => String(each.run) === run))} options={(kept.some((each) => each.run === loaded.kept.run) ? kept : [loaded.kept, ...kept]).map((each) => ({ id: String(each.run), name: wordOf(each) }))} />
        <Button className="button" data-act="scene.live" onPress={endReplay}><Symbol name="resume" size={16} />{t("scene.live")}</Button>
      </div>
      <Slider loaded={loaded} />
    </div>
  );
}

function Slider({ loaded }: { loaded: Loaded }) {
  const time = useReplayed((state) => state.time), { playing, pace } = useReplay();
  const { begin, end } = loaded.kept, length = end - begin;
  useEffect(() => {
    if (!playing) return;
    let before = performance.now();
    return eachFrame(() => {
      const now = performance.now(), next = useReplayed.getState().time + ((now - before) / 1000) * useReplay.getState().pace;
      before = now;
      show(next);
      if (next >= end) useReplay.setState({ playing: false });
    });
  }, [playing, end]);
  const play = () => {
    if (!playing && time >= end) show(begin);
    useReplay.setState({ playing: !playing });
  };
  const acting = actedAt(loaded.steps, time), part = (at: number) => `${(Math.min(1, Math.max(0, (at - begin) / length)) * 100).toFixed(2)}%`;
  const what = acting ? acting.icon || acting.skill || acting.sensor : "";
  return (
    <div className="scene-slider">
      <Button className="button" data-act="scene.play" onPress={play}><Symbol name={playing ? "pause" : "run"} size={16} />{t(playing ? "scene.pause" : "scene.play")}</Button>
      <div className="tool-group" role="group" aria-label={t("scene.pace")}>
        {paces.map((each) => <Button key={each} className="button" aria-pressed={pace === each} data-selected={pace === each || undefined} onPress={() => useReplay.setState({ pace: each })}>{t("scene.times", { pace: number(each) })}</Button>)}
      </div>
      <label className="scene-time">
        <span className="hidden">{t("scene.instant")}</span>
        <span className="scene-steps" aria-hidden="true">
          {loaded.steps.map((each, i) => <i key={i} data-acting={each === acting || undefined} style={{ left: part(each.begin), width: `calc(${part(each.end ?? end)} - ${part(each.begin)})` }}><b>{each.icon.slice(each.icon.lastIndexOf("/") + 1) || each.skill}</b></i>)}
        </span>
        <input type="range" min={begin} max={end} step={0.01} value={time} aria-valuetext={t("scene.at", { time: number(time - begin, 2), icon: what || t("scene.nothing") })} onChange={(event) => show(Number(event.target.value))} />
      </label>
      <span className="scene-clock">{t("scene.of", { time: number(time - begin, 2), length: number(length, 1) })}</span>
      <span className="scene-acting">{what || t("scene.nothing")}</span>
    </div>
  );
}
