// The page: bar on top, palette, canvas, panel of what is selected, and the windows over them.
import { lazy, Suspense } from "react";
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
import { useOperatorMode } from "./operator/mode";
import { Palette } from "./palette/Palette";
import { useCell } from "./state/cell";
import { useDrawing } from "./state/drawing";
import { useWindows } from "./state/windows";
import { Pending } from "./storage/Pending";
import { useLanguage } from "./words/words";

const OperatorPage = lazy(() => import("./operator/OperatorPage"));

export function App() {
  const language = useLanguage();
  const noToken = useCell((state) => state.link === "no-token");
  const palette = useWindows((state) => state.palette), inspector = useWindows((state) => state.inspector);
  const operator = useOperatorMode();
  const said = useDrawing((state) => state.said);
  if (noToken) return <NoToken />;
  if (operator) return <I18nProvider locale={language}><Fallen><Suspense><OperatorPage key={language} /></Suspense><Notices /></Fallen></I18nProvider>;
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
