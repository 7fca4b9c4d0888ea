// The window of the cell in three dimensions: live, or a run again. By mouse, by touch, by keys and by named buttons.
import { useEffect, useId, useRef, useState, type KeyboardEvent, type RefObject } from "react";
import { Button, Checkbox, Popover, DialogTrigger, Dialog, ToggleButton } from "react-aria-components";
import { Matrix4 } from "three";
import type { Scene } from "../../generated/protocol";
import { Tool } from "../canvas/CanvasTools";
import { eachFrame } from "../live/eachFrame";
import { profiles, profileVersion, rowsOf, trackOf, useChannels, watch } from "../live/live";
import { onLook } from "../live/look";
import { replayedTrack, useReplay } from "../live/replay";
import type { RowTrack } from "../live/rowTrack";
import type { Track } from "../live/track";
import { call, useCell } from "../state/cell";
import { useReplayed } from "../state/replayed";
import { Symbol } from "../symbols/Symbol";
import { number, t, type Word } from "../words/words";
import { Replay } from "./Replay";
import type { Place, Shows } from "./news";
import { Stage, type Label, type NamedView } from "./stage";

const poses = "poses", contacts = "contact-points", force = "force", pose = "pose", profile = "profile";
/** As often as the server sends them. */
const period = 0.034;
/** A scan older than this is not shown, s. */
const fresh = 0.6;
const named: readonly { view: NamedView; word: Word; key: string }[] = [
  { view: "front", word: "scene.front", key: "1" }, { view: "side", word: "scene.side", key: "2" }, { view: "top", word: "scene.top", key: "3" }, { view: "iso", word: "scene.iso", key: "4" },
];
/** Of a name in the picture, px. */
const line = 18;
const newtons = (newton: number) => `${number(newton, newton < 9.95 ? 1 : 0)} N`;
const still = () => matchMedia("(prefers-reduced-motion: reduce)").matches;

/** What the cell looks like, and where its locations are. */
function useScene(): { scene: Scene | undefined; places: readonly Place[]; absent: boolean } {
  const [scene, setScene] = useState<Scene>(), [places, setPlaces] = useState<readonly Place[]>([]), [absent, setAbsent] = useState(false);
  const link = useCell((state) => state.link), taught = useCell((state) => state.locations), epoch = useCell((state) => state.present?.snapshot.epoch);
  useEffect(() => {
    if (link === "ready") call("scene.get").then(setScene, () => setAbsent(true));
  }, [link, epoch]);
  useEffect(() => {
    if (link === "ready") call("scene.locations").then(setPlaces, () => {});
  }, [link, taught]);
  return { scene, places, absent };
}

export default function SceneWindow() {
  const { scene, places, absent } = useScene();
  const channels = useChannels((state) => state.channels);
  if (absent) return <p className="nothing">{t("scene.absent")}</p>;
  if (!scene || !channels) return <p className="nothing loading">{t("loading")}</p>;
  return <View scene={scene} places={places} offered={channels.map((each) => each.channel)} />;
}

