/** The texts of the layout from a photo, in the language of the page. */

import { type PhotoTexts, texts as english } from "./texts/en.ts";

/** The texts by language: each file in `texts` is one, and has the keys of the English one. */
export const CATALOGUES: Readonly<Record<string, PhotoTexts>> = Object.fromEntries(
  Object.entries(
    import.meta.glob<PhotoTexts>("./texts/*.ts", { eager: true, import: "texts" }),
  ).map(([path, texts]) => [path.split(/[/.]/).at(-2)!, texts]),
);

/** The present texts. */
export let TEXTS: PhotoTexts = english;

/** Texts that are read from now on are in this language. */
export function setLanguage(language: string): void {
  TEXTS = CATALOGUES[language] ?? english;
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
  return /^\d+$/.test(id) ? fill(TEXTS.ball, { id }) : shortBallText(id);
}

/** "3", "cue ball", "red 4": a ball on a small button. */
export function shortBallText(id: string): string {
  const texts: Readonly<Record<string, string>> = TEXTS;
  const [kind = "", number] = id.split("-");
  return [texts[`ball.${kind}`] ?? kind, number].filter(Boolean).join(" ");
}
