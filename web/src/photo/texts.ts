/** The texts of the layout from a photo, in the language of the page. */

import { de } from "./texts/de.ts";
import { en, type PhotoTexts } from "./texts/en.ts";
import { zh } from "./texts/zh.ts";

export const CATALOGUES = { en, de, zh } satisfies Record<string, PhotoTexts>;

/** A language of the dialog. */
export type PhotoLanguage = keyof typeof CATALOGUES;

/** The present texts. */
export let TEXTS: PhotoTexts = en;

/** Texts that are read from now on are in this language. */
export function setLanguage(language: PhotoLanguage): void {
  TEXTS = CATALOGUES[language];
}

export function tableText(name: string): string {
  const texts: Readonly<Record<string, string>> = TEXTS;
  return texts[`table.${name}`] ?? name;
}

/** A text with its values. */
export function fill(text: string, values: Readonly<Record<string, string | number>>): string {
  return text.replace(/\{(\w+)\}/g, (_, name: string) => String(values[name] ?? ""));
}

/** "ball 3", "the cue ball", "red 4". */
export function ballText(id: string): string {
  if (id === "cue") return TEXTS.cue;
  return /^\d+$/.test(id) ? fill(TEXTS.ball, { id }) : id.replace("-", " ");
}
