/** Texts, numbers and lists in the present language. */

import { CATALOGUES, type English, type Key, type Language, LANGUAGES } from "./catalogue.ts";
import type { Placeholders } from "./entry.ts";

export type { Key } from "./catalogue.ts";

let present: Language = "en";

/** Formats of the present language. */
let formats = formatsOf(present);

export function language(): Language {
  return present;
}

/** Texts that are read from now on are in this language. The caller shows those again that are visible. */
export function setLanguage(to: Language): void {
  present = to;
  formats = formatsOf(to);
}

type Values = Readonly<Record<string, string | number>>;

/** No argument for a text without placeholders, else an object with a value for each. */
type Arguments<K extends Key> = [Placeholders<English[K]>] extends [never]
  ? []
  : [Readonly<Record<Placeholders<English[K]>, string | number>>];

/** A key whose text has no placeholder. */
export type PlainKey = { [K in Key]: Arguments<K> extends [] ? K : never }[Key];

/** The text `key`, with its placeholders filled in. */
export function t<K extends Key>(key: K, ...[values]: Arguments<K>): string {
  return filled(key, values ?? {});
}

function filled(key: Key, values: Values): string {
  const entry = CATALOGUES[present][key];
  const form = typeof entry === "string" ? entry : formOf(entry, values);
  return form.replace(/\{(\w+)\}/g, (whole, name: string) => {
    const value = values[name];
    if (value === undefined) return whole;
    return typeof value === "number" ? decimal(value) : value;
  });
}

function formOf(
  entry: Partial<Record<Intl.LDMLPluralRule, string>> & { other: string },
  { count }: Values,
): string {
  return entry[formats.plural().select(Number(count))] ?? entry.other;
}

/**
 * The text `stem.name`, for a name that comes from the engine or a file; null if there is none. Such a
 * text has no placeholder.
 */
export function named(stem: string, name: string): string | null {
  const key = `${stem}.${name}`;
  return Object.hasOwn(CATALOGUES.en, key) ? filled(key as Key, {}) : null;
}

/** The key of an English text of the engine, such as the reason of a ruling; undefined if it has none. */
export function keyOf(english: string, stem: string): Key | undefined {
  return (Object.keys(CATALOGUES.en) as Key[]).find(
    (key) => key.startsWith(stem) && CATALOGUES.en[key] === english,
  );
}

/** A number with exactly `digits` decimals; without `digits` with as many as it has. */
export function decimal(value: number, digits?: number): string {
  const key = digits ?? -1;
  let format = formats.numbers.get(key);
  if (!format) {
    format = numberFormat(formats.tag, digits);
    formats.numbers.set(key, format);
  }
  return format.format(value);
}

/** "a", "a and b", "a, b and c". */
export function list(
  items: readonly string[],
  type: "conjunction" | "disjunction" = "conjunction",
) {
  return formats[type]().format(items);
}

/** A month, "Nov 2026". */
export function month(date: Date): string {
  return formats.month().format(date);
}

/** A text as a sentence: with a capital and a full stop. */
export function sentence(text: string): string {
  return t("sentence", { text: capital(text) });
}

/** Sentences one after another; empty ones are left out. */
export function paragraph(sentences: readonly string[]): string {
  return sentences.filter(Boolean).join(t("sentence.gap"));
}

/** A heading within a sentence: in small letters, unless the language writes its nouns with capitals. */
export function inSentence(text: string): string {
  return LANGUAGES[present].capitals ? text : text.toLowerCase();
}

/** With a capital letter, where the script has one. */
export function capital(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}

/** A time of the user's day: "26 Nov 2026, 21:40". */
export function dateAndTime(time: Date): string {
  return formats.moment().format(time);
}

function formatsOf(to: Language) {
  const tag = LANGUAGES[to].formats;
  return {
    tag,
    plural: once(() => new Intl.PluralRules(tag)),
    numbers: new Map<number, Intl.NumberFormat>(),
    conjunction: once(() => new Intl.ListFormat(tag, { type: "conjunction" })),
    disjunction: once(() => new Intl.ListFormat(tag, { type: "disjunction" })),
    moment: once(() => new Intl.DateTimeFormat(tag, { dateStyle: "medium", timeStyle: "short" })),
    month: once(
      () => new Intl.DateTimeFormat(tag, { month: "short", year: "numeric", timeZone: "UTC" }),
    ),
  };
}

/** Makes a value when it is first used: making a format takes long, and the page starts with few of them. */
function once<T>(make: () => T): () => T {
  let made: T | undefined;
  return () => (made ??= make());
}

/** Without grouping: 1 000 m/s² would look like two numbers in a list. "-0" becomes "0". */
function numberFormat(tag: string, digits: number | undefined): Intl.NumberFormat {
  return new Intl.NumberFormat(tag, {
    useGrouping: false,
    signDisplay: "negative",
    minimumFractionDigits: digits ?? 0,
    maximumFractionDigits: digits ?? 20,
  });
}
