// What can be put on a canvas: the skills of the cell, operations, and the control icons, by group.
import type { Skill, Stored } from "../../generated/protocol";
import { familyOfSkill, symbolOfSkill } from "../canvas/family";
import type { Family } from "../canvas/shape";
import { operationsOf, type Drawing } from "../model/operation";
import type { Offer } from "../state/edits";
import type { SymbolName } from "../symbols/drawings";
import { t, type Word } from "../words/words";

export interface Offered {
  key: string;
  name: string;
  text: string;
  offer: Offer;
  family: Family;
  symbol: SymbolName;
  /** Why the cell cannot run it; empty: it can. */
  unable: string;
}

export interface Group {
  word: Word;
  offers: Offered[];
}

const control = ["start", "exit", "restart", "case", "merge"] as const;
const sensing = ["test", "wait", "zero", "delay", "question"] as const;
const absent = ["planned"] as const;

const ofKind = (kind: (typeof control)[number] | (typeof sensing)[number] | (typeof absent)[number]): Offered => ({
  key: kind, name: t(`kind.${kind}`), text: t(`about.${kind}`), offer: { kind }, symbol: kind, unable: "",
  family: kind === "start" || kind === "exit" || kind === "restart" ? "end" : kind === "case" || kind === "merge" || kind === "question" || kind === "planned" ? "other" : "flow",
});

const ofSkill = (skill: Skill): Offered => {
  const family = familyOfSkill(skill.skill, skill);
  return { key: `skill:${skill.skill}`, name: skill.skill, text: skill.description, offer: { kind: "skill", skill: skill.skill }, family, symbol: symbolOfSkill(skill.skill, family), unable: skill.able ? "" : skill.unable };
};

const group = (word: Word, offers: Offered[]): Group => ({ word, offers });

export function groups(skills: ReadonlyMap<string, Skill>, drawing: Drawing, shown: string, stored: readonly Stored[], own: string | undefined): Group[] {
  const all = [...skills.values()].filter((each) => !each.by_hand).map(ofSkill);
  const family = (...wanted: Family[]) => all.filter((each) => wanted.includes(each.family));
  const operations: Offered[] = [
    { key: "operation:", name: t("palette.newPart"), text: t("about.operation"), offer: { kind: "operation" }, family: "super", symbol: "operation", unable: "" },
    ...operationsOf(drawing).slice(1).filter((each) => each.name !== shown).map((each): Offered => ({
      key: `operation:${each.name}`, name: each.name, text: each.description ?? "", offer: { kind: "operation", operation: each.name }, family: "super", symbol: "operation", unable: "" })),
    ...stored.filter((each) => each.name !== own).map((each): Offered => ({
      key: `file:${each.name}`, name: each.name, text: t("palette.stored"), offer: { kind: "operation", file: `${each.name}.op.json` }, family: "super", symbol: "operation", unable: "" })),
  ];
  return [
    group("group.control", control.map(ofKind)),
    group("group.move", family("move")),
    group("group.sense", family("sense")),
    group("group.grip", family("grip")),
    group("group.other", [...family("other"), ...absent.map(ofKind)]),
    group("group.wait", sensing.map(ofKind)),
    group("group.operations", operations),
  ].filter((each) => each.offers.length > 0);
}

const plain = (text: string) => text.toLowerCase().normalize("NFD").replace(/[\u0300-\u036f]/g, "");

/** Those whose name or description has all the words; names that begin with the text come first. */
export function matching(offers: readonly Offered[], text: string): Offered[] {
  const words = plain(text).split(/[\s-]+/).filter(Boolean);
  const rank = (each: Offered) => (plain(each.name).startsWith(plain(text)) ? 0 : words.every((word) => plain(each.name).includes(word)) ? 1 : 2);
  return offers
    .filter((each) => words.every((word) => plain(`${each.name} ${each.text}`).includes(word)))
    .map((each, i) => ({ each, key: rank(each) * 1000 + i }))
    .sort((a, b) => a.key - b.key)
    .map(({ each }) => each);
}
