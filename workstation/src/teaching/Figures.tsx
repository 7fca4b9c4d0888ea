// The six figures of a place, with their names as the robot's description has them.
import { number, t } from "../words/words";
import { usePoseNames } from "./here";

export function Figures({ figures }: { figures: readonly number[] | undefined }) {
  const poseNames = usePoseNames();
  if (!figures) return <p className="hint">{t("teach.unknown")}</p>;
  return <dl className="figures">{poseNames.map((each, i) => <div key={each}><dt>{each}</dt><dd>{number(figures[i]!, 1)}{i < 3 ? "" : "°"}</dd></div>)}</dl>;
}
