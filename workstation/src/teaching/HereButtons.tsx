// At a field that names a location: the place where the robot is now, and the window of all.
import { Button } from "react-aria-components";
import { ask } from "../state/acts";
import { useCell } from "../state/cell";
import { openWindow } from "../state/windows";
import { Symbol } from "../symbols/Symbol";
import { t } from "../words/words";
import { freeLocation } from "./places";

export function HereButtons({ name, onTaught }: { name: string; onTaught(location: string): void }) {
  const locations = useCell((cell) => cell.locations);
  const idle = useCell((cell) => cell.link === "ready" && cell.present?.snapshot.activity === "idle");
  const here = async () => {
    const taught = await ask("locations.teach", { location: freeLocation(locations ?? []), based_on: 0 });
    if (taught) onTaught(taught.location);
  };
  return (
    <div className="here-buttons">
      <Button className="button small" isDisabled={!idle} aria-label={t("teach.hereFor", { name })} onPress={() => void here()}><Symbol name="target" size={14} />{t("teach.hereButton")}</Button>
      <Button className="button quiet small" onPress={() => openWindow("locations")}>{t("teach.open")}</Button>
    </div>
  );
}
