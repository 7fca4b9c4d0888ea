// The requests of `pal language-server` that the protocol does not have (docs/reference/language-server.md).
export interface Position {
  line: number;
  character: number;
}
export interface Range {
  start: Position;
  end: Position;
}

export type PictureKind = "pan" | "atc";
export type State = "holds" | "fails" | "undecided" | "never" | "open";

export interface PictureParams {
  textDocument: { uri: string };
  position?: Position;
  kind: PictureKind;
  skill?: string;
  module?: string;
  requirement?: string;
  letters?: boolean;
  dark?: boolean;
  narrow?: boolean;
}

/** A range of a text, at the element of the SVG that has this id. */
export interface PlaceInPicture {
  id: string;
  uri: string;
  range: Range;
}

export interface Picture {
  svg: string;
  reason: string;
  title: string;
  kind: PictureKind;
  skill: string;
  module: string;
  requirement: string;
  environment: string;
  state: State | "";
  stale: boolean;
  places: PlaceInPicture[];
  choices: { skills: string[]; modules: string[]; requirements: string[] };
}

export interface Requirement {
  name: string;
  uri: string;
  range: Range;
  state: State;
  bound: string;
  limit: string;
  exact: boolean;
  message: string;
}

export interface SkillRequirements {
  skill: string;
  uri: string;
  range: Range;
  environment: string;
  environmentUri: string;
  requirements: Requirement[];
}

export interface Changed {
  uris: string[];
  what: "text" | "proof";
}

/** What a picture shows; "" is: what the cursor is at. */
export interface Shown {
  uri: string;
  skill: string;
  module: string;
  requirement: string;
  letters: boolean;
}

/** How the page wants its picture. */
export interface Look {
  dark: boolean;
  narrow: boolean;
}

/** What the picture's page is told, and what it tells; its look is the first thing. */
export type ToPage =
  | { type: "picture"; picture: Picture; shown: Shown }
  | { type: "cursor"; uri: string; position: Position };
export type FromPage =
  | { type: "look"; look: Look }
  | { type: "go"; uri: string; range: Range }
  | { type: "choose"; shown: Shown }
  | { type: "save"; svg: string };
