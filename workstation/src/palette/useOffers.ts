// The offers of this cell, for the palette and for the list that opens on the canvas.
import { useMemo } from "react";
import { useCell } from "../state/cell";
import { shownOperation, useDrawing } from "../state/drawing";
import { useLanguage } from "../words/words";
import { groups, type Group } from "./offers";

export function useOffers(): Group[] {
  const language = useLanguage();
  const skills = useCell((state) => state.skills);
  const stored = useCell((state) => state.stored);
  const drawing = useDrawing((state) => state.drawing);
  const name = useDrawing((state) => state.name);
  const shown = useDrawing((state) => shownOperation(state).name);
  // The language is named since the offers' words are in it.
  return useMemo(() => (language ? groups(skills, drawing, shown, stored ?? [], name) : []), [skills, drawing, shown, stored, name, language]);
}
