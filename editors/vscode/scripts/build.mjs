// Builds the extension into out: one file for the editor, one script and a style sheet for the pictures' page, and the
// licences of the packages that are in them.
import { buildSync } from "esbuild";
import { copyFileSync, existsSync, readFileSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";

const root = join(dirname(fileURLToPath(import.meta.url)), "..");
rmSync(join(root, "out"), { recursive: true, force: true });
const shared = { absWorkingDir: root, outdir: "out", bundle: true, minify: true, legalComments: "none", logLevel: "warning", metafile: true };
const built = buildSync({ ...shared, entryPoints: ["src/extension.ts"], format: "cjs", platform: "node", target: "node18", external: ["vscode"] });
buildSync({ ...shared, entryPoints: ["webview/picture.ts"], format: "iife", platform: "browser", target: "es2022", loader: { ".css": "text" } });
copyFileSync(join(root, "webview/picture.css"), join(root, "out/picture.css"));

const packages = new Set(Object.keys(built.metafile.inputs).flatMap((each) => /^.*node_modules\/(?:@[^/]+\/)?[^/]+/.exec(each)?.[0] ?? []));
const texts = [...packages].sort().map((each) => {
  const { name, version, license } = JSON.parse(readFileSync(join(root, each, "package.json"), "utf8"));
  const file = readdirSync(join(root, each)).find((one) => /^licen[sc]e/i.test(one));
  return `${name} ${version} (${license})\n\n${file !== undefined && existsSync(join(root, each, file)) ? readFileSync(join(root, each, file), "utf8").trim() : ""}\n`;
});
writeFileSync(join(root, "out/LICENSES.txt"), texts.join(`\n${"-".repeat(80)}\n\n`));
