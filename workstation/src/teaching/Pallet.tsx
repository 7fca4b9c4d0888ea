// A pallet from three taught corners: all its places become locations.
import { useState } from "react";
import { Button } from "react-aria-components";
import type { Location } from "../../generated/protocol";
import { Choose } from "../dialog/Choose";
import { NumberBox } from "../dialog/NumberBox";
import { TextBox } from "../dialog/TextBox";
import { ask, notice } from "../state/acts";
import { Symbol } from "../symbols/Symbol";
import { t } from "../words/words";
import { placesOf, wrongCorners, type Pose } from "./places";

export function Pallet({ locations, idle }: { locations: readonly Location[]; idle: boolean }) {
  const [open, setOpen] = useState(false);
  const [corners, setCorners] = useState({ first: "", rowEnd: "", columnEnd: "" });
  const [along, setAlong] = useState(3), [across, setAcross] = useState(3), [name, setName] = useState("PALLET"), [done, setDone] = useState<number>();
  if (!open) return <Button className="button" onPress={() => setOpen(true)}><Symbol name="palletize" size={18} />{t("pallet.open")}</Button>;
  const poseOf = (corner: string) => locations.find((each) => each.location === corner)?.pose as Pose | undefined;
  const [first, rowEnd, columnEnd] = [poseOf(corners.first), poseOf(corners.rowEnd), poseOf(corners.columnEnd)];
  const pallet = first && rowEnd && columnEnd && { first, rowEnd, columnEnd, along, across };
  const wrong = pallet && wrongCorners(pallet);
  const teach = async () => {
    if (!pallet) return;
    const places = placesOf(pallet);
    for (const [i, pose] of places.entries()) {
      setDone(i);
      const row = Math.floor(i / along) + 1, column = (i % along) + 1;
      if (!(await ask("locations.teach", { location: `${name}_${row}_${column}`, pose: [...pose] }))) return setDone(undefined);
    }
    setDone(undefined);
    setOpen(false);
    notice("done", t("pallet.done", { count: places.length, name }));
  };
  const options = locations.map((each) => ({ id: each.location, name: each.location }));
  return (
    <section className="pallet">
      <h3 className="section-title">{t("pallet.title")}</h3>
      <p className="hint">{t("pallet.hint")}</p>
      <div className="pallet-fields">
        {(["first", "rowEnd", "columnEnd"] as const).map((each) => <Choose key={each} label={t(`pallet.${each}`)} value={corners[each]} onChange={(value) => setCorners({ ...corners, [each]: value })} options={options} />)}
        <NumberBox label={t("pallet.along")} value={along} whole low={1} high={20} onChange={(now) => now !== undefined && setAlong(now)} />
        <NumberBox label={t("pallet.across")} value={across} whole low={1} high={20} onChange={(now) => now !== undefined && setAcross(now)} />
        <TextBox label={t("pallet.name")} value={name} onChange={(now) => setName(now.toUpperCase())} hint={t("pallet.names", { first: `${name}_1_1`, last: `${name}_${across}_${along}` })} />
      </div>
      {wrong && <p className="refusal" role="alert"><Symbol name="error" size={14} />{t(`pallet.${wrong}`)}</p>}
      <div className="chips">
        <Button className="button primary" isDisabled={!idle || !pallet || wrong !== undefined || name === "" || done !== undefined} onPress={() => void teach()}>{done === undefined ? t("pallet.teach", { count: along * across }) : t("aside.done", { of: done, all: along * across })}</Button>
        <Button className="button" onPress={() => setOpen(false)}>{t("keep.cancel")}</Button>
      </div>
    </section>
  );
}
