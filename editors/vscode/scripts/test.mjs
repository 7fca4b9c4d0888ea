// Runs the light tests: test.mjs PAL SOURCE_DIR. They are bundled first, so that Node 18, which reads no TypeScript, runs them.
import { buildSync } from "esbuild";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readdirSync, rmSync } from "node:fs";
import { dirname, join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "..");
const [pal = join(root, "../../build/release/bin/pal"), source = join(root, "../..")] = process.argv.slice(2);
const files = readdirSync(join(root, "tests")).filter((each) => each.endsWith(".test.ts"));
const out = mkdtempSync(join(root, "node_modules", ".tests-"));
try {
  buildSync({ absWorkingDir: root, entryPoints: files.map((each) => join("tests", each)), outdir: out, bundle: true, format: "cjs", platform: "node", target: "node18", packages: "external", outExtension: { ".js": ".cjs" }, logLevel: "warning" });
  const environment = { ...process.env, EXTENSION: root, PAL: resolve(pal), SOURCE: resolve(source) };
  const run = spawnSync(process.execPath, ["--test", "--test-concurrency=1", ...files.map((each) => join(out, each.replace(/\.ts$/, ".cjs")))], { stdio: "inherit", env: environment });
  process.exitCode = run.status ?? 1;
} finally {
  rmSync(out, { recursive: true });
}
