// Draws the page.
import "@fontsource-variable/inter/wght.css";
import { createRoot } from "react-dom/client";
import { App } from "./App";
import "./look/tokens.css";
import "./look/base.css";
import "./look/controls.css";
import "./look/page.css";
import "./storage/storage.css";
// Of windows that are loaded later: their style comes with the page, for their program alone is large.
import "uplot/dist/uPlot.min.css";
import "./live/live.css";
import "./tuning/tuning.css";
import "./operator/operator.css";
import "./teaching/teaching.css";
import "./production/production.css";
import "./scene/scene.css";
import { keepBreakpoints } from "./state/breakpoints";
import { keepBackup, restore, restoreFromDisk } from "./state/backup";
import { useCell } from "./state/cell";
import { keepChecking } from "./state/checks";
import { useDrawing } from "./state/drawing";
import { showLoaded } from "./state/keep";
import { applyTheme } from "./state/theme";
import { currentLanguage } from "./words/words";

document.documentElement.lang = currentLanguage();
applyTheme();
const restored = restore();
const onDisk = restoreFromDisk();
keepBackup();
keepChecking();
keepBreakpoints();

// Who comes late sees what runs, unless a drawing of one's own is under way.
const stop = useCell.subscribe(looked);
function looked(): void {
  if (useCell.getState().link !== "ready") return;
  stop();
  void onDisk.then((there) => {
    const empty = useDrawing.getState().drawing.icons.length === 0;
    if (!restored && !there && empty) void showLoaded();
  });
}
looked();

createRoot(document.getElementById("page")!).render(<App />);
// When nothing else is to be done: the windows that are opened seldom open at once then.
(window.requestIdleCallback ?? setTimeout)(() => void import("./dialog/rare"));