function View({ scene, places, offered }: { scene: Scene; places: readonly Place[]; offered: readonly string[] }) {
  const frame = useRef<HTMLDivElement>(null), names = useRef<HTMLDivElement>(null), stage = useRef<Stage | undefined>(undefined);
  const [failed, setFailed] = useState(false), [follow, setFollow] = useState(false);
  const [shows, setShows] = useState<Shows>({ path: true, contacts: true, sensor: false, laser: true, locations: true });
  const loaded = useReplay((state) => state.loaded), told = useId(), keys = useId();
  const has = (channel: string) => offered.includes(channel);

  useEffect(() => {
    const ends = [[poses, period], [contacts, period], [force, 0.02], [pose, 0.05], [profile, 0.03]].filter(([channel]) => has(channel as string)).map(([channel, each]) => watch(channel as string, each as number));
    return () => ends.forEach((end) => end());
    // eslint-disable-next-line -- a cell's channels stay
  }, []);

  useEffect(() => {
    const host = frame.current!, canvas = document.createElement("canvas");
    canvas.setAttribute("aria-hidden", "true");
    host.prepend(canvas);
    const made = new Stage(canvas, scene, still, () => {
      canvas.remove();
      setFailed(true);
    });
    stage.current = made;
    const resized = new ResizeObserver(() => made.resize(host.clientWidth, host.clientHeight));
    made.resize(host.clientWidth, host.clientHeight);
    resized.observe(host);
    const stopLook = onLook(() => made.colour());
    const words = new Map<string, HTMLElement>();
    const show = showing(made);
    let taken: { x: number; y: number; width: number }[] = [];
    const name = (label: Label, x: number, y: number, seen: boolean) => {
      let text = words.get(label.key);
      if (!text) {
        text = document.createElement("span");
        words.set(label.key, text);
        names.current?.append(text);
      }
      if (text.textContent !== label.text) text.textContent = label.text;
      text.dataset["kind"] = label.kind;
      text.hidden = !seen;
      // Names that would lie over one another come below one another.
      const width = label.text.length * 7 + 14;
      let below = y;
      while (seen && label.kind === "location" && taken.some((each) => Math.abs(each.y - below) < line && each.x < x + width && x < each.x + each.width)) below += 4;
      if (seen && label.kind === "location") taken.push({ x, y: below, width });
      text.style.transform = `translate(${x.toFixed(1)}px, ${below.toFixed(1)}px)`;
    };
    /** The cell's time of the picture that was asked for last. */
    let asked: number | undefined;
    const stopFrames = eachFrame(() => {
      if (!made.busy && asked !== undefined) host.dataset["time"] = String(asked);
      const time = show();
      taken = [];
      const drawn = made.draw(name);
      // What nobody would see is not drawn anew.
      if (drawn || !made.stale) asked = time;
      if (!drawn) return;
      const there = new Set(made.labels.map((each) => each.key));
      for (const [key, text] of words) if (!there.has(key)) text.hidden = true;
      host.dataset["camera"] = made.camera_words;
      host.dataset["fineness"] = made.fineness_words;
      host.dataset["tip"] = made.tipAt.toArray().map((each) => each.toFixed(5)).join(" ");
    });
    return () => {
      stopFrames();
      stopLook();
      resized.disconnect();
      made.end();
      stage.current = undefined;
      for (const each of words.values()) each.remove();
      canvas.remove();
    };
  }, [scene]);
  useEffect(() => stage.current?.place(places), [places, scene]);
  useEffect(() => stage.current?.show(shows), [shows, scene]);
  useEffect(() => stage.current?.followTool(follow), [follow, scene]);

  const go = (view: NamedView) => {
    setFollow(false);
    stage.current?.view(view);
  };
  const fit = () => {
    setFollow(false);
    stage.current?.fit();
  };
  const acts: Record<string, () => void> = {
    ArrowLeft: () => stage.current?.orbit(-6, 0), ArrowRight: () => stage.current?.orbit(6, 0), ArrowUp: () => stage.current?.orbit(0, 6), ArrowDown: () => stage.current?.orbit(0, -6),
    "+": () => stage.current?.zoom(0.85), "=": () => stage.current?.zoom(0.85), "-": () => stage.current?.zoom(1 / 0.85), Home: fit, "0": fit, f: () => setFollow((was) => !was),
    ...Object.fromEntries(named.map(({ view, key }) => [key, () => go(view)])),
  };
  const pressed = (event: KeyboardEvent) => {
    const act = event.ctrlKey || event.metaKey || event.altKey ? undefined : acts[event.key];
    if (!act) return;
    event.preventDefault();
    event.stopPropagation();
    act();
  };
  const choices: [keyof Shows, Word, boolean][] = [
    ["contacts", "scene.contacts", has(contacts)], ["sensor", "scene.sensor", has(force)], ["laser", "scene.laser", has(profile)], ["path", "scene.path", true], ["locations", "scene.locations", places.length > 0],
  ];
  return (
    <div className="scene" data-replayed={loaded !== undefined || undefined}>
      <div className="scene-tools">
        <div className="tool-group" role="group" aria-label={t("scene.views")}>
          {named.map(({ view, word, key }) => <Button key={view} className="button" data-view={view} aria-keyshortcuts={key} onPress={() => go(view)}>{t(word)}</Button>)}
        </div>
        <div className="tool-group">
          <Tool symbol="minus" text={t("canvas.zoomOut")} keys="−" onPress={() => stage.current?.zoom(1 / 0.8)} />
          <Tool symbol="plus" text={t("canvas.zoomIn")} keys="+" onPress={() => stage.current?.zoom(0.8)} />
          <Tool symbol="fit" text={t("scene.fit")} keys="0" onPress={fit} />
        </div>
        <ToggleButton className="button" isSelected={follow} onChange={setFollow} data-act="scene.follow"><Symbol name="target" size={16} />{t("scene.follow")}</ToggleButton>
        <span className="grow" />
        <DialogTrigger>
          <Button className="button"><Symbol name="settings" size={16} />{t("scene.show")}</Button>
          <Popover className="popover" placement="bottom end">
            <Dialog className="scene-shows" aria-label={t("scene.show")}>
              {choices.filter(([, , there]) => there).map(([key, word]) => (
                <Checkbox key={key} className="checkbox" isSelected={shows[key]} onChange={(on) => setShows({ ...shows, [key]: on })}><span className="box" aria-hidden="true"><Symbol name="tick" size={14} /></span>{t(word)}</Checkbox>
              ))}
            </Dialog>
          </Popover>
        </DialogTrigger>
      </div>
      <div ref={frame} className="scene-frame" role="application" aria-label={t("scene.label")} aria-describedby={`${told} ${keys}`} tabIndex={0} onKeyDown={pressed}>
        <div ref={names} className="scene-names" aria-hidden="true" />
        {failed && <p className="nothing">{t("scene.none")}</p>}
        {loaded && <p className="scene-mark"><Symbol name="versions" size={16} />{t("scene.notLive")}</p>}
        <p className="scene-scale" aria-hidden="true">{t("scene.scale")}</p>
        <p id={keys} className="hidden">{t("scene.keys")}</p>
      </div>
      <Told id={told} />
      <Replay />
    </div>
  );
}

