// JSON-RPC over a WebSocket that comes back by itself. It knows requests, answers and notifications, and nothing
// of what they mean.
import type { ErrorData, Methods } from "../../generated/protocol";

export type MethodName = keyof Methods;
export type Result<M extends MethodName> = Methods[M]["result"];
export type Params<M extends MethodName> = Methods[M]["params"];

/** What the server answered instead of a result. */
export class Refused extends Error {
  constructor(readonly code: number, message: string, readonly data: Partial<ErrorData>) {
    super(message);
  }
  get why(): string {
    return this.data.why ?? "internal";
  }
}

/** The connection broke before the answer came. Whether the request was obeyed is not known. */
export class Broken extends Error {}

export interface Listener {
  /** The socket is open; nothing has been asked yet. */
  opened(): void;
  /** `again`: when the next attempt is made, in ms. */
  closed(again: number): void;
  notified(method: string, params: unknown): void;
  /** A message that is bytes. */
  bytes(bytes: ArrayBuffer): void;
}

interface Waiting {
  resolve(result: unknown): void;
  reject(reason: Error): void;
}

const attempts = [250, 500, 1000, 2000, 3000];

export class Connection {
  #socket: WebSocket | undefined;
  #waiting = new Map<number, Waiting>();
  #next = 1;
  #attempt = 0;
  #timer: ReturnType<typeof setTimeout> | undefined;
  #ended = false;

  constructor(readonly address: string, readonly listener: Listener) {}

  open(): void {
    clearTimeout(this.#timer);
    const socket = new WebSocket(this.address);
    this.#socket = socket;
    socket.binaryType = "arraybuffer";
    socket.onopen = () => this.listener.opened();
    socket.onmessage = ({ data }) => (data instanceof ArrayBuffer ? this.listener.bytes(data) : this.#received(String(data)));
    socket.onclose = () => this.#lost(socket);
  }

  /** It works: the next break is followed by a quick attempt again. */
  settled(): void {
    this.#attempt = 0;
  }

  /** It does not answer: hangs up and tries again. */
  drop(): void {
    this.#socket?.close();
  }

  /** No attempts any more. */
  end(): void {
    this.#ended = true;
    clearTimeout(this.#timer);
    this.#socket?.close();
  }

  call<M extends MethodName>(method: M, params?: Params<M>): Promise<Result<M>> {
    return this.begin(method, params).answer;
  }

  /** The same, with the number by which the request can be cancelled. */
  begin<M extends MethodName>(method: M, params?: Params<M>): { id: number; answer: Promise<Result<M>> } {
    const id = this.#next++;
    const socket = this.#socket;
    if (socket?.readyState !== WebSocket.OPEN) return { id, answer: Promise.reject(new Broken("not connected")) };
    const answer = new Promise<Result<M>>((resolve, reject) => {
      this.#waiting.set(id, { resolve: resolve as (result: unknown) => void, reject });
    });
    socket.send(JSON.stringify({ jsonrpc: "2.0", id, method, params: params ?? {} }));
    return { id, answer };
  }

  #received(text: string): void {
    const message = JSON.parse(text);
    if (message.id === undefined || message.id === null) {
      if (message.method) this.listener.notified(message.method, message.params);
      return;
    }
    const waiting = this.#waiting.get(message.id);
    this.#waiting.delete(message.id);
    if (message.error) waiting?.reject(new Refused(message.error.code, message.error.message, message.error.data ?? {}));
    else waiting?.resolve(message.result);
  }

  #lost(socket: WebSocket): void {
    if (socket !== this.#socket) return;
    this.#socket = undefined;
    const waiting = [...this.#waiting.values()];
    this.#waiting.clear();
    for (const each of waiting) each.reject(new Broken("the connection broke"));
    const again = attempts[Math.min(this.#attempt++, attempts.length - 1)] ?? 3000;
    this.listener.closed(this.#ended ? 0 : again);
    if (!this.#ended) this.#timer = setTimeout(() => this.open(), again);
  }
}
