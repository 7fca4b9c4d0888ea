// To which family an icon belongs, and its symbol. The twelve skills are known by name; another skill is told by its
// template: what it grips with, whether it takes forces.
import type { Skill } from "../../generated/protocol";
import type { Icon } from "../model/operation";
import { hasSymbol, type SymbolName } from "../symbols/drawings";
import type { Family } from "./shape";

const known: Record<string, Family> = {
  "move-to-location": "move", "move-cartesian": "move", "relative-move": "move", jog: "move",
  touch: "sense", press: "sense", rub: "sense", standoff: "sense", align: "sense", "follow-edge": "sense",
  "pick-at-location": "grip", "place-at-location": "grip", palletize: "grip",
};

export function familyOfSkill(name: string, skill: Skill | undefined): Family {
  const family = known[name];
  if (family) return family;
  if (!skill) return "other";
  if (skill.tool.includes("gripper")) return "grip";
  if (skill.tool !== "" || skill.parameters.some((each) => /^(N|count|N\/mm)$/.test(each.unit))) return "sense";
  return "move";
}

export function familyOf(icon: Icon, skill: Skill | undefined): Family {
  switch (icon.kind) {
    case "skill": return familyOfSkill(icon.skill ?? "", skill);
    case "operation": return "super";
    case "start": case "exit": case "restart": return "end";
    case "case": case "merge": case "question": case "planned": return "other";
    default: return "flow";
  }
}

export function symbolOfSkill(name: string, family: Family): SymbolName {
  if (hasSymbol(name)) return name;
  return family === "move" || family === "sense" || family === "grip" ? family : "skill";
}

export function symbolOf(icon: Icon, family: Family): SymbolName {
  if (icon.kind === "skill") return symbolOfSkill(icon.skill ?? "", family);
  return icon.kind;
}
