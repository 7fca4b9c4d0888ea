// As much of a WebSocket server as the tests need: text frames, no extensions.
import { createHash } from "node:crypto";
import type { IncomingMessage } from "node:http";
import type { Duplex } from "node:stream";

export interface Socket {
  send(text: string): void;
  close(): void;
}

function frame(text: string): Buffer {
  const body = Buffer.from(text);
  const head = body.length < 126 ? Buffer.from([0x81, body.length]) : body.length < 65536 ? Buffer.from([0x81, 126, body.length >> 8, body.length & 255]) : Buffer.alloc(10);
  if (body.length >= 65536) {
    head[0] = 0x81;
    head[1] = 127;
    head.writeBigUInt64BE(BigInt(body.length), 2);
  }
  return Buffer.concat([head, body]);
}

export function accept(request: IncomingMessage, stream: Duplex, received: (text: string) => void, closed: () => void): Socket {
  const key = createHash("sha1").update(`${request.headers["sec-websocket-key"]}258EAFA5-E914-47DA-95CA-C5AB0DC85B11`).digest("base64");
  stream.write(`HTTP/1.1 101 Switching Protocols\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Accept: ${key}\r\n\r\n`);
  let waiting = Buffer.alloc(0), parts: Buffer[] = [];
  stream.on("data", (data: Buffer) => {
    waiting = Buffer.concat([waiting, data]);
    for (;;) {
      if (waiting.length < 2) return;
      let length = waiting[1]! & 127, at = 2;
      if (length === 126) { length = waiting.readUInt16BE(2); at = 4; }
      else if (length === 127) { length = Number(waiting.readBigUInt64BE(2)); at = 10; }
      if (waiting.length < at + 4 + length) return;
      const mask = waiting.subarray(at, at + 4), body = Buffer.from(waiting.subarray(at + 4, at + 4 + length));
      for (let i = 0; i < body.length; ++i) body[i]! ^= mask[i % 4]!;
      const opcode = waiting[0]! & 15, final = (waiting[0]! & 128) !== 0;
      waiting = waiting.subarray(at + 4 + length);
      if (opcode === 8) return void stream.end();
      if (opcode > 1) continue;
      parts.push(body);
      if (final) received(Buffer.concat(parts).toString()), (parts = []);
    }
  });
  stream.on("close", closed);
  stream.on("error", () => {});
  return { send: (text) => void stream.write(frame(text)), close: () => stream.destroy() };
}
