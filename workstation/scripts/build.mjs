// Builds the page: build.mjs --out FOLDER [--watch]. Names have the hash of what is in them, so that a browser
// may keep them; index.html alone is asked for again.
import { build, context } from "esbuild";
import { copyFileSync, mkdirSync, readFileSync, readdirSync, rmSync, writeFileSync, existsSync } from "node:fs";
import { dirname, join, relative } from "node:path";
import { fileURLToPath } from "node:url";
import { licences } from "./licences.mjs";

const root = join(dirname(fileURLToPath(import.meta.url)), "..");
const option = (name) => {
  const at = process.argv.indexOf(name);
  return at < 0 ? undefined : process.argv[at + 1];
};
const out = option("--out") ?? join(root, "../build/workstation");
const watch = process.argv.includes("--watch");

function page(metafile) {
  const outputs = Object.entries(metafile.outputs);
  const made = (source) => outputs.find(([, each]) => each.entryPoint?.endsWith(source));
  const name = (path) => relative(out, join(root, path)).replaceAll("\\", "/");
  const needs = ([path, each]) => [path, ...each.imports.filter((one) => one.kind === "import-statement").map((one) => one.path)];
  const start = made("start.ts"), main = made("main.tsx");
  const first = [...new Set([...needs(start), ...needs(main)])];
  const font = outputs.map(([path]) => path).find((path) => path.includes("inter-latin-wght"));
  const html = readFileSync(join(root, "src/index.html"), "utf8")
    .replace("<!-- style -->", `<link rel="stylesheet" href="${name(main[1].cssBundle)}">`)
    .replace("<!-- script -->", first.slice(1).map((each) => `<link rel="modulepreload" href="${name(each)}">`).join("\n  ") +
      `\n  <link rel="preload" as="font" type="font/woff2" href="${name(font)}" crossorigin>` +
      `\n  <script type="module" src="${name(start[0])}"></script>`);
  writeFileSync(join(out, "index.html"), html);
  // The style of all that start.ts leads to: the same text once more.
  rmSync(join(root, start[1].cssBundle));
  copyFileSync(join(root, "src/look/icon.svg"), join(out, "icon.svg"));
  writeFileSync(join(out, "LICENSES.txt"), licences(root));
}

/** `import address from "./x?address"`: the script of a thread of its own is a file of its own, and this is its address. */
const workers = {
  name: "workers",
  setup(it) {
    it.onResolve({ filter: /\?address$/ }, ({ path, resolveDir }) => ({ path: join(resolveDir, `${path.slice(0, -"?address".length)}.ts`), namespace: "worker" }));
    it.onLoad({ filter: /.*/, namespace: "worker" }, async ({ path }) => {
      const { metafile } = await build({ ...options, entryPoints: [path], splitting: false, plugins: [] });
      const [file] = Object.entries(metafile.outputs).find(([, each]) => each.entryPoint);
      return {
        contents: `export default new URL(${JSON.stringify(`./${relative(out, join(root, file)).replaceAll("\\", "/")}`)}, import.meta.url).href`,
        watchFiles: Object.keys(metafile.inputs).map((each) => join(root, each)),
      };
    });
  },
};

const options = {
  absWorkingDir: root,
  entryPoints: ["src/start.ts", "src/main.tsx"],
  outdir: out,
  bundle: true,
  splitting: true,
  format: "esm",
  target: "es2022",
  minify: !watch,
  sourcemap: watch,
  jsx: "automatic",
  entryNames: "[name]-[hash]",
  chunkNames: "[name]-[hash]",
  assetNames: "[name]-[hash]",
  loader: { ".woff2": "file" },
  metafile: true,
  legalComments: "none",
  define: { "process.env.NODE_ENV": watch ? '"development"' : '"production"' },
  plugins: [workers, { name: "page", setup: (it) => it.onEnd((result) => result.metafile && page(result.metafile)) }],
};

mkdirSync(out, { recursive: true });
for (const each of readdirSync(out)) if (/-[A-Z0-9]{8}\.(js|css|woff2)(\.map)?$/.test(each)) rmSync(join(out, each));
if (!existsSync(join(root, "generated"))) throw new Error("run `npm run types` first");
if (watch) await (await context(options)).watch();
else await build(options);
