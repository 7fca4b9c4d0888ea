// The window in which locations are taught: where the robot is, moved by steps; all locations with their versions; a
// pallet, and a place square on a surface, from three of them.
import { useState } from "react";
import { Button } from "react-aria-components";
import type { Location } from "../../generated/protocol";
import { Choose } from "../dialog/Choose";
import { TextBox } from "../dialog/TextBox";
import { ask, notice } from "../state/acts";
import { call, useCell } from "../state/cell";
import { useDrawing } from "../state/drawing";
import { openWindow } from "../state/windows";
import { Symbol } from "../symbols/Symbol";
import { moment, number, t } from "../words/words";
import { Figures } from "./Figures";
import { Pallet } from "./Pallet";
import { Steps } from "./Steps";
import { Surface } from "./Surface";
import { useHere, usePoseNames } from "./here";
import { apart, difference, freeLocation, needed } from "./places";

export default function Locations() {
  const locations = useCell((cell) => cell.locations);
  const skills = useCell((cell) => cell.skills);
  const drawing = useDrawing((state) => state.drawing);
  const idle = useCell((cell) => cell.link === "ready" && cell.present?.snapshot.activity === "idle");
  const here = useHere();
  const [name, setName] = useState(""), [open, setOpen] = useState("");
  if (!locations) return <p className="nothing">{t("teach.absent")}</p>;
  const wanted = needed(drawing, skills), missing = [...wanted.keys()].filter((each) => !locations.some((one) => one.location === each));
  const fresh = name.trim().toUpperCase() || freeLocation(locations);
  const there = locations.some((each) => each.location === fresh);
  const teach = async () => {
    const taught = await ask("locations.teach", { location: fresh, based_on: 0 });
    if (!taught) return;
    setName("");
    setOpen(taught.location);
    notice("done", t("teach.taught", { name: taught.location, version: taught.version }));
  };
  return (
    <div className="teach">
      <section className="teach-here">
        <h3 className="section-title">{t("teach.here")}</h3>
        <Figures figures={here?.pose} />
        <Steps idle={idle} />
        <div className="chips"><Button className="button" onPress={() => openWindow("jog")}><Symbol name="hand" size={16} />{t("jog.open")}</Button></div>
        <div className="teach-new">
          <TextBox label={t("teach.name")} value={name} onChange={(now) => setName(now.toUpperCase())} placeholder={freeLocation(locations)} hint={there ? t("teach.exists") : t("teach.names")} />
          <Button className="button primary" isDisabled={!idle || there} onPress={() => void teach()}><Symbol name="target" size={16} />{t("teach.teach", { name: fresh })}</Button>
        </div>
      </section>
      {missing.length > 0 && <div className="finding" data-severity="warning"><Symbol name="warning" size={18} /><div><p>{t("teach.missing", { names: missing.join(", ") })}</p></div></div>}
      <ul className="locations" aria-label={t("teach.title")}>
        {locations.map((each) => <Row key={each.location} location={each} all={locations} here={here?.pose} joints={here?.joints} idle={idle} icons={wanted.get(each.location) ?? []} open={open === each.location} onOpen={() => setOpen(open === each.location ? "" : each.location)} onRenamed={setOpen} />)}
      </ul>
      <div className="chips"><Pallet locations={locations} idle={idle} /><Surface locations={locations} idle={idle} /></div>
    </div>
  );
}

interface RowProps {
  location: Location;
  all: readonly Location[];
  here: readonly number[] | undefined;
  joints: readonly number[] | undefined;
  idle: boolean;
  icons: readonly string[];
  open: boolean;
  onOpen(): void;
  onRenamed(name: string): void;
}

function Row({ location, all, here, joints, idle, icons, open, onOpen, onRenamed }: RowProps) {
  const { location: name, pose, version } = location;
  return (
    <li data-location={name} data-open={open || undefined}>
      <Button className="location-head" aria-expanded={open} onPress={onOpen}>
        <Symbol name={open ? "up" : "down"} size={16} /><b>{name}</b>
        <span className="location-place">{pose.slice(0, 3).map((each) => number(each, 1)).join("  ")}</span>
        {here && <span className="location-apart">{t("teach.apart", { distance: number(apart(here, pose), 1) })}</span>}
        <span className="location-icons">{icons.length > 0 && t("teach.needed", { icons: icons.slice(0, 3).join(", ") + (icons.length > 3 ? "…" : "") })}</span>
      </Button>
      {open && (
        <div className="location-body">
          <Figures figures={pose} />
          <p className="hint">{location.changed ? t("teach.version", { version, when: moment(location.changed), by: location.by }) : t("teach.made")}</p>
          <Compare location={location} all={all} here={here} />
          <Acts location={location} joints={joints} here={here} idle={idle} onRenamed={onRenamed} />
        </div>
      )}
    </li>
  );
}

