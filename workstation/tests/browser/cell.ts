// A real `workcell serve` for a test, in a folder of its own, with the page that was built.
import { spawn, type ChildProcess } from "node:child_process";
import { mkdtempSync, readdirSync, readFileSync, rmSync, existsSync, mkdirSync } from "node:fs";
import { createServer } from "node:net";
import { after } from "node:test";
import { tmpdir } from "node:os";
import { join } from "node:path";

export interface Cell {
  address: string;
  token: string;
  folder: string;
  url: string;
  port: number;
  pid: number;
  /** What the simulation has used of the processor, in seconds. */
  processorTime(): number;
  /** What all of its threads have used. */
  allProcessorTime(): number;
  /** Its own end, as when the machine fails. */
  kill(): Promise<void>;
  end(): Promise<void>;
}

/** Cells that run: one that its test did not reach to end would keep the program of the tests alive. */
const running = new Set<Cell>();
after(async () => {
  for (const each of running) await each.end();
});

const sleep = (ms: number) => new Promise((resolve) => setTimeout(resolve, ms));

export async function freePort(): Promise<number> {
  const probe = createServer();
  await new Promise<void>((resolve) => probe.listen(0, "127.0.0.1", resolve));
  const { port } = probe.address() as { port: number };
  await new Promise((resolve) => probe.close(resolve));
  return port;
}

async function announced(file: string, child: ChildProcess, said: () => string): Promise<{ port: number; token: string }> {
  for (let i = 0; i < 400; ++i) {
    if (child.exitCode !== null) throw new Error(`workcell ended with ${child.exitCode}: ${said()}`);
    if (existsSync(file)) {
      try {
        return JSON.parse(readFileSync(file, "utf8"));
      } catch {
        // It is being written.
      }
    }
    await sleep(25);
  }
  throw new Error(`workcell announces nothing: ${said()}`);
}

/** `again`: the folder of a cell that has ended, whose store is there. */
export async function cell(scene: string, options: readonly string[] = ["--fast"], again?: { folder: string; port: number }): Promise<Cell> {
  const folder = again?.folder ?? mkdtempSync(join(tmpdir(), "workstation-"));
  const port = again?.port ?? (await freePort());
  const store = join(folder, "store"), file = join(folder, "workcell.json");
  mkdirSync(store, { recursive: true });
  rmSync(file, { force: true });
  let text = "";
  const child = spawn(process.env.WORKCELL!, ["serve", "--scene", scene, "--port", String(port), "--announce", file, "--store", store, "--page", process.env.WORKSTATION_PAGE!, ...options],
    { stdio: ["ignore", "pipe", "pipe"], cwd: join(process.env.WORKSTATION!, "..") });
  for (const stream of [child.stdout, child.stderr]) stream.on("data", (data: Buffer) => (text += data.toString()));
  const gone = new Promise<void>((resolve) => child.on("exit", () => resolve()));
  const { token } = await announced(file, child, () => text);
  const address = `http://127.0.0.1:${port}`;
  const made: Cell = {
    processorTime: () => {
      // Its first thread is the cell's own; others prove skills and serve clients.
      return Number(readFileSync(`/proc/${child.pid}/task/${child.pid}/schedstat`, "utf8").split(" ")[0]) / 1e9;
    },
    allProcessorTime: () => readdirSync(`/proc/${child.pid}/task`).reduce((sum, each) => sum + Number(readFileSync(`/proc/${child.pid}/task/${each}/schedstat`, "utf8").split(" ")[0]), 0) / 1e9,
    pid: child.pid!, address, token, folder, port, url: `${address}/#token=${token}`,
    kill: async () => (child.kill("SIGKILL"), gone),
    end: async () => {
      running.delete(made);
      // An orderly end waits for the proof or the drawing that is being made; tests of the server show it, and nobody needs it here.
      child.kill("SIGKILL");
      await gone;
      rmSync(folder, { recursive: true, force: true });
    },
  };
  running.add(made);
  return made;
}
