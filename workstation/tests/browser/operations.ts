// The operations of the thesis that the tests draw: figures 4.14 (pick by identity) and 5.29 (follow edge again).
import type { Wanted } from "./hands";

const move = (location: string) => ({ location: { choose: location } });

/** In a grid of columns and rows, in pixels of the canvas at half size. */
const at = (column: number, row: number): [number, number] => [64 + column * 134, 120 + row * 92];

export const pickByIdentity: readonly Wanted[] = [
  { id: "start", offer: "start", at: at(0, 0), lines: { next: "go-home" } },
  { id: "go-home", offer: "skill:move-to-location", at: at(1, 0), settings: move("HOME"), lines: { next: "a-part-comes", error: "failed" } },
  { id: "a-part-comes", offer: "wait", at: at(2, 0), settings: { "What is read": { choose: "delivery" }, "At most": "280", "At least": "", "Wait at most": "5" }, lines: { next: "came", error: "failed" } },
  { id: "came", offer: "case", at: at(3, 0), lines: { "way:0": "which-part", "way:1": "no-part", default: "failed" } },
  { id: "which-part", offer: "test", at: at(4, 0), settings: { "What is read": { choose: "delivery" }, "Limit 1": "230", "+": { press: "Add a limit" }, "Limit 2": "250" }, lines: { next: "kind-seen", error: "failed" } },
  { id: "kind-seen", offer: "case", at: at(5, 0), settings: { "+": { press: "Add a way" } }, lines: { "way:0": "pick-high", "way:1": "pick-middle", "way:2": "pick-low", default: "failed" } },
  { id: "pick-high", offer: "skill:pick-at-location", at: at(6, 0), settings: move("HIGH"), lines: { next: "picked", error: "failed" } },
  { id: "pick-middle", offer: "skill:pick-at-location", at: at(6, 1), settings: move("MIDDLE"), lines: { next: "picked", error: "failed" } },
  { id: "pick-low", offer: "skill:pick-at-location", at: at(6, 2), settings: move("LOW"), lines: { next: "picked", error: "failed" } },
  { id: "picked", offer: "merge", at: at(7, 1), lines: { next: "carry" } },
  { id: "carry", offer: "skill:move-to-location", at: at(1, 4), settings: move("HOME"), lines: { next: "which-held", error: "failed" } },
  { id: "which-held", offer: "test", at: at(2, 4), settings: { "What is read": { choose: "gripper-width" }, "Limit 1": "38", "+": { press: "Add a limit" }, "Limit 2": "52" }, lines: { next: "kind-held", error: "failed" } },
  { id: "kind-held", offer: "case", at: at(3, 4), settings: { "+": { press: "Add a way" } }, lines: { "way:0": "place-low", "way:1": "place-middle", "way:2": "place-high", default: "failed" } },
  { id: "place-low", offer: "skill:place-at-location", at: at(5, 4), settings: move("LOW_PLACE"), lines: { next: "placed", error: "failed" } },
  { id: "place-middle", offer: "skill:place-at-location", at: at(5, 5), settings: move("MIDDLE_PLACE"), lines: { next: "placed", error: "failed" } },
  { id: "place-high", offer: "skill:place-at-location", at: at(5, 6), settings: move("HIGH_PLACE"), lines: { next: "placed", error: "failed" } },
  { id: "placed", offer: "merge", at: at(7, 5), lines: { next: "go-home" } },
  { id: "no-part", offer: "exit", at: at(4, 2), settings: { Code: "0" } },
  { id: "failed", offer: "exit", at: at(7, 3), settings: { Code: "2" } },
];

export const followEdgeAgain: readonly Wanted[] = [
  { id: "start", offer: "start", at: [40, 80], lines: { next: "go-home" } },
  { id: "go-home", offer: "skill:move-to-location", at: [240, 80], settings: move("HOME"), lines: { next: "follow", error: "failed" } },
  { id: "follow", offer: "skill:follow-edge", at: [520, 80], settings: { distance: "3" }, lines: { next: "go-home", error: "failed" } },
  { id: "failed", offer: "exit", at: [520, 280], settings: { Code: "1" } },
];
