// A small server for looking at the page without a cell: it answers what the page asks first, and finds nothing wrong.
// What is called done runs against `workcell serve` (tests/browser).
import { readFileSync } from "node:fs";
import { createServer } from "node:http";
import { extname, join, normalize } from "node:path";
import type { Snapshot } from "../../generated/protocol";
import { templates } from "./templates";
import { accept, type Socket } from "./websocket";

const types: Record<string, string> = { ".html": "text/html; charset=utf-8", ".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml", ".woff2": "font/woff2" };
const policy = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data: blob:; font-src 'self'; connect-src 'self'; base-uri 'none'; form-action 'self'";

export const snapshot = (changed: Partial<Snapshot> = {}): Snapshot => ({
  protocol: 2, version: "0", client: 1, role: "programmer", cell: "touch", activity: "idle", operation: "", state: "ready", token: "", last_code: 0, steps: 0, reason: "",
  controls: "", yours: false, last_event: 0, time_s: 0, epoch: "e1", wall: new Date().toISOString(), pausing: false, stopping: false, running: null, hold: null, question: null, run: 0,
  loaded: null, changed: [], breakpoints: [], icons: [], here: null, clients: [{ client: 1, name: "Chrome", role: "programmer", controls: false, since: new Date().toISOString() }], asking: [], offers: ["store"], ...changed,
});

export interface Fake {
  address: string;
  end(): void;
}

export function fakeServer(page: string, skills: string, token: string, extra: Record<string, (params: never) => unknown> = {}, port = 0): Promise<Fake> {
  const sockets = new Set<Socket>();
  const methods: Record<string, (params: never) => unknown> = {
    hello: (params: { token: string }) => {
      if (params.token !== token) throw { code: 1, message: "no token, or a wrong one", data: { why: "not-admitted", hint: "" } };
      return snapshot();
    },
    snapshot: () => snapshot(),
    watch: () => ({ first_event: 0, complete: true, epoch: "e1" }),
    skills: () => templates(skills),
    sensors: () => [{ sensor: "force-z", unit: "N", description: "pressing is negative" }, { sensor: "delivery", unit: "mm", description: "from a fixed sensor straight down" }],
    "locations.list": () => ["HOME", "HIGH", "LOW"].map((location) => ({ location, pose: null, joints: null, version: 1, changed: null, by: "" })),
    "store.list": () => [{ name: "rub-in-square", version: 3, operation: "rub-a-plate", saved: new Date().toISOString(), by: "Anna", note: "", size: 100 }],
    "operation.check": () => ({ findings: [], errors: 0, warnings: 0, runs: true, complete: true, icons: [], ways: [], all_ways: true, shortest_s: 0, longest_s: null }),
    "operation.format": (params: { text: string }) => ({ text: params.text }),
    ...extra,
  };
  const server = createServer((request, response) => {
    const path = normalize(new URL(request.url ?? "/", "http://x").pathname);
    try {
      const name = path === "/" ? "/index.html" : path;
      const body = readFileSync(join(page, name));
      response.writeHead(200, { "content-type": types[extname(name)] ?? "text/plain", "content-security-policy": policy }).end(body);
    } catch {
      response.writeHead(404).end();
    }
  });
  server.on("upgrade", (request, stream) => {
    const socket = accept(request, stream, (text) => {
      const { id, method, params } = JSON.parse(text);
      try {
        const how = methods[method];
        if (!how) throw { code: -32601, message: "no such method", data: { why: "no-method", hint: "" } };
        socket.send(JSON.stringify({ jsonrpc: "2.0", id, result: how(params as never) }));
      } catch (error) {
        socket.send(JSON.stringify({ jsonrpc: "2.0", id, error }));
      }
    }, () => sockets.delete(socket));
    sockets.add(socket);
  });
  return new Promise((resolve) => server.listen(port, "127.0.0.1", () => {
    const address = `http://127.0.0.1:${(server.address() as { port: number }).port}`;
    resolve({ address, end: () => (sockets.forEach((each) => each.close()), server.close()) });
  }));
}
