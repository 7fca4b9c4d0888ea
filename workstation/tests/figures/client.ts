// A light client of the cell: it sends what a page sends and reads what a page reads, and does nothing with it. So the cell pays
// what a page costs it, and the machine does not pay for a browser, which stands on another computer as a rule.
import { randomBytes } from "node:crypto";
import { connect, type Socket } from "node:net";

export interface Told {
  method?: string;
  id?: number;
  params?: { event?: string; state?: string; number?: number };
  error?: { message: string };
}

export interface LightClient {
  send(text: string): void;
  /** Resolves with the next message that fits. */
  next(fits: (message: Told) => boolean): Promise<Told>;
  close(): Promise<void>;
  /** What came, in bytes. */
  bytes(): number;
}

function frame(text: string): Buffer {
  const body = Buffer.from(text), length = body.length;
  // A mask of zeros is a mask, too.
  const head = length < 126 ? Buffer.from([0x81, 0x80 | length]) : length < 65536 ? Buffer.from([0x81, 0xfe, length >> 8, length & 255]) : Buffer.from([0x81, 0xff, 0, 0, 0, 0, (length >>> 24) & 255, (length >> 16) & 255, (length >> 8) & 255, length & 255]);
  return Buffer.concat([head, Buffer.alloc(4), body]);
}

/** `listens`: messages are parsed, and `next` finds them; else they are read and dropped. */
export async function lightClient(port: number, listens = false): Promise<LightClient> {
  const socket: Socket = connect(port, "127.0.0.1");
  await new Promise<void>((resolve, reject) => void socket.once("connect", resolve).once("error", reject));
  socket.setNoDelay(true);
  socket.write(`GET / HTTP/1.1\r\nHost: 127.0.0.1:${port}\r\nOrigin: http://127.0.0.1:${port}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Key: ${randomBytes(16).toString("base64")}\r\n\r\n`);
  let waiting = await new Promise<Buffer>((resolve, reject) => {
    let came = Buffer.alloc(0);
    const read = (data: Buffer) => {
      came = Buffer.concat([came, data]);
      const end = came.indexOf("\r\n\r\n");
      if (end < 0) return;
      socket.off("data", read);
      if (came.subarray(0, 12).toString() !== "HTTP/1.1 101") reject(new Error(came.toString()));
      else resolve(came.subarray(end + 4));
    };
    socket.on("data", read);
  });
  let bytes = 0;
  const wishes = new Set<{ fits(message: Told): boolean; resolve(message: Told): void }>();
  const text = (body: Buffer) => {
    const message = JSON.parse(body.toString()) as Told;
    for (const wish of wishes) if (wish.fits(message)) wishes.delete(wish), wish.resolve(message);
  };
  let pieces: Buffer[] | undefined;
  socket.on("data", (data: Buffer) => {
    bytes += data.length;
    if (!listens) return;
    waiting = Buffer.concat([waiting, data]);
    for (;;) {
      if (waiting.length < 2) return;
      const short = waiting[1]! & 127, at = short === 126 ? 4 : short === 127 ? 10 : 2;
      if (waiting.length < at) return;
      const length = short === 126 ? waiting.readUInt16BE(2) : short === 127 ? Number(waiting.readBigUInt64BE(2)) : short;
      if (waiting.length < at + length) return;
      const opcode = waiting[0]! & 15, body = waiting.subarray(at, at + length);
      // A long message comes in pieces, of which the first tells its kind.
      if (opcode === 1) pieces = [body];
      else if (opcode === 0) pieces?.push(body);
      else pieces = undefined;
      if (pieces && (waiting[0]! & 0x80) !== 0) {
        text(Buffer.concat(pieces));
        pieces = undefined;
      }
      waiting = waiting.subarray(at + length);
    }
  });
  socket.on("error", () => {});
  return {
    send: (message) => void socket.write(frame(message)),
    next: (fits) => new Promise((resolve) => void wishes.add({ fits, resolve })),
    close: () => new Promise((resolve) => void (socket.destroyed ? resolve() : (socket.once("close", () => resolve()), socket.destroy()))),
    bytes: () => bytes,
  };
}
