// What belongs to the view of the canvas and not to the document: icons under way, the output that a line is begun
// at by the keyboard, and which of the small lists over the canvas is open.
import { create } from "zustand";
import type { Point } from "../model/operation";
import type { PortName } from "../model/ports";

export interface Insert {
  /** Where on the canvas the new icon goes. */
  at: Point;
  /** Where the list is shown, in pixels of the page. */
  screen: Point;
  text: string;
  /** The output that leads to the new icon. */
  from?: { icon: string; port: PortName } | undefined;
}

interface View {
  /** Places of icons that are being dragged. */
  dragged: ReadonlyMap<string, Point>;
  /** From here a line goes to where the keyboard says next. */
  lineFrom: { icon: string; port: PortName } | undefined;
  insert: Insert | undefined;
  /** The list of icons to connect with. */
  connecting: { icon: string; port: PortName | undefined } | undefined;
  /** The menu of an icon. */
  menu: { icon: string; screen: Point } | undefined;
  /** The line that is selected. */
  line: { from: string; port: PortName } | undefined;
}

export const useView = create<View>()(() => ({
  dragged: new Map(), lineFrom: undefined, insert: undefined, connecting: undefined, menu: undefined, line: undefined,
}));
