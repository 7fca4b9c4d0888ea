// A small client of the language server, for tests.
import { spawn, type ChildProcessWithoutNullStreams } from "node:child_process";

interface Message {
  id?: number | string;
  method?: string;
  result?: unknown;
  error?: { message: string };
}

export class Client {
  private readonly process: ChildProcessWithoutNullStreams;
  private readonly waiting = new Map<number, (message: Message) => void>();
  private read = Buffer.alloc(0);
  private number = 0;

  constructor(pal: string) {
    this.process = spawn(pal, ["language-server"]);
    this.process.stdout.on("data", (bytes: Buffer) => {
      this.read = Buffer.concat([this.read, bytes]);
      for (;;) {
        const head = this.read.indexOf("\r\n\r\n");
        if (head < 0) return;
        const length = Number(/Content-Length: (\d+)/.exec(this.read.subarray(0, head).toString())?.[1]);
        if (this.read.length < head + 4 + length) return;
        const message = JSON.parse(this.read.subarray(head + 4, head + 4 + length).toString()) as Message;
        this.read = this.read.subarray(head + 4 + length);
        if (typeof message.id === "number" && message.method === undefined) this.waiting.get(message.id)?.(message);
      }
    });
  }

  tell(method: string, params: unknown): void {
    this.write({ jsonrpc: "2.0", method, params });
  }

  ask<Result>(method: string, params: unknown): Promise<Result> {
    const id = ++this.number;
    this.write({ jsonrpc: "2.0", id, method, params });
    return new Promise((resolve, reject) => {
      this.waiting.set(id, (message) => (message.error === undefined ? resolve(message.result as Result) : reject(new Error(message.error.message))));
    });
  }

  end(): void {
    this.process.kill();
  }

  private write(message: unknown): void {
    const body = Buffer.from(JSON.stringify(message));
    this.process.stdin.write(`Content-Length: ${body.length}\r\n\r\n`);
    this.process.stdin.write(body);
  }
}
