// The requirements of the skill that runs, each as a gauge: what is measured now and was the worst so far, beside the
// proved bound and the limit. A click opens its chart.
import { useEffect, useState } from "react";
import { Button } from "react-aria-components";
import type { Requirement } from "../../generated/protocol";
import { Choose } from "../dialog/Choose";
import { openWindow } from "../state/windows";
import { Symbol } from "../symbols/Symbol";
import { number, t } from "../words/words";
import { TimeChart, type Source } from "./Chart";
import { shownUnit, trackOfRequirement, useRequirements, watchRequirements } from "./requirements";
import { useSteps, type LimitLine } from "./steps";

/** The skill that acts now, else the one that acted last. */
function useActing(): string | undefined {
  return useSteps((state) => state.steps.findLast((each) => each.skill !== "")?.skill);
}

export default function Gauges() {
  useEffect(watchRequirements, []);
  const all = useRequirements((state) => state.all);
  const acting = useActing(), [chosen, setChosen] = useState("");
  if (!all) return <p className="nothing loading">{t("loading")}</p>;
  const skill = chosen || acting || all.find((each) => each.requirements.some((one) => typeof one.measured === "number"))?.skill || all[0]?.skill;
  const found = all.find((each) => each.skill === skill);
  return (
    <div className="gauges">
      <Choose label={t("gauges.skill")} value={skill ?? ""} onChange={(value) => setChosen(value === acting ? "" : value)} options={all.map((each) => ({ id: each.skill, name: each.skill, ...(each.skill === acting ? { aside: t("gauges.acting") } : {}) }))} />
      {found?.requirements.length === 0 && <p className="nothing">{t("gauges.none")}</p>}
      {found?.requirements.map((each) => <Gauge key={each.name} skill={found.skill} requirement={each} />)}
      <p className="gauge-legend">
        <span><i data-mark="now" />{t("gauges.now")}</span><span><i data-mark="worst" />{t("gauges.worst")}</span><span><i data-mark="bound" />{t("gauges.bound")}</span><span><i data-mark="limit" />{t("gauges.limit")}</span>
      </p>
    </div>
  );
}

const digitsOf = (factor: number) => (factor === 1000 ? 2 : 1);

function Gauge({ skill, requirement }: { skill: string; requirement: Requirement }) {
  const { unit, factor } = shownUnit(requirement.unit);
  const values = { now: requirement.now, worst: requirement.measured, bound: requirement.bound, limit: requirement.limit };
  const numbers = Object.values(values).filter((each): each is number => typeof each === "number");
  const most = Math.max(...numbers, 1e-9) * 1.08;
  const at = (value: number) => `${Math.min(100, Math.max(0, (value / most) * 100))}%`;
  const text = (value: number | null | undefined) => (typeof value === "number" ? `${number(value * factor, digitsOf(factor))} ${unit}` : "–");
  const broken = typeof requirement.margin === "number" && requirement.margin < 0;
  return (
    <Button className="gauge" data-broken={broken || undefined} onPress={() => openWindow("requirement", `${skill}/${requirement.name}`)}>
      <span className="gauge-head"><b>{requirement.name}</b>{broken && <span className="gauge-broken"><Symbol name="warning" size={14} />{t("gauges.broken")}</span>}<span className="gauge-now"><span className="hidden">{t("gauges.now")}</span> {text(values.now)}</span></span>
      <span className="gauge-bar">
        {typeof values.limit === "number" && <i data-mark="beyond" style={{ left: at(values.limit) }} />}
        {typeof values.now === "number" && <i data-mark="now" style={{ width: at(values.now) }} />}
        {typeof values.worst === "number" && <i data-mark="worst" style={{ left: at(values.worst) }} />}
        {typeof values.bound === "number" && <i data-mark="bound" style={{ left: at(values.bound) }} />}
        {typeof values.limit === "number" && <i data-mark="limit" style={{ left: at(values.limit) }} />}
      </span>
      <span className="gauge-figures">
        <span>{t("gauges.worst")} <b>{text(values.worst)}</b></span>
        <span>{t(requirement.verdict === "proving" ? "gauges.proving" : "gauges.bound")} <b>{text(values.bound)}</b></span>
        <span>{t("gauges.limit")} <b>{text(values.limit)}</b></span>
      </span>
    </Button>
  );
}

/** The requirement against time. */
export function RequirementChart({ about }: { about: string }) {
  useEffect(watchRequirements, []);
  const at = about.lastIndexOf("/"), skill = about.slice(0, at), name = about.slice(at + 1);
  const requirement = useRequirements((state) => state.all?.find((each) => each.skill === skill)?.requirements.find((each) => each.name === name));
  const [span, setSpan] = useState(20);
  const [source, setSource] = useState<Source>();
  const { bound, limit, unit } = requirement ?? {};
  useEffect(() => {
    if (unit === undefined) return;
    const shown = shownUnit(unit), fields = [{ field: 0, name: t("gauges.now"), unit: shown.unit }, { field: 1, name: t("gauges.worst"), unit: shown.unit }];
    const line = (value: number | null | undefined, parameter: string, kind: LimitLine["kind"]): LimitLine[] =>
      typeof value === "number" ? [{ field: t("gauges.worst"), value: value * shown.factor, kind, parameter, begin: -Infinity, end: undefined }] : [];
    const lines = [...line(bound, t("gauges.bound"), "target"), ...line(limit, t("gauges.limit"), "error")];
    setSource({ title: about, fields, track: trackOfRequirement(skill, name), around: { steps: (begin, end) => useSteps.getState().steps.filter((each) => each.skill === skill && each.begin <= end && (each.end ?? Infinity) >= begin), limits: () => lines } });
  }, [about, skill, name, bound, limit, unit]);
  if (!requirement || !source) return <p className="nothing loading">{t("loading")}</p>;
  return <><p className="requirement-text">{requirement.text}</p><TimeChart source={source} span={span} onSpan={setSpan} /></>;
}
