// The windows that are opened seldom. They are one file, loaded when the first of them is opened.
export { default as Breakpoints } from "../execution/Breakpoints";
export { default as StoreWindow } from "../storage/StoreWindow";
export { default as Versions } from "../storage/Versions";
export { default as Explain } from "./Explain";
export { default as KeysHelp } from "./KeysHelp";
export { default as SkillHelp } from "./SkillHelp";
export { default as Storyboard } from "./Storyboard";
export { default as Ways } from "./Ways";
