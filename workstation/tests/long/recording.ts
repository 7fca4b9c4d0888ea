// What a person saw, as pictures with their times: in PICTURES/NAME, one a change of the screen. Without PICTURES nothing is kept.
import { mkdirSync, writeFileSync } from "node:fs";
import { join } from "node:path";
import type { Page } from "playwright-core";

/** Begins to keep what the page shows, and gives the end of it. `ffmpeg -f concat -i NAME/frames.txt NAME.mp4` makes a film of it. */
export async function record(page: Page, name: string): Promise<() => Promise<void>> {
  if (!process.env.PICTURES) return async () => {};
  const folder = join(process.env.PICTURES, name);
  mkdirSync(folder, { recursive: true });
  const client = await page.context().newCDPSession(page);
  const times: number[] = [];
  client.on("Page.screencastFrame", ({ data, metadata, sessionId }) => {
    writeFileSync(join(folder, `${String(times.length).padStart(4, "0")}.jpg`), Buffer.from(data, "base64"));
    times.push(metadata.timestamp ?? Date.now() / 1000);
    void client.send("Page.screencastFrameAck", { sessionId }).catch(() => {});
  });
  await client.send("Page.startScreencast", { format: "jpeg", quality: 70, everyNthFrame: 4 });
  return async () => {
    await client.send("Page.stopScreencast").catch(() => {});
    const lines = times.map((time, i) => `file '${String(i).padStart(4, "0")}.jpg'\nduration ${Math.max(0.04, (times[i + 1] ?? time + 1) - time).toFixed(3)}`);
    writeFileSync(join(folder, "frames.txt"), `ffconcat version 1.0\n${lines.join("\n")}\n`);
  };
}