/** Puts what the channels show, live or of the replayed run, into the picture. Gives the cell's time of it, s. */
function showing(stage: Stage): () => number | undefined {
  let shownTime: number | undefined;
  let of: unknown, seen = "", walked = 0, scanned: unknown;
  const tipThen = new Matrix4();
  /** Of a replay: how much of the path there is at each instant. */
  let pieces: number[] = [];
  /** There is a scan to show, if it is asked for. */
  let fanned = false;
  const putFan = (y: Float64Array, z: Float64Array, rows: RowTrack, at: number) => {
    fanned = y.length > 0;
    stage.scan(fanned ? { y, z, tip: stage.tipOf(rows.numbers[at]!, tipThen).toArray() } : undefined);
  };
  const noFan = () => {
    if (fanned) stage.scan(undefined);
    fanned = false;
  };
  const feel = (channel: Track, at: number) => stage.feel(at >= 0 ? [0, 1, 2].map((field) => channel.last[field]![at]!) : undefined, newtons);
  const walk = (rows: RowTrack) => {
    // A track that has begun anew, or lost its older half, is walked from its beginning.
    for (const time of rows.times.slice(rows.at(walked) + 1)) {
      stage.tipOf(rows.numbers[rows.at(time)]!, tipThen);
      stage.path.add(stage.tipAt.clone().setFromMatrixPosition(tipThen));
      walked = time;
    }
  };
  const live = () => {
    const rows = rowsOf(poses), points = rowsOf(contacts), forces = trackOf(force, 6), now = `${rows.version}:${points.version}:${forces.version}:${profileVersion.count}`;
    const time = rows.times.at(-1) ?? 0;
    if (now === seen) return;
    seen = now;
    if (rows.size > 0) {
      if (time < walked) {
        walked = 0;
        stage.path.clear();
      }
      walk(rows);
      stage.put(rows.numbers.at(-1)!);
    }
    if (points.size > 0) stage.press(points.numbers.at(-1)!, newtons);
    feel(forces, forces.size - 1);
    const scan = profiles.at(-1), at = scan ? rows.at(scan.time_s) : -1;
    if (!scan || at < 0 || time - scan.time_s >= fresh) noFan();
    else if (scan !== scanned) putFan(scan.y, scan.z, rows, at);
    scanned = scan;
    shownTime = time;
  };
  const again = () => {
    const { loaded } = useReplay.getState(), { time } = useReplayed.getState();
    const rows = loaded?.rows.get(poses), points = loaded?.rows.get(contacts), scans = loaded?.rows.get(profile), forces = replayedTrack(force, 6);
    const now = `${time}:${forces.version}:${stage.shown.sensor}`;
    if (!rows || rows.size === 0 || now === seen) return;
    seen = now;
    const at = Math.max(0, rows.at(time)), later = rows.numbers[at + 1];
    stage.put(rows.numbers[at]!, later, later ? Math.min(1, Math.max(0, (time - rows.times[at]!) / (rows.times[at + 1]! - rows.times[at]!))) : 0);
    const pressed = points ? points.at(time) : -1;
    stage.press(pressed >= 0 ? points!.numbers[pressed]! : new Float32Array(0), newtons);
    feel(forces, forces.at(time) ?? -1);
    stage.path.upTo(pieces[at] ?? 0);
    stage.stale = true;
    const scan = scans ? scans.at(time) : -1;
    if (scan >= 0 && time - scans!.times[scan]! < fresh) {
      const points_of = Float64Array.from(scans!.numbers[scan]!), y = points_of.filter((_, i) => i % 2 === 0), z = points_of.filter((_, i) => i % 2 === 1);
      putFan(y, z, rows, Math.max(0, rows.at(scans!.times[scan]!)));
    } else noFan();
    shownTime = time;
  };
  return () => {
    const { loaded } = useReplay.getState();
    if (loaded !== of) {
      of = loaded;
      seen = "";
      scanned = undefined;
      walked = 0;
      stage.path.clear();
      stage.wholePath.clear();
      const whole = loaded?.rows.get(poses);
      pieces = (whole?.numbers ?? []).map((numbers) => {
        const tip = stage.tipAt.clone().setFromMatrixPosition(stage.tipOf(numbers, tipThen));
        for (const each of [stage.path, stage.wholePath]) each.add(tip);
        return stage.path.count;
      });
      stage.stale = true;
    }
    if (loaded) again();
    else live();
    return shownTime;
  };
}

