// From the operation to what React Flow draws. A node whose icon did not change stays the same object.
import { Position, type NodeHandle } from "@xyflow/react";
import type { Skill } from "../../generated/protocol";
import type { Icon, Operation, Point } from "../model/operation";
import { hasInput, reached } from "../model/ports";
import { familyOf } from "./family";
import type { IconNodeType } from "./IconNode";
import { inputSpot, outputSpots } from "./ports";
import { sizeOf } from "./shape";

interface Kept {
  icon: Icon;
  reached: boolean;
  selected: boolean;
  at: Point | undefined;
  prefix: string;
  skill: Skill | undefined;
  node: IconNodeType;
}

const dot = 14;

function handles(icon: Icon, skill: Skill | undefined): NodeHandle[] {
  const family = familyOf(icon, skill);
  const of = (spot: { name: string; x: number; y: number }, type: "source" | "target"): NodeHandle => ({
    id: spot.name, type, position: type === "source" ? Position.Right : Position.Left,
    x: spot.x - dot / 2, y: spot.y - dot / 2, width: dot, height: dot,
  });
  return [...(hasInput(icon) ? [of(inputSpot(icon, family), "target")] : []), ...outputSpots(icon, family).map((spot) => of(spot, "source"))];
}

export class FlowNodes {
  #kept = new Map<string, Kept>();

  of(operation: Operation, prefix: string, selected: ReadonlySet<string>, dragged: ReadonlyMap<string, Point>, skills: ReadonlyMap<string, Skill>): IconNodeType[] {
    const reachable = reached(operation);
    const kept = new Map<string, Kept>();
    const nodes = operation.icons.map((icon) => {
      const now = { icon, reached: reachable.has(icon.id), selected: selected.has(icon.id), at: dragged.get(icon.id), prefix, skill: skills.get(icon.skill ?? "") };
      const old = this.#kept.get(icon.id);
      const same = old && old.icon === icon && old.reached === now.reached && old.selected === now.selected && old.at === now.at && old.prefix === prefix && old.skill === now.skill;
      const node = same ? old.node : this.#node(operation, now, old?.node);
      kept.set(icon.id, { ...now, node });
      return node;
    });
    this.#kept = kept;
    return nodes;
  }

  #node(operation: Operation, { icon, reached: isReached, selected, at, prefix, skill }: Omit<Kept, "node">, old: IconNodeType | undefined): IconNodeType {
    const size = sizeOf(icon);
    const [x, y] = at ?? icon.at ?? [0, 0];
    const unchanged = old && old.data.icon === icon && old.data.reached === isReached && old.data.path === prefix + icon.id;
    return {
      id: icon.id,
      type: "icon",
      position: { x, y },
      data: unchanged ? old.data : { icon, operation: operation.name, path: prefix + icon.id, reached: isReached },
      selected,
      width: size.width,
      height: size.height,
      measured: size,
      handles: handles(icon, skill),
    };
  }
}
