// The instant at which people look, of all windows: a chart's cursor, the profile that is shown, the scene that is
// replayed. Undefined: now.
import { create } from "zustand";

export const useInstant = create<{ time: number | undefined }>()(() => ({ time: undefined }));

export function lookAt(time: number | undefined): void {
  if (useInstant.getState().time !== time) useInstant.setState({ time });
}
