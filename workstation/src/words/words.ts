// All texts of the interface, by language. `t` gives one in the language of the page; numbers and times are
// written as that language writes them.
import { useSyncExternalStore } from "react";
import english from "./en.json";
import french from "./fr.json";

export type Word = keyof typeof english;
type Catalogue = Record<Word, string>;

/** To add a language: its catalogue here, and its own name for itself. */
export const languages = { en: "English", fr: "Français" } as const;
export type Language = keyof typeof languages;
const catalogues: Record<Language, Catalogue> = { en: english, fr: french };

const key = "workcell-language";

function preferred(): Language {
  const wanted = [localStorage.getItem(key) ?? "", ...navigator.languages];
  for (const each of wanted) {
    const short = each.slice(0, 2);
    if (short in languages) return short as Language;
  }
  return "en";
}

let language: Language = typeof navigator === "undefined" ? "en" : preferred();
const listeners = new Set<() => void>();

export function setLanguage(wanted: Language): void {
  language = wanted;
  localStorage.setItem(key, wanted);
  document.documentElement.lang = wanted;
  for (const each of listeners) each();
}

export const currentLanguage = (): Language => language;

/** A component that uses this is drawn again when the language changes. */
export function useLanguage(): Language {
  return useSyncExternalStore((listener) => (listeners.add(listener), () => listeners.delete(listener)), currentLanguage);
}

/** Made once each: the browser takes long to make them. */
function kept<K, V>(make: (key: K) => V): (key: K) => V {
  const made = new Map<K, V>();
  return (key) => {
    const there = made.get(key) ?? make(key);
    made.set(key, there);
    return there;
  };
}
const pluralRules = kept((inLanguage: Language) => new Intl.PluralRules(inLanguage));
const numberFormat = kept((key: string) => {
  const [inLanguage, digits] = key.split(":");
  return new Intl.NumberFormat(inLanguage, digits === "" ? { maximumSignificantDigits: 12 } : { minimumFractionDigits: Number(digits), maximumFractionDigits: Number(digits) });
});

export type Values = Record<string, string | number>;

/** "{count|one icon|{count} icons}" takes the form for the number; "{name}" the value. */
export function fill(text: string, values: Values, inLanguage: Language): string {
  if (!text.includes("{")) return text;
  return text
    .replace(/\{(\w+)\|([^|}]*)\|((?:[^{}]|\{\w+\})*)\}/g, (_, name, one, other) =>
      pluralRules(inLanguage).select(Number(values[name])) === "one" ? one : other)
    .replace(/\{(\w+)\}/g, (whole, name) => {
      const value = values[name];
      return value === undefined ? whole : typeof value === "number" ? number(value) : value;
    });
}

export function t(word: Word, values: Values = {}): string {
  return fill(catalogues[language][word], values, language);
}

export const isWord = (text: string): text is Word => text in english;

/** A channel of the cell by its word, if this page has one. */
export function channelName(channel: string): string {
  const word = `channel.${channel}`;
  return isWord(word) ? t(word) : channel;
}

export function number(value: number, digits?: number): string {
  return numberFormat(`${language}:${digits ?? ""}`).format(value);
}

/** A unit as people write it: "N·m" for PAL's "N*m". */
export const unitText = (unit: string): string => unit.replaceAll("*", "\u00b7");

/** A length of time with no more digits than it means: 0.35 s, 4.2 s, 38 s, 2 min, 2 min 5 s. */
export function duration(seconds: number): string {
  if (seconds < 0.005) return "0 s";
  if (seconds < 9.95) return `${number(seconds, seconds < 0.995 ? 2 : 1)} s`;
  if (seconds < 120) return `${number(Math.round(seconds))} s`;
  const minutes = Math.floor(Math.round(seconds) / 60), rest = Math.round(seconds) % 60;
  if (minutes >= 120) return `${number(Math.round(minutes / 6) / 10)} h`;
  return rest === 0 ? `${number(minutes)} min` : `${number(minutes)} min ${number(rest)} s`;
}

/** 0:07, 12:30: a clock that runs. */
export function clock(seconds: number): string {
  const whole = Math.max(0, Math.floor(seconds));
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
}

/** "14:05" today, else with the date. */
export function moment(wall: string): string {
  const when = new Date(wall);
  const today = when.toDateString() === new Date().toDateString();
  return new Intl.DateTimeFormat(language, today ? { timeStyle: "short" } : { dateStyle: "medium", timeStyle: "short" }).format(when);
}
