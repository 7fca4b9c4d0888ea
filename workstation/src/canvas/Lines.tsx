// All lines of the operation in one drawing below the icons.
import { ViewportPortal } from "@xyflow/react";
import { memo, useMemo, useRef } from "react";
import type { Operation, Point } from "../model/operation";
import { iconOf } from "../model/operation";
import { lines, reached, type Line } from "../model/ports";
import { useCell } from "../state/cell";
import { useDrawing } from "../state/drawing";
import { t } from "../words/words";
import { portText } from "./describe";
import { familyOf } from "./family";
import { inputSpot, outputSpots } from "./ports";
import { pathOf, type Rect, type XY } from "./routing/geometry";
import { Router, type Wanted } from "./routing/router";
import { isLoaded } from "./runState";
import { sizeOf } from "./shape";
import { useView } from "./view";

const captionHeight = 20;

function useRoutes(operation: Operation, dragged: ReadonlyMap<string, Point>) {
  const skills = useCell((state) => state.skills);
  const router = useRef<Router>(undefined);
  return useMemo(() => {
    router.current ??= new Router();
    const boxes = new Map<string, Rect>();
    const spots = new Map<string, XY>();
    for (const icon of operation.icons) {
      const [x, y] = dragged.get(icon.id) ?? icon.at ?? [0, 0];
      const { width, height } = sizeOf(icon);
      const captioned = height === 56 ? captionHeight : 0;
      boxes.set(icon.id, { left: x, top: y, right: x + width, bottom: y + height + captioned });
      const family = familyOf(icon, skills.get(icon.skill ?? ""));
      const input = inputSpot(icon, family);
      spots.set(`${icon.id}/in`, { x: x + input.x, y: y + input.y });
      for (const spot of outputSpots(icon, family)) spots.set(`${icon.id}/${spot.name}`, { x: x + spot.x, y: y + spot.y });
    }
    const all = lines(operation).filter((line) => boxes.has(line.to) && spots.has(`${line.from}/${line.port}`));
    const wanted: Wanted[] = all.map((line) => ({
      key: keyOf(line), group: line.to, from: spots.get(`${line.from}/${line.port}`)!, to: spots.get(`${line.to}/in`)!,
    }));
    const routes = router.current.routes(wanted, boxes, new Set(dragged.keys()));
    return all.map((line) => ({ line, d: pathOf(routes.get(keyOf(line))!) }));
  }, [operation, dragged, skills]);
}

const keyOf = (line: Line) => `${line.from}/${line.port}`;

export function Lines({ operation, prefix }: { operation: Operation; prefix: string }) {
  const dragged = useView((state) => state.dragged);
  const chosen = useView((state) => state.line);
  const routes = useRoutes(operation, dragged);
  const live = useMemo(() => reached(operation), [operation]);
  return (
    <ViewportPortal>
      <svg className="lines" aria-hidden="true">
        {routes.map(({ line, d }) => (
          <LinePath key={keyOf(line)} line={line} d={d} operation={operation} prefix={prefix} loose={!live.has(line.from)}
            chosen={chosen?.from === line.from && chosen.port === line.port} />
        ))}
      </svg>
    </ViewportPortal>
  );
}

interface PathProps {
  line: Line;
  d: string;
  operation: Operation;
  prefix: string;
  loose: boolean;
  chosen: boolean;
}

const LinePath = memo(function LinePath({ line, d, operation, prefix, loose, chosen }: PathProps) {
  const name = useDrawing((state) => state.drawing.name);
  const taken = useCell((cell) => isLoaded(cell, name) && (cell.present?.taken.has(`${prefix}${line.from}>${prefix}${line.to}`) ?? false));
  const from = iconOf(operation, line.from);
  const end = /([\d.-]+) ([\d.-]+)$/.exec(d);
  return (
    <g className="line" data-port={line.port.split(":")[0]} data-taken={taken || undefined} data-loose={loose || undefined} data-chosen={chosen || undefined}
      data-line={`${line.from}>${line.to}`}>
      <path className="reach" d={d} onClick={(event) => (event.stopPropagation(), useView.setState({ line: { from: line.from, port: line.port } }))}>
        <title>{from ? t("line.title", { from: line.from, port: portText(from, line.port), to: line.to }) : ""}</title>
      </path>
      <path className="stroke" d={d} />
      {end && <path className="head" d="M-13 -4.5L-6 0L-13 4.5" transform={`translate(${end[1]} ${end[2]})`} />}
    </g>
  );
});