/** Where the tool is, in words: for everybody, and for those who do not see the picture. */
function Told({ id }: { id: string }) {
  const replayed = useReplayed((state) => (state.run === undefined ? undefined : state.time));
  const tracks = useReplay((state) => state.tracks), loaded = useReplay((state) => state.loaded);
  const [text, setText] = useState(""), [rests, setRests] = useState("");
  const last: RefObject<{ text: string; since: number; said: boolean }> = useRef({ text: "", since: 0, said: false });
  useEffect(() => {
    const look = () => {
      const track = loaded ? replayedTrack(pose, 6) : trackOf(pose, 6);
      const at = replayed === undefined ? track.size - 1 : track.at(replayed);
      if (at === undefined || at < 0) return;
      const [x, y, z, o, a, turn] = [0, 1, 2, 3, 4, 5].map((field) => track.last[field]![at]!) as [number, number, number, number, number, number];
      const now = t("scene.tool", { x: number(x, 1), y: number(y, 1), z: number(z, 1), o: number(o, 1), a: number(a, 1), t: number(turn, 1) });
      // Each is set once: React keeps an update that changes nothing until the component is rendered again.
      if (now !== last.current.text) {
        last.current = { text: now, since: performance.now(), said: false };
        setText(now);
      } else if (!last.current.said && performance.now() - last.current.since > 1000) {
        // Said aloud once it has come to rest.
        last.current.said = true;
        setRests(now);
      }
    };
    look();
    const timer = setInterval(look, 200);
    return () => clearInterval(timer);
  }, [replayed, loaded, tracks]);
  return (
    <>
      <p id={id} className="scene-told">{text}</p>
      <p className="hidden" role="status">{rests}</p>
    </>
  );
}
