// The values of an icon's parameters in the operation that is loaded: read, and set.
import { useEffect, useState } from "react";
import type { Methods, Value } from "../../generated/protocol";
import { ask } from "../state/acts";
import { call, onEvent } from "../state/cell";

/** The values with which an icon runs next, read again when anything is set. */
export function useValues(path: string): Methods["operation.values"]["result"]["parameters"] | undefined {
  const [values, setValues] = useState<Methods["operation.values"]["result"]["parameters"]>();
  useEffect(() => {
    let current = true;
    const read = () => void call("operation.values", { icon: path }).then((result) => current && setValues(result.parameters), () => {});
    read();
    const stopListening = onEvent((event) => (event.event === "set" && event.icon === path) || event.event === "loaded" ? read() : undefined);
    return () => {
      current = false;
      stopListening();
    };
  }, [path]);
  return values;
}

export const set = (icon: string, parameter: string, value: Value): Promise<unknown> => ask("operation.set", { icon, parameter, value });
