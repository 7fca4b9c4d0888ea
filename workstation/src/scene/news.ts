// What the page tells the painter of the cell, and what the painter answers. All of it goes from thread to thread as a copy.
import type { Scene } from "../../generated/protocol";
import type { TrailNews } from "./trail";

export interface Place {
  location: string;
  position: readonly number[];
  turn: readonly number[];
}

export interface Shows {
  path: boolean;
  contacts: boolean;
  sensor: boolean;
  laser: boolean;
  locations: boolean;
}

export interface Colours {
  dark: boolean;
  background: string;
  grid: string;
  edges: string;
  /** Of x, y and z. */
  axes: readonly string[];
  path: string;
  contact: string;
  sensor: string;
}

/** From a place along a unit vector, m. */
export interface ArrowNews {
  begin: readonly number[];
  direction: readonly number[];
  length: number;
}

/** A scan: y and z of each point in the tool's frame, mm, and where the tool was then, as a matrix. */
export interface FanNews {
  y: Float64Array;
  z: Float64Array;
  tip: readonly number[];
}

/** What has changed since the last picture. What is not named stays. */
export interface News {
  colours?: Colours;
  shows?: Shows;
  /** Of the window, px. */
  size?: { width: number; height: number };
  bodies?: { rows: Float32Array; later: Float32Array | undefined; part: number };
  /** The tool's tip, as a matrix. */
  tip?: readonly number[];
  contacts?: readonly ArrowNews[];
  /** Null: there is none. */
  sensor?: ArrowNews | null;
  fan?: FanNews | null;
  places?: readonly Place[];
  path?: TrailNews | undefined;
  /** The whole path of a run that is replayed. */
  wholePath?: TrailNews | undefined;
}

/** A picture that is wanted: from where, and how finely. */
export interface Wanted {
  news: News;
  position: readonly number[];
  turn: readonly number[];
  /** Pixels of the picture for one of the page, and of the map of shadows. */
  ratio: number;
  shadow: number;
}

/** The first message to the painter. */
export interface Begin {
  canvas: OffscreenCanvas;
  scene: Scene;
}

/** What has two corners in space: the least and the greatest x, y and z. */
export type Corners = readonly number[];

export type Answer =
  /** It draws. `boxes`: of each body's shapes in the body's frame; null: it has none that are drawn. */
  | { kind: "begun"; boxes: readonly (Corners | null)[]; graphicsCard: boolean }
  /** This browser draws nothing in three dimensions. */
  | { kind: "failed" }
  /** The picture that was wanted is there. */
  | { kind: "drawn" };
