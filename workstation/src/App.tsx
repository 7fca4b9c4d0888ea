// The page: bar on top, palette, canvas, panel of what is selected, and the windows over them.
import { ReactFlowProvider } from "@xyflow/react";
import { I18nProvider } from "react-aria-components";
import { Canvas } from "./canvas/Canvas";
import { Inspector } from "./dialog/Inspector";
import { WindowLayer } from "./dialog/WindowLayer";
import { Bar } from "./execution/Bar";
import { GoOn } from "./execution/GoOn";
import { Notices } from "./execution/Notices";
import { Question } from "./execution/Question";
import { Fallen } from "./Fallen";
import { NoToken } from "./NoToken";
import { Palette } from "./palette/Palette";
import { useCell } from "./state/cell";
import { useDrawing } from "./state/drawing";
import { useWindows } from "./state/windows";
import { Pending } from "./storage/Pending";
import { useLanguage } from "./words/words";

export function App() {
  const language = useLanguage();
  const noToken = useCell((state) => state.link === "no-token");
  const palette = useWindows((state) => state.palette), inspector = useWindows((state) => state.inspector);
  const said = useDrawing((state) => state.said);
  if (noToken) return <NoToken />;
  return (
    <I18nProvider locale={language}>
      <Fallen>
      <ReactFlowProvider>
        <div className="page" key={language}>
          <Bar />
          <main className="middle">
            {palette && <Palette />}
            <div className="stage"><Canvas /><GoOn /><Question /></div>
            {inspector && <Inspector />}
          </main>
        </div>
        <WindowLayer />
        <Notices />
        <Pending />
        <div className="hidden" role="status" aria-live="polite">{said}</div>
      </ReactFlowProvider>
      </Fallen>
    </I18nProvider>
  );
}
