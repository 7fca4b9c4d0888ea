// All sensors that tests and waits can read: what each showed last, when, and how it changed.
import { useEffect, useState } from "react";
import { Button } from "react-aria-components";
import type { Sensor } from "../../generated/protocol";
import { ask } from "../state/acts";
import { call, onEvent, useCell } from "../state/cell";
import { Symbol } from "../symbols/Symbol";
import { number, t, unitText } from "../words/words";
import { useSteps, type Acted } from "./steps";

export default function Sensors() {
  const [sensors, setSensors] = useState<readonly Sensor[]>(useCell.getState().sensors);
  const steps = useSteps((state) => state.steps);
  const idle = useCell((state) => state.present?.snapshot.activity === "idle");
  useEffect(() => {
    let current = true;
    const read = () => void call("sensors").then((all) => current && setSensors(all), () => {});
    read();
    const stop = onEvent((event) => event.event === "ends" && event.sensor && read());
    return () => {
      current = false;
      stop();
    };
  }, []);
  const look = async (sensor: string) => {
    if (await ask("sensor.read", { sensor })) setSensors(await call("sensors"));
  };
  if (sensors.length === 0) return <p className="nothing">{t("sensors.none")}</p>;
  return (
    <ul className="sensors">
      {sensors.map((each) => (
        <li key={each.sensor}>
          <div className="sensor-head">
            <b>{each.sensor}</b>
            <span className="sensor-value">{typeof each.value === "number" ? <>{shown(each, each.value)} <small>{unitText(each.unit)}</small></> : "–"}</span>
            <Button className="button quiet only" aria-label={t("sensors.read", { name: each.sensor })} isDisabled={!idle} onPress={() => void look(each.sensor)}><Symbol name="restart" size={18} /></Button>
          </div>
          <Range sensor={each} />
          <p className="hint">{each.description}{each.time_s !== undefined && ` · ${t("sensors.when", { time: number(each.time_s, 2) })}`}</p>
          <Readings steps={steps.filter((one) => one.sensor === each.sensor && one.reading !== undefined)} sensor={each} />
        </li>
      ))}
    </ul>
  );
}

/** A value to a ten-thousandth of the sensor's range: more digits would be noise. */
function shown({ low, high }: Sensor, value: number): string {
  if (low === undefined || high === undefined || high <= low) return number(Number(value.toPrecision(5)));
  return number(value, Math.max(0, 4 - Math.floor(Math.log10(high - low))));
}

/** Where in its range the value lies. */
function Range({ sensor: { low, high, value, unit } }: { sensor: Sensor }) {
  if (low === undefined || high === undefined || high <= low) return null;
  return (
    <div className="sensor-range">
      <span>{number(low)}</span>
      <span className="sensor-bar">{typeof value === "number" && <i style={{ left: `${Math.min(100, Math.max(0, ((value - low) / (high - low)) * 100))}%` }} />}</span>
      <span>{number(high)} {unitText(unit)}</span>
    </div>
  );
}

/** The last readings of waits and tests, one after the other. */
function Readings({ steps, sensor }: { steps: readonly Acted[]; sensor: Sensor }) {
  if (steps.length === 0) return null;
  return (
    <ol className="sensor-readings">
      {steps.slice(-5).map((each) => <li key={each.begin}><span>{each.icon}</span><span>{number(each.begin, 2)} s</span><b>{shown(sensor, each.reading!)} {unitText(sensor.unit)}</b></li>)}
    </ol>
  );
}
