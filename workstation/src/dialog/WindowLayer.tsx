// All open windows, in the order in which they lie. Rare ones are loaded when they are opened first.
import { lazy, Suspense, type ComponentType, type LazyExoticComponent } from "react";
import { useWindows, retarget, type OpenWindow, type WindowKind } from "../state/windows";
import { channelName, t, useLanguage } from "../words/words";
import { FloatWindow } from "./FloatWindow";
import "./print";
import { FindingsList } from "./FindingsList";
import { IconForm } from "./IconForm";
import { IconHelpButton } from "./IconHelpButton";

type Rare = typeof import("./rare");
type Live = typeof import("../live/windows");
type Body = ComponentType<{ about: string }>;
const rare = (name: keyof Rare): LazyExoticComponent<Body> => lazy(async () => ({ default: (await import("./rare"))[name] as Body }));
const live = (name: keyof Live): LazyExoticComponent<Body> => lazy(async () => ({ default: (await import("../live/windows"))[name] as Body }));
const later: Partial<Record<WindowKind, LazyExoticComponent<Body>>> = {
  skill: rare("SkillHelp"), explain: rare("Explain"), keys: rare("KeysHelp"), ways: rare("Ways"), storyboard: rare("Storyboard"), breakpoints: rare("Breakpoints"), store: rare("StoreWindow"), versions: rare("Versions"),
  channel: live("ChannelWindow"), scene: lazy(() => import("../scene/SceneWindow")), sensors: live("Sensors"), gauges: live("Gauges"), requirement: live("RequirementChart"), tuning: live("Tuning"), locations: live("Locations"), jog: live("Jog"), production: live("Production"),
};

const wide = new Set<WindowKind>(["skill", "store", "explain", "versions", "channel", "requirement", "ways", "storyboard", "scene"]);
const sizable = new Set<WindowKind>(["channel", "requirement", "scene"]);

const split = (about: string): [string, string] => [about.slice(0, about.lastIndexOf("/")), about.slice(about.lastIndexOf("/") + 1)];

export function WindowLayer() {
  useLanguage();
  const open = useWindows((state) => state.open);
  return <div className="windows">{open.map((each) => <Shown key={each.key} window={each} />)}</div>;
}

function Shown({ window: each }: { window: OpenWindow }) {
  const [operation, icon] = split(each.about);
  const Later = later[each.kind];
  if (each.kind === "icon")
    return (
      <FloatWindow window={each} title={icon} footer={<IconHelpButton operation={operation} icon={icon} />}>
        <IconForm operation={operation} id={icon} onRenamed={(id) => retarget(each.id, `${operation}/${id}`)} />
      </FloatWindow>
    );
  if (each.kind === "findings")
    return <FloatWindow window={each} title={icon === "" ? t("findings.all") : t("findings.title", { icon })}><FindingsList operation={operation} icon={icon} /></FloatWindow>;
  const titles: Partial<Record<WindowKind, string>> = {
    skill: t("help.title", { name: each.about }), explain: each.about, keys: t("keys.title"), ways: t("ways.title"), storyboard: t("story.title"), breakpoints: t("breaks.title"), store: t("store.title"),
    versions: t("versions.title", { name: each.about }), channel: channelName(each.about), scene: t("scene.title"), sensors: t("sensors.title"), gauges: t("gauges.title"), requirement: each.about.replace("/", " › "), tuning: t("tuning.title", { name: icon }), locations: t("teach.title"), jog: t("jog.title"), production: t("production.title"),
  };
  return (
    <FloatWindow window={each} title={titles[each.kind] ?? ""} wide={wide.has(each.kind)} sizable={sizable.has(each.kind)}>
      <Suspense fallback={<p className="nothing loading">{t("loading")}</p>}>{Later && <Later about={each.about} />}</Suspense>
    </FloatWindow>
  );
}
