// Random drawings and random edits, from a seed that a failing test prints.
import { newIcon, addIcon, changeIcon, connect, moveIcons, removeIcons, renameIcon, setField } from "../../src/model/edit";
import { empty, operationsOf, withOperation, type Drawing, type Kind, type Operation } from "../../src/model/operation";
import { outputs } from "../../src/model/ports";

export type Random = (below: number) => number;

export function randomOf(seed: number): Random {
  let state = seed >>> 0;
  return (below) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor((state / 2 ** 32) * below);
  };
}

const kinds: Kind[] = ["skill", "case", "merge", "delay", "wait", "test", "question", "zero", "restart", "exit"];
const skills = ["touch", "rub", "press", "relative-move", "move-to-location"];

function anyIcon(random: Random, id: string) {
  const kind = kinds[random(kinds.length)]!;
  const more = kind === "skill" ? { skill: skills[random(skills.length)]! } : kind === "wait" || kind === "test" ? { sensor: "force-z" } : kind === "question" ? { text: "“Go on?” \\ \u00e9", answers: [{ text: "yes\n" }, { text: "\t" }] } : {};
  return newIcon(kind, id, [random(900) - 300, random(400) / 2], more);
}

export function randomEdit(random: Random, operation: Operation): Operation {
  const pick = () => operation.icons[random(operation.icons.length)];
  switch (random(7)) {
    case 0: case 1: return addIcon(operation, anyIcon(random, `icon-${operation.icons.length}-${random(1000)}`));
    case 2: {
      const from = pick(), to = pick();
      const ports = from ? outputs(from) : [];
      return from && to && to.kind !== "start" && ports.length > 0 ? connect(operation, from.id, ports[random(ports.length)]!.name, to.id) : operation;
    }
    case 3: { const icon = pick(); return icon ? moveIcons(operation, new Map([[icon.id, [random(500), random(500)]]])) : operation; }
    case 4: { const icon = pick(); return icon && operation.icons.length > 4 ? removeIcons(operation, new Set([icon.id])) : operation; }
    case 5: { const icon = pick(); return icon ? renameIcon(operation, icon.id, `named-${random(20)}`) : operation; }
    default: { const icon = pick(); return icon ? changeIcon(operation, icon.id, (each) => setField(each, "note", random(2) ? `note ${random(9)} é "x" \\` : undefined)) : operation; }
  }
}

export function randomDrawing(random: Random): Drawing {
  let drawing = withOperation(empty("random"), "random", addIcon({ name: "random", icons: [] }, newIcon("start", "start", [0, 0])));
  for (let i = 0; i < 12 + random(20); ++i) {
    const operation = operationsOf(drawing)[0]!;
    drawing = withOperation(drawing, "random", randomEdit(random, operation));
  }
  return drawing;
}
