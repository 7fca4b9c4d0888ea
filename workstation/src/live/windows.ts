// The windows on the cell: live data, tuning, teaching, production. They are one file, loaded when the first of them is opened.
export { default as ChannelWindow } from "./ChannelWindow";
export { default as Gauges, RequirementChart } from "./Gauges";
export { default as Sensors } from "./Sensors";
export { default as Jog } from "../jog/Jog";
export { default as Locations } from "../teaching/Locations";
export { default as Production } from "../production/Production";
export { default as Tuning } from "../tuning/Tuning";
