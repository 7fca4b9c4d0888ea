// Zoom, tidy, and the trail of the hierarchical icons that one has gone into.
import { Panel, useReactFlow, useStore } from "@xyflow/react";
import { useEffect } from "react";
import { Button, Tooltip, TooltipTrigger } from "react-aria-components";
import { enter, useDrawing } from "../state/drawing";
import { tidy } from "../state/tidy";
import type { SymbolName } from "../symbols/drawings";
import { Symbol } from "../symbols/Symbol";
import { number, t } from "../words/words";

export function Tool({ symbol, text, keys, onPress, disabled = false }: { symbol: SymbolName; text: string; keys?: string; onPress: () => void; disabled?: boolean }) {
  return (
    <TooltipTrigger delay={500}>
      <Button className="button only" aria-label={text} onPress={onPress} isDisabled={disabled}><Symbol name={symbol} /></Button>
      <Tooltip className="tooltip">{text}{keys && <kbd>{keys}</kbd>}</Tooltip>
    </TooltipTrigger>
  );
}

export function CanvasTools() {
  const flow = useReactFlow();
  const zoom = useStore((state) => state.transform[2]);
  const root = useStore((state) => state.domNode);
  // From afar the small words only disturb.
  useEffect(() => void root?.classList.toggle("far", zoom < 0.45), [root, zoom]);
  return (
    <>
      <Trail />
      <Panel position="bottom-left" className="canvas-tools">
        <div className="tool-group">
          <Tool symbol="minus" text={t("canvas.zoomOut")} onPress={() => void flow.zoomOut({ duration: 120 })} />
          <Button className="button zoom" aria-label={t("canvas.zoomFull", { percent: Math.round(zoom * 100) })} onPress={() => void flow.zoomTo(1, { duration: 120 })}>{number(Math.round(zoom * 100))} %</Button>
          <Tool symbol="plus" text={t("canvas.zoomIn")} onPress={() => void flow.zoomIn({ duration: 120 })} />
          <Tool symbol="fit" text={t("canvas.fit")} onPress={() => void flow.fitView({ maxZoom: 1, padding: 0.12, duration: 160 })} />
        </div>
        <div className="tool-group">
          <Tool symbol="tidy" text={t("canvas.tidy")} onPress={() => void tidy().then(() => flow.fitView({ maxZoom: 1, padding: 0.12, duration: 160 }))} />
        </div>
      </Panel>
    </>
  );
}

function Trail() {
  const trail = useDrawing((state) => state.trail);
  const name = useDrawing((state) => state.drawing.name);
  if (trail.length === 0) return null;
  return (
    <nav className="trail" aria-label={t("trail.label")}>
      <ol>
        {[name, ...trail].map((each, i) => (
          <li key={i}>
            {i > 0 && <Symbol name="right" size={16} />}
            {i === trail.length
              ? <span aria-current="page">{each}</span>
              : <Button className="button" onPress={() => enter(trail.slice(0, i), [trail[i]!])}>{each}</Button>}
          </li>
        ))}
      </ol>
    </nav>
  );
}