/** Beside another one, or beside where the robot is. */
function Compare({ location, all, here }: { location: Location; all: readonly Location[]; here: readonly number[] | undefined }) {
  const poseNames = usePoseNames();
  const [with_, setWith] = useState("*");
  const other = with_ === "*" ? here : all.find((each) => each.location === with_)?.pose;
  const more = other && difference(location.pose, other);
  return (
    <div className="location-compare">
      <Choose label={t("teach.compare")} value={with_} onChange={setWith} options={[{ id: "*", name: t("teach.here") }, ...all.filter((each) => each !== location).map((each) => ({ id: each.location, name: each.location }))]} />
      {more && <dl className="figures differences">{poseNames.map((each, i) => <div key={each} data-zero={Math.abs(more[i]!) < 0.05 || undefined}><dt>Δ{each}</dt><dd>{more[i]! > 0.05 ? "+" : ""}{number(Math.abs(more[i]!) < 0.05 ? 0 : more[i]!, 1)}{i < 3 ? "" : "°"}</dd></div>)}</dl>}
    </div>
  );
}

function Acts({ location, joints, here, idle, onRenamed }: { location: Location; joints: readonly number[] | undefined; here: readonly number[] | undefined; idle: boolean; onRenamed(name: string): void }) {
  const { location: name, version, pose } = location;
  const [asked, setAsked] = useState<"again" | "delete" | "rename" | "go">(), [to, setTo] = useState(name), [checked, setChecked] = useState<string>();
  const again = async () => {
    const taught = await ask("locations.teach", { location: name, based_on: version });
    if (taught) notice("done", t("teach.taught", { name, version: taught.version }));
    setAsked(undefined);
  };
  const rename = async () => {
    if (await ask("locations.rename", { location: name, to, based_on: version })) onRenamed(to);
    setAsked(undefined);
  };
  // The way is tried aside first, from where the arm stands; only then the arm moves.
  const go = async () => {
    setAsked("go");
    setChecked(undefined);
    try {
      const tried = await call("study.try", { skill: "move-to-location", parameters: { location: name }, ...(joints ? { joints: [...joints] } : {}) });
      if (tried.kind === "normal") {
        setAsked(undefined);
        await ask("skill.run", { skill: "move-to-location", parameters: { location: name } });
      } else {
        setChecked(tried.reason);
      }
    } catch (problem) {
      setChecked(problem instanceof Error ? problem.message : String(problem));
    }
  };
  if (asked === "go")
    return checked === undefined ? <p className="hint">{t("teach.checking")}</p> : (
      <div className="finding" data-severity="warning"><Symbol name="warning" size={18} /><div>
        <p>{t("teach.blocked", { name })}</p><p className="finding-hint">{checked}</p>
        <div className="chips">
          <Button className="button" isDisabled={!idle} onPress={() => (setAsked(undefined), void ask("skill.run", { skill: "move-to-location", parameters: { location: name } }))}>{t("teach.goAnyway")}</Button>
          <Button className="button" onPress={() => setAsked(undefined)}>{t("keep.cancel")}</Button>
        </div>
      </div></div>
    );
  if (asked === "rename")
    return <div className="teach-new"><TextBox label={t("teach.newName")} value={to} onChange={(now) => setTo(now.toUpperCase())} /><Button className="button primary" isDisabled={to === name || to === ""} onPress={() => void rename()}>{t("teach.rename")}</Button><Button className="button" onPress={() => setAsked(undefined)}>{t("keep.cancel")}</Button></div>;
  if (asked)
    return (
      <div className="finding" data-severity="warning"><Symbol name="warning" size={18} /><div>
        <p>{asked === "delete" ? t("teach.askDelete", { name }) : t("teach.askAgain", { name, distance: here ? number(apart(here, pose), 1) : "?" })}</p>
        <div className="chips">
          <Button className="button" onPress={() => void (asked === "delete" ? ask("locations.delete", { location: name, based_on: version }).then(() => setAsked(undefined)) : again())}>{t(asked === "delete" ? "teach.delete" : "teach.again")}</Button>
          <Button className="button" onPress={() => setAsked(undefined)}>{t("keep.cancel")}</Button>
        </div>
      </div></div>
    );
  return (
    <div className="chips">
      <Button className="button primary" isDisabled={!idle} onPress={() => void go()}><Symbol name="right" size={16} />{t("teach.go")}</Button>
      <Button className="button" isDisabled={!idle} onPress={() => setAsked("again")}><Symbol name="target" size={16} />{t("teach.again")}</Button>
      <Button className="button" isDisabled={!idle} onPress={() => setAsked("rename")}>{t("teach.rename")}</Button>
      <Button className="button danger" isDisabled={!idle} onPress={() => setAsked("delete")}><Symbol name="trash" size={16} />{t("teach.delete")}</Button>
    </div>
  );
}
