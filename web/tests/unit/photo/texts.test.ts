import { afterEach, expect, test } from "vitest";
import { ballText, CATALOGUES, setLanguage, shortBallText } from "../../../src/photo/texts.ts";
import { LANGUAGES } from "../../../src/app/words/catalogue.ts";

afterEach(() => setLanguage("en"));

const placeholders = (text: string) =>
  [...text.matchAll(/\{(\w+)\}/g)].map(([, name]) => name).sort();

test("the photo dialog speaks every language of the page", () => {
  expect(Object.keys(CATALOGUES).sort()).toEqual(Object.keys(LANGUAGES).sort());
});

test("its texts have the same placeholders in every language, and are not left in English", () => {
  const { en, ...others } = CATALOGUES;
  for (const [language, texts] of Object.entries(others)) {
    for (const [key, text] of Object.entries(texts)) {
      const english = en![key as keyof typeof texts];
      expect(placeholders(text), `${language} ${key}`).toEqual(placeholders(english));
      if (/[a-z]{3} [a-z]{2}/.test(english)) expect(text, `${language} ${key}`).not.toBe(english);
    }
  }
});

test("balls have names in the language of the page", () => {
  // Seen: "cue", "red 4" and "yel" in German.
  setLanguage("de");
  expect(["cue", "yellow", "red-4", "7"].map(shortBallText)).toEqual([
    "Spielball",
    "Gelbe",
    "Rote 4",
    "7",
  ]);
  expect(["cue", "red-4", "7"].map(ballText)).toEqual(["der Spielball", "Rote 4", "Kugel 7"]);
});
