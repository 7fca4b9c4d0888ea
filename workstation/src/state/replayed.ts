// Whether this page looks at a run again, and what acted at the instant at which it looks. Small, for icons look at it too.
import { create } from "zustand";

export interface Replayed {
  /** Of the history; undefined: the page shows the cell as it is now. */
  run: number | undefined;
  name: string;
  /** s of the cell. */
  time: number;
  /** The path of the icon that acted then; empty: none did. */
  icon: string;
}

export const notReplayed: Replayed = { run: undefined, name: "", time: 0, icon: "" };

export const useReplayed = create<Replayed>()(() => notReplayed);

/** Whether the icon, or one inside it, acted at the instant that is looked at. */
export const acted = ({ run, icon }: Replayed, path: string): boolean => run !== undefined && (icon === path || icon.startsWith(`${path}/`));
