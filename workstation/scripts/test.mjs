// Runs tests, or prints the figures: test.mjs unit|browser|long|figures [--page FOLDER] [--workcell PROGRAM] [--only NAME] [FILTER]. FILTER
// chooses files, --only tests by their names. They are bundled first, so that Node 18, which reads no TypeScript, runs them.
import { buildSync } from "esbuild";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readdirSync, rmSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "..");
const [kind, ...rest] = process.argv.slice(2);
const option = (name) => (rest.includes(name) ? rest[rest.indexOf(name) + 1] : undefined);
const filter = rest.find((each, i) => !each.startsWith("--") && !rest[i - 1]?.startsWith("--"));
const files = readdirSync(join(root, "tests", kind)).filter((each) => each.endsWith(".test.ts") && (!filter || each.includes(filter)));
const out = mkdtempSync(join(root, "node_modules", ".tests-"));
try {
  buildSync({
    absWorkingDir: root, entryPoints: files.map((each) => join("tests", kind, each)), outdir: out, bundle: true, format: "esm", platform: "node", target: "node18",
    packages: "external", outExtension: { ".js": ".mjs" }, define: { "import.meta.dirname": JSON.stringify(root) }, logLevel: "warning", jsx: "automatic", loader: { ".css": "empty", ".woff2": "empty" },
  });
  const environment = { ...process.env, WORKSTATION: root, WORKSTATION_PAGE: option("--page") ?? join(root, "../build/release/share/pal/workstation"), WORKCELL: option("--workcell") ?? join(root, "../build/release/bin/workcell") };
  const run = spawnSync(process.execPath, ["--test", "--test-concurrency=1", ...(option("--only") ? [`--test-name-pattern=${option("--only")}`] : []), ...files.map((each) => join(out, each.replace(/\.ts$/, ".mjs")))], { stdio: "inherit", env: environment });
  process.exitCode = run.status ?? 1;
} finally {
  rmSync(out, { recursive: true });
}
