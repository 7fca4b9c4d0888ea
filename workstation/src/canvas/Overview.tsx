// The overview map at the canvas's corner: what acts and what has failed is seen there, too.
import { MiniMap, type MiniMapNodeProps } from "@xyflow/react";
import { useDrawing } from "../state/drawing";
import { t } from "../words/words";
import type { IconNodeType } from "./IconNode";
import { useRunState } from "./runState";

export function Overview() {
  return (
    <MiniMap<IconNodeType> pannable zoomable ariaLabel={t("canvas.overview")} nodeComponent={MapIcon} maskColor="var(--map-mask)" bgColor="var(--surface)" style={{ width: 176, height: 112 }} />
  );
}

function MapIcon({ id, x, y, width, height, selected }: MiniMapNodeProps) {
  const prefix = useDrawing((state) => (state.trail.length > 0 ? `${state.trail.join("/")}/` : ""));
  const run = useRunState(prefix + id);
  const colour = run === "failed" ? "var(--error)" : run === "acting" || run === "halted" || selected ? "var(--accent)" : "var(--edge-strong)";
  return <rect x={x} y={y} width={width} height={height} rx={8} fill={colour} />;
}
