// An icon in small, as the palette shows it: the outline of its family with its symbol.
import { outline, type Family } from "../canvas/shape";
import type { SymbolName } from "../symbols/drawings";
import { Symbol } from "../symbols/Symbol";

export function Miniature({ family, symbol }: { family: Family; symbol: SymbolName }) {
  const size = { width: 40, height: 28 };
  return (
    <span className="miniature" data-family={family}>
      <svg width={size.width + 4} height={size.height + 4} viewBox="-1 -1 44 32" aria-hidden="true">
        {family === "super" && <path className="behind" d={outline(family, size)} transform="translate(2.5 2.5)" />}
        <path className="shape" d={small(family, size)} />
      </svg>
      <Symbol name={symbol} size={18} />
    </span>
  );
}

/** The slants of an outline are in pixels; in small they are half as long. */
function small(family: Family, { width: w, height: h }: { width: number; height: number }): string {
  if (family === "move") return `M3 0H${w - 8}L${w} ${h / 2}L${w - 8} ${h}H3Q0 ${h} 0 ${h - 3}V3Q0 0 3 0Z`;
  if (family === "grip") return `M6 0H${w - 6}L${w} 6V${h - 6}L${w - 6} ${h}H6L0 ${h - 6}V6Z`;
  if (family === "flow") return `M6 0H${w}V${h - 6}L${w - 6} ${h}H0V6Z`;
  return outline(family, { width: w, height: h });
}
