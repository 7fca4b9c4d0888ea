// A profile of the range finder as the skill got it: its points, what the logical sensors see in it, and where the
// scan had no range. The last ones are kept, and can be looked back at.
import { useEffect, useRef, useState } from "react";
import type { Channel, ProfileMark } from "../../generated/protocol";
import { Symbol } from "../symbols/Symbol";
import { number, t } from "../words/words";
import { saveFile, ticks } from "./export";
import type { ProfileFrame } from "./frames";
import { eachFrame } from "./eachFrame";
import { profiles, profileVersion, watch } from "./live";
import { actedAt, useReplay } from "./replay";
import type { RowTrack } from "./rowTrack";
import { limitsOf, stepsWithin, type LimitLine } from "./steps";
import { lookAt, useInstant } from "./time";
import { ChartTools } from "./Tools";

const width = 640, height = 360, left = 52, right = 12, top = 40, bottom = 46;

/** Points are kept of a run, and not what the logical sensors saw in them, nor where there was no range. */
function recorded(track: RowTrack, channel: string, time: number): ProfileFrame | undefined {
  const at = Math.max(0, track.at(time)), numbers = track.numbers[at], time_s = track.times[at];
  if (!numbers || time_s === undefined) return undefined;
  const points = numbers.length / 2;
  return { form: "profile", channel, time_s, y: Float64Array.from({ length: points }, (_, i) => numbers[2 * i]!), z: Float64Array.from({ length: points }, (_, i) => numbers[2 * i + 1]!), scanned: points, missing: [], marks: [], dropped: 0 };
}

/** The newest profile, or the one of the instant at which people look. */
function useProfile(channel: string, held: ProfileFrame | undefined): ProfileFrame | undefined {
  const time = useInstant((state) => state.time), again = useReplay((state) => state.loaded)?.rows.get(channel);
  const [newest, setNewest] = useState(profiles.at(-1));
  useEffect(() => {
    let seen = -1;
    return eachFrame(() => {
      if (seen === profileVersion.count) return;
      seen = profileVersion.count;
      setNewest(profiles.at(-1));
    });
  }, []);
  if (again && time !== undefined) return recorded(again, channel, time);
  if (time !== undefined) return profiles.findLast((each) => each.time_s <= time) ?? profiles[0];
  return held ?? newest;
}

/** The range of z, and of y, that holds all; it grows by steps, so that the picture does not shake. */
function frameOf(profile: ProfileFrame, limits: readonly LimitLine[]): { y: [number, number]; z: [number, number] } {
  let far = 60, deep = 0, near = Infinity;
  for (let i = 0; i < profile.y.length; ++i) {
    far = Math.max(far, Math.abs(profile.y[i]!));
    deep = Math.max(deep, profile.z[i]!);
    near = Math.min(near, profile.z[i]!);
  }
  for (const each of limits) [near, deep] = [Math.min(near, each.value), Math.max(deep, each.value)];
  if (near > deep) [near, deep] = [100, 400];
  const up = (value: number, step: number) => Math.ceil(value / step) * step, down = (value: number, step: number) => Math.floor(value / step) * step;
  return { y: [-up(far, 20), up(far, 20)], z: [down(near - 12, 20), up(deep + 12, 20)] };
}

const wordOf = (mark: ProfileMark) => `${t(`mark.${mark.name}`)}${mark.value === undefined ? "" : ` ${number(mark.value, 1)} ${mark.unit}`}`;

export function ProfileView({ channel }: { channel: Channel }) {
  useEffect(() => watch(channel.channel, 0.001), [channel.channel]);
  const [held, setHeld] = useState<ProfileFrame>();
  const profile = useProfile(channel.channel, held), again = useReplay((state) => state.loaded !== undefined);
  const drawn = useRef<SVGSVGElement>(null);
  const save = (kind: "csv" | "svg") => {
    if (!profile) return;
    if (kind === "csv") return saveFile("profile.csv", "text/csv", ["y (mm),z (mm)", ...Array.from(profile.y, (y, i) => `${y},${profile.z[i]}`)].join("\n") + "\n");
    if (drawn.current) saveFile("profile.svg", "image/svg+xml", withLooks(drawn.current));
  };
  return (
    <div className="chart profile" data-held={held !== undefined || undefined}>
      <ChartTools held={held !== undefined} onHold={(still) => setHeld(still ? profile : undefined)} onSave={save} />
      {profile ? <Picture profile={profile} channel={channel} drawn={drawn} /> : <p className="nothing">{t("profile.none")}</p>}
      {again && <p className="chart-replayed"><Symbol name="versions" size={16} />{t("scene.notLive")}</p>}
      {profile && <Reading profile={profile} again={again} />}
      {!again && profiles.length > 1 && <Back profile={profile} />}
    </div>
  );
}

