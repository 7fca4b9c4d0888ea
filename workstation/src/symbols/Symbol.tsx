// One symbol of the set, in the colour of its text.
import { memo } from "react";
import { drawings, type SymbolName } from "./drawings";

export const Symbol = memo(function Symbol({ name, size = 20 }: { name: SymbolName; size?: number }) {
  return (
    <svg className="symbol" width={size} height={size} viewBox="0 0 24 24" aria-hidden="true" focusable="false">
      {drawings[name].map((d) => (d.startsWith("!") ? <path key={d} className="filled" d={d.slice(1)} /> : <path key={d} d={d} />))}
    </svg>
  );
});
