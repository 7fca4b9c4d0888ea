// The licences of all packages that the page contains, in one text that is shipped with it.
import { existsSync, readFileSync, readdirSync } from "node:fs";
import { join } from "node:path";

export function licences(root) {
  const lock = JSON.parse(readFileSync(join(root, "package-lock.json"), "utf8"));
  const parts = [];
  for (const [path, each] of Object.entries(lock.packages)) {
    if (path === "" || each.dev || !existsSync(join(root, path))) continue;
    const file = readdirSync(join(root, path)).find((name) => /^licen[sc]e/i.test(name));
    const text = file ? readFileSync(join(root, path, file), "utf8").trim() : `Licence: ${each.license}`;
    parts.push(`${path.replace(/^.*node_modules\//, "")} ${each.version} (${each.license})\n\n${text}\n`);
  }
  return parts.join("\n" + "-".repeat(80) + "\n\n");
}
