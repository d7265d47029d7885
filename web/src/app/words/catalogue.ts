/**
 * The catalogues of texts: one folder per language, with the same files, keys and placeholders.
 *
 * English has the keys, `en/index.ts` its files. The type `Translation` makes a key that another language
 * lacks a type error; a test names the keys of a file that it lacks.
 */

import type * as en from "./en/index.ts";
import type { Entry } from "./entry.ts";

/**
 * `tag` is the BCP 47 tag of the element `html`, `formats` that of numbers and lists; English is not the
 * American one. `capitals`: whether nouns have a capital letter within a sentence.
 */
export const LANGUAGES = {
  en: { name: "English", tag: "en", formats: "en-GB", capitals: false },
  de: { name: "Deutsch", tag: "de", formats: "de", capitals: true },
  zh: { name: "中文", tag: "zh-Hans", formats: "zh-Hans", capitals: false },
} as const;

export type Language = keyof typeof LANGUAGES;

/** All of a union's members at once. */
type All<U> = (U extends unknown ? (each: U) => void : never) extends (all: infer A) => void
  ? A
  : never;

export type English = All<(typeof en)[keyof typeof en]>;

/** The name of a text. */
export type Key = keyof English;

type Catalogue = Readonly<Record<Key, Entry>>;

type File = Partial<Catalogue>;

/** The texts by language: those of all files in its folder. */
export const CATALOGUES = cataloguesOf(
  import.meta.glob<File>(["./*/*.ts", "!./*/index.ts"], { eager: true, import: "texts" }),
);

function cataloguesOf(
  files: Readonly<Record<string, File>>,
): Readonly<Record<Language, Catalogue>> {
  const found: Record<string, File> = {};
  for (const [path, texts] of Object.entries(files)) {
    const language = path.split("/")[1]!;
    Object.assign((found[language] ??= {}), texts);
  }
  return found as Record<Language, Catalogue>;
}
