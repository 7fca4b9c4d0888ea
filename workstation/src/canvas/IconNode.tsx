// One icon on the canvas: its outline, symbol and words, its connectors, and the marks of what is known of it.
import { Handle, Position, type Node, type NodeProps } from "@xyflow/react";
import { memo } from "react";
import type { Icon } from "../model/operation";
import { hasInput, outputs } from "../model/ports";
import { useCell } from "../state/cell";
import { useDrawing } from "../state/drawing";
import { acted, useReplayed } from "../state/replayed";
import { Symbol } from "../symbols/Symbol";
import { t, useLanguage } from "../words/words";
import { Caption } from "./Caption";
import { CodeRows } from "./CodeRows";
import { describe } from "./describe";
import { familyOf, symbolOf } from "./family";
import { Marks } from "./Marks";
import { inputSpot, outputSpots } from "./ports";
import { useRunState } from "./runState";
import { outline, sizeOf } from "./shape";
import { summary, title } from "./summary";
import { useView } from "./view";

export interface IconData extends Record<string, unknown> {
  icon: Icon;
  operation: string;
  /** As the run names it: "rub-in-square/side-1". */
  path: string;
  reached: boolean;
}
export type IconNodeType = Node<IconData, "icon">;

export const IconNode = memo(function IconNode({ data, selected }: NodeProps<IconNodeType>) {
  useLanguage();
  const { icon, operation, path, reached } = data;
  const skill = useCell((state) => (icon.kind === "skill" ? state.skills.get(icon.skill ?? "") : undefined));
  const sensors = useCell((state) => state.sensors);
  const focused = useDrawing((state) => state.focus === icon.id);
  const run = useRunState(path), replayed = useReplayed((state) => acted(state, path));
  const lineFrom = useView((view) => (view.lineFrom?.icon === icon.id ? view.lineFrom.port : undefined));
  const family = familyOf(icon, skill);
  const size = sizeOf(icon);
  const rows = icon.kind === "case" || icon.kind === "question";
  const line = summary(icon, sensors);
  return (
    <div className="icon" role="group" aria-roledescription={t("icon.role")} aria-label={describe(icon, operation, path)}
      tabIndex={focused ? 0 : -1} data-id={icon.id} data-kind={icon.kind} data-family={family} data-run={run} data-replayed={replayed || undefined}
      data-loose={reached ? undefined : true} data-selected={selected || undefined} style={{ width: size.width, height: size.height }}>
      <svg className="outline" width={size.width} height={size.height} aria-hidden="true">
        {icon.kind === "operation" && <path className="behind" d={outline(family, size)} transform="translate(6 6)" />}
        {icon.kind === "merge"
          ? <circle className="shape" cx="20" cy="20" r="19" />
          : <path className="shape" d={outline(family, size)} />}
        {run === "acting" && icon.kind !== "merge" && <path className="moving" d={outline(family, size)} />}
      </svg>
      <div className="face">
        <span className="tile"><Symbol name={symbolOf(icon, family)} size={icon.kind === "merge" ? 20 : 24} /></span>
        {icon.kind !== "merge" && (
          <span className="words">
            <span className="title">{title(icon)}</span>
            {icon.kind === "exit" && icon.code !== undefined && <span className="code">{String(typeof icon.code === "number" ? icon.code : "…")}</span>}
            {line !== "" && <span className="sub">{line === icon.id ? t(icon.kind === "operation" ? "kind.operation" : "kind.skill") : line}</span>}
          </span>
        )}
      </div>
      {rows && <CodeRows icon={icon} operation={operation} />}
      {hasInput(icon) && <Input icon={icon} family={family} />}
      {outputSpots(icon, family).map((spot, i) => {
        const port = outputs(icon)[i]!;
        return (
          <Handle key={spot.name} type="source" position={Position.Right} id={spot.name} className="connector out"
            data-line-from={lineFrom === spot.name || undefined} data-port={spot.name.split(":")[0]} data-open={port.to === undefined || undefined} style={{ left: spot.x, top: spot.y }} />
        );
      })}
      <Marks icon={icon} operation={operation} path={path} run={run} />
      <Caption icon={icon} operation={operation} path={path} run={run} />
    </div>
  );
});

function Input({ icon, family }: { icon: Icon; family: ReturnType<typeof familyOf> }) {
  const spot = inputSpot(icon, family);
  return <Handle type="target" position={Position.Left} id="in" className="connector in" style={{ left: spot.x, top: spot.y }} />;
}
