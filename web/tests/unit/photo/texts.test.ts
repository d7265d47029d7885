import { expect, test } from "vitest";
import { CATALOGUES } from "../../../src/photo/texts.ts";
import { LANGUAGES } from "../../../src/app/words/catalogue.ts";

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