function Picture({ profile, channel, drawn }: { profile: ProfileFrame; channel: Channel; drawn: React.RefObject<SVGSVGElement | null> }) {
  const loaded = useReplay((state) => state.loaded), acted = loaded && actedAt(loaded.steps, profile.time_s);
  const limits = (loaded ? (acted ? [acted] : []) : stepsWithin(profile.time_s, profile.time_s)).flatMap((each) => limitsOf(each, channel));
  const { y, z } = frameOf(profile, limits);
  const px = (value: number) => left + ((value - y[0]) / (y[1] - y[0])) * (width - left - right);
  // The range finder is above, so z grows downwards.
  const pz = (value: number) => top + ((value - z[0]) / (z[1] - z[0])) * (height - top - bottom);
  const points = Array.from(profile.y, (at, i) => `M${px(at).toFixed(1)} ${pz(profile.z[i]!).toFixed(1)}h0`).join("");
  return (
    <svg ref={drawn} className="profile-picture" viewBox={`0 0 ${width} ${height}`} role="img" aria-label={t("profile.picture", { count: profile.y.length, time: number(profile.time_s, 2) })}>
      {ticks(z[0], z[1]).map((each) => <g key={each}><path className="profile-grid" d={`M${left} ${pz(each)}H${width - right}`} /><text x={left - 8} y={pz(each)} textAnchor="end" dominantBaseline="middle">{number(each)}</text></g>)}
      {ticks(y[0], y[1]).map((each) => <g key={each}><path className="profile-grid" d={`M${px(each)} ${top}V${height - bottom}`} /><text x={px(each)} y={height - bottom + 18} textAnchor="middle">{number(each)}</text></g>)}
      <text x={6} y={12} dominantBaseline="middle">{t("profile.depth")}</text>
      <text x={width - right} y={height - 8} textAnchor="end">{t("profile.across")}</text>
      <Scan profile={profile} />
      {limits.map((each, i) => <g key={i} className="profile-limit" data-kind={each.kind}><path d={`M${left} ${pz(each.value)}H${width - right}`} /><text x={width - right - 4} y={pz(each.value) - 5} textAnchor="end">{each.parameter}</text></g>)}
      <path className="profile-points" d={points} />
      {profile.marks.map((mark, i) => {
        const path = mark.points.map(([a, b], at) => `${at === 0 ? "M" : "L"}${px(a!).toFixed(1)} ${pz(b!).toFixed(1)}`).join("");
        const [a, b] = mark.points.at(-1) as [number, number];
        return mark.points.length > 1
          ? <path key={i} className="profile-line" data-mark={mark.name} d={path} />
          : <g key={i} className="profile-mark" data-mark={mark.name} transform={`translate(${px(a).toFixed(1)} ${pz(b).toFixed(1)})`}><path d={mark.name === "edge" ? "M0 -9L9 0L0 9L-9 0Z" : "M-7 -11H7L0 -2Z"} /><text x={0} y={mark.name === "edge" ? 24 : -16} textAnchor="middle">{t(`mark.${mark.name}`)}</text></g>;
      })}
    </svg>
  );
}

/** The scan from its first point to its last: what had no range is marked. */
function Scan({ profile }: { profile: ProfileFrame }) {
  const at = (index: number) => left + (index / profile.scanned) * (width - left - right);
  return (
    <g className="profile-scan">
      <path d={`M${left} ${top - 8}H${width - right}`} />
      {profile.missing.map(([from, to]) => <path key={from} data-missing d={`M${at(from).toFixed(1)} ${top - 8}H${Math.max(at(to), at(from) + 2).toFixed(1)}`} />)}
    </g>
  );
}

function Reading({ profile, again }: { profile: ProfileFrame; again: boolean }) {
  const missing = profile.missing.reduce((sum, [from, to]) => sum + to - from, 0);
  return (
    <ul className="profile-reading">
      <li><b>{number(profile.time_s, 3)} s</b></li>
      {profile.marks.map((mark, i) => <li key={i} data-mark={mark.name}>{wordOf(mark)}</li>)}
      {again ? <li>{t("profile.again", { count: profile.y.length })}</li> : <li data-missing={missing > 0 || undefined}>{t("profile.missing", { count: missing, all: profile.scanned })}</li>}
    </ul>
  );
}

/** Looks back over the profiles that are kept. */
function Back({ profile }: { profile: ProfileFrame | undefined }) {
  const at = profile ? profiles.indexOf(profile) : profiles.length - 1;
  return (
    <label className="profile-back">
      <span>{t("profile.back")}</span>
      <input type="range" min={0} max={profiles.length - 1} value={at < 0 ? profiles.length - 1 : at}
        onChange={(event) => lookAt(Number(event.target.value) === profiles.length - 1 ? undefined : profiles[Number(event.target.value)]!.time_s)} />
    </label>
  );
}

const looks = ["fill", "stroke", "stroke-width", "stroke-linecap", "stroke-dasharray", "font-size", "font-weight", "opacity"];

/** The picture with the looks that its style sheet gave it. */
function withLooks(drawn: SVGSVGElement): string {
  const copy = drawn.cloneNode(true) as SVGSVGElement;
  const from = [drawn, ...drawn.querySelectorAll("*")], to = [copy, ...copy.querySelectorAll("*")];
  from.forEach((each, i) => {
    const style = getComputedStyle(each);
    for (const name of looks) to[i]!.setAttribute(name, style.getPropertyValue(name));
  });
  copy.setAttribute("xmlns", "http://www.w3.org/2000/svg");
  copy.setAttribute("font-family", "Inter, sans-serif");
  return new XMLSerializer().serializeToString(copy);
}
