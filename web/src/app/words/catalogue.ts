/**
 * The catalogues of texts: one folder per language, with the same keys and the same placeholders.
 *
 * English has the keys. The type `Translation` makes a key that another language lacks a type error.
 */

import * as de from "./de/index.ts";
import * as en from "./en/index.ts";
import * as zh from "./zh/index.ts";
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

const ENGLISH = {
  ...en.aim,
  ...en.drills,
  ...en.analyse,
  ...en.game,
  ...en.layout,
  ...en.page,
  ...en.physics,
  ...en.play,
  ...en.pot,
  ...en.presets,
  ...en.replay,
  ...en.share,
  ...en.shot,
  ...en.train,
  ...en.whatif,
};

export type English = typeof ENGLISH;

/** The name of a text. */
export type Key = keyof English;

export const CATALOGUES: Readonly<Record<Language, Readonly<Record<Key, Entry>>>> = {
  en: ENGLISH,
  de: {
    ...de.aim,
    ...de.drills,
    ...de.analyse,
    ...de.game,
    ...de.layout,
    ...de.page,
    ...de.physics,
    ...de.play,
    ...de.pot,
    ...de.presets,
    ...de.replay,
    ...de.share,
    ...de.shot,
    ...de.train,
    ...de.whatif,
  },
  zh: {
    ...zh.aim,
    ...zh.drills,
    ...zh.analyse,
    ...zh.game,
    ...zh.layout,
    ...zh.page,
    ...zh.physics,
    ...zh.play,
    ...zh.pot,
    ...zh.presets,
    ...zh.replay,
    ...zh.share,
    ...zh.shot,
    ...zh.train,
    ...zh.whatif,
  },
};
