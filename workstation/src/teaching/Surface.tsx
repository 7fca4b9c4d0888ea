// A place square on a surface, from three locations on it: the server says how the tool stands there.
import { useEffect, useState } from "react";
import { Button } from "react-aria-components";
import type { Location } from "../../generated/protocol";
import { Choose } from "../dialog/Choose";
import { TextBox } from "../dialog/TextBox";
import { ask, notice } from "../state/acts";
import { call } from "../state/cell";
import { Symbol } from "../symbols/Symbol";
import { t } from "../words/words";
import { Figures } from "./Figures";

const corners = ["origin", "along", "beside"] as const;

export function Surface({ locations, idle }: { locations: readonly Location[]; idle: boolean }) {
  const [open, setOpen] = useState(false), [name, setName] = useState("SURFACE");
  const [chosen, setChosen] = useState({ origin: "", along: "", beside: "" });
  const [pose, setPose] = useState<readonly number[]>(), [refused, setRefused] = useState("");
  const { origin, along, beside } = chosen;
  // A location that is taught again moves the surface.
  const versions = corners.map((each) => locations.find((one) => one.location === chosen[each])?.version ?? 0).join();
  useEffect(() => {
    let current = true;
    setPose(undefined);
    setRefused("");
    if (origin === "" || along === "" || beside === "") return;
    call("locations.surface", { origin, along, beside }).then((found) => current && setPose(found.pose), (problem: Error) => current && setRefused(problem.message));
    return () => void (current = false);
  }, [origin, along, beside, versions]);
  if (!open) return <Button className="button" onPress={() => setOpen(true)}><Symbol name="target" size={18} />{t("surface.open")}</Button>;
  const there = locations.find((each) => each.location === name);
  const teach = async () => {
    if (!pose) return;
    const taught = await ask("locations.teach", { location: name, pose: [...pose], based_on: there?.version ?? 0 });
    if (!taught) return;
    setOpen(false);
    notice("done", t("teach.taught", { name, version: taught.version }));
  };
  const options = locations.map((each) => ({ id: each.location, name: each.location }));
  return (
    <section className="pallet" data-wizard="surface">
      <h3 className="section-title">{t("surface.title")}</h3>
      <p className="hint">{t("surface.hint")}</p>
      <div className="pallet-fields">
        {corners.map((each) => <Choose key={each} label={t(`surface.${each}`)} value={chosen[each]} onChange={(value) => setChosen({ ...chosen, [each]: value })} options={options} />)}
        <TextBox label={t("pallet.name")} value={name} onChange={(now) => setName(now.toUpperCase())} hint={there ? t("surface.exists") : t("teach.names")} />
      </div>
      {pose && <Figures figures={pose} />}
      {refused !== "" && <p className="refusal" role="alert"><Symbol name="error" size={14} />{refused}</p>}
      <div className="chips">
        <Button className="button primary" isDisabled={!idle || !pose || name === ""} onPress={() => void teach()}>{t("surface.teach", { name })}</Button>
        <Button className="button" onPress={() => setOpen(false)}>{t("keep.cancel")}</Button>
      </div>
    </section>
  );
}
