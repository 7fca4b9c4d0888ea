// Templates of skills, read from their PAL by patterns: enough for tests that need no server.
import { readdirSync, readFileSync, existsSync } from "node:fs";
import { join } from "node:path";
import type { Skill } from "../../generated/protocol";

const texts = (block: string, word: string): string[] =>
  [...(new RegExp(`^ *${word}((?:\\s+"[^"]*")+)`, "m").exec(block)?.[1] ?? "").matchAll(/"([^"]*)"/g)].map((each) => each[1]!);

export function templates(folder: string): Skill[] {
  const skills: Skill[] = [];
  for (const each of readdirSync(folder, { withFileTypes: true })) {
    const file = join(folder, each.name, `${each.name}.pal`);
    if (!each.isDirectory() || !existsSync(file)) continue;
    const block = /^SKILL (\S+)\n([\s\S]*?)^END SKILL/m.exec(readFileSync(file, "utf8"));
    if (!block) continue;
    const [, skill, body] = block as unknown as [string, string, string];
    const parameters = [...body.matchAll(/PARAMETER (\S+)\s*:\s*(REAL|INTEGER|BOOLEAN|TEXT|LOCATION)\s*(\S*?)\s*DEFAULT\s+("[^"]*"|\S+)(?:\s+RANGE\s+(\S+)\s+TO\s+(\S+))?\s+"([^"]*)"/g)].map((p) => ({
      name: p[1]!, type: (p[2] === "LOCATION" ? "text" : p[2]!.toLowerCase()) as "real", unit: p[3]!, description: p[7]!, location: p[2] === "LOCATION",
      default: p[2] === "BOOLEAN" ? p[4] === "TRUE" : p[2] === "TEXT" || p[2] === "LOCATION" ? p[4]!.replaceAll('"', "") : Number(p[4]),
      ...(p[5] === undefined ? {} : { low: Number(p[5]), high: Number(p[6]) }),
    }));
    const completions = [...body.matchAll(/COMPLETION (\d+)\s+(NORMAL|CONTINGENCY|ERROR)(?:\s+(\d+))?\s+"([^"]*)"/g)].map((c) => ({
      code: Number(c[1]), kind: c[2]!.toLowerCase() as "normal", description: c[4]!, longest_s: null }));
    skills.push({
      skill, description: texts(body, "DESCRIPTION")[0] ?? "", descriptions: texts(body, "DESCRIPTION"), preconditions: texts(body, "PRECONDITION"),
      postconditions: texts(body, "POSTCONDITION"), model_data: [], parameters, completions, contingencies: [], requirements: [], environment: "workcell", pictures: [],
      tool: /pick|place|pallet/.test(skill) ? "gripper" : /standoff|align|edge/.test(skill) ? "range-finder" : "", able: true, unable: "", by_hand: skill === "jog",
    });
  }
  return skills;
}
