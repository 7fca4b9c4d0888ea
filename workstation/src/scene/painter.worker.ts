// The thread of the painter: takes what is wanted, one picture after the other, and tells when each is there.
import type { Answer, Begin, Wanted } from "./news";
import { Painter } from "./painter";

const answer = (message: Answer): void => postMessage(message);
let painter: Painter | undefined;

addEventListener("message", ({ data }: MessageEvent<Begin | Wanted>) => {
  if (!("scene" in data)) return void painter?.draw(data).then(() => answer({ kind: "drawn" }), () => answer({ kind: "failed" }));
  try {
    painter = new Painter(data);
    answer({ kind: "begun", boxes: painter.boxes, graphicsCard: painter.graphicsCard });
  } catch {
    answer({ kind: "failed" });
  }
});
