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

/** Vite writes the calls of `glob` as lists of modules: each needs its options as literals. */
export const CATALOGUES: Readonly<Record<Language, Catalogue>> = {
  en: merged(
    Object.values(
      import.meta.glob<File>(["./en/*.ts", "!./en/index.ts"], { eager: true, import: "texts" }),
    ),
  ),
  de: merged(Object.values(import.meta.glob<File>("./de/*.ts", { eager: true, import: "texts" }))),
  zh: merged(Object.values(import.meta.glob<File>("./zh/*.ts", { eager: true, import: "texts" }))),
};

function merged(files: readonly File[]): Catalogue {
  return Object.assign({}, ...files) as Catalogue;
}
