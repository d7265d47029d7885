/** The catalogues agree, and every text of the page is in them. */

import { readFileSync, readdirSync } from "node:fs";
import { fileURLToPath } from "node:url";
import { afterEach, describe, expect, test } from "vitest";
import { CATALOGUES, type Language, LANGUAGES } from "../../../src/app/words/catalogue.ts";
import * as english from "../../../src/app/words/en/index.ts";
import type { Entry } from "../../../src/app/words/entry.ts";
import { decimal, keyOf, list, named, setLanguage, t } from "../../../src/app/words/translate.ts";
import { preferred } from "../../../src/app/shell/language.ts";
import { visibleLiterals } from "./literals.ts";

const APP = fileURLToPath(new URL("../../../src/app/", import.meta.url));
const RULES = fileURLToPath(new URL("../../../../crates/carom-rules/src/", import.meta.url));

const files = (folder: string, end: string): string[] =>
  readdirSync(folder, { recursive: true, encoding: "utf8" })
    .filter((name) => name.endsWith(end))
    .sort();
const SOURCES = files(APP, ".ts").filter(
  // A Python program is the same in every language.
  (name) => !name.startsWith("words/") && name !== "share/python.ts",
);

const texts = (entry: Entry): string[] =>
  typeof entry === "string" ? [entry] : Object.values(entry);
const placeholders = (text: string) => [...text.matchAll(/\{(\w+)\}/g)].map(([, name]) => name!);
const ofEntry = (entry: Entry) => [...new Set(texts(entry).flatMap(placeholders))].sort();

afterEach(() => setLanguage("en"));

const OTHERS = (Object.keys(LANGUAGES) as Language[]).filter((language) => language !== "en");

describe.each(OTHERS)("the catalogue %s", (language) => {
  const english = Object.entries(CATALOGUES.en);

  test("has every key, and no other", () => {
    expect(Object.keys(CATALOGUES[language]).sort()).toEqual(english.map(([key]) => key).sort());
  });

  test("has the placeholders of the English texts", () => {
    for (const [key, entry] of english) {
      expect(ofEntry(CATALOGUES[language][key as keyof typeof CATALOGUES.en]), key).toEqual(
        ofEntry(entry),
      );
    }
  });

  test("has no empty text but the gap between sentences", () => {
    for (const [key, entry] of Object.entries(CATALOGUES[language])) {
      if (key !== "sentence.gap") for (const text of texts(entry)) expect(text, key).not.toBe("");
    }
  });
});

test("German has the words Kugel and Queue, not Ball and cue", () => {
  // The ids of balls are those of files, and games keep their names.
  const isName = (key: string) => key.startsWith("game.") || key.startsWith("preset.");
  for (const [key, entry] of Object.entries(CATALOGUES.de)) {
    const said = texts(entry).join(" ").replace("Nennen Sie sie cue und 1 bis 15", "");
    if (!isName(key))
      expect(said.replaceAll(/\{\w+\}/g, ""), key).not.toMatch(/\b(Balls?|Bälle|cue)\b/i);
  }
});

test("the index of English lists every file of texts", () => {
  const listed = Object.values(english).flatMap((file) => Object.keys(file));
  expect(listed.sort()).toEqual(Object.keys(CATALOGUES.en).sort());
});

test("every text is used", () => {
  const code =
    SOURCES.map((name) => readFileSync(APP + name, "utf8")).join("\n") +
    readFileSync(`${APP}words/translate.ts`, "utf8");
  const page = readFileSync(`${APP}../../index.html`, "utf8");
  // Keys that code puts together: t(`theme.${now}`) and named("level", name).
  const stems = [
    ...[...code.matchAll(/`([\w.-]+[.-])\$\{/g)].map(([, stem]) => stem!),
    ...[...code.matchAll(/named\("([\w.-]+)"/g)].map(([, stem]) => `${stem!}.`),
    ...[...code.matchAll(/keyOf\(\w+, "([\w.]+)"/g)].map(([, stem]) => stem!),
  ];
  const unused = Object.keys(CATALOGUES.en).filter(
    (key) =>
      !code.includes(`"${key}"`) &&
      !page.includes(`="${key.replace("page.", "")}"`) &&
      !stems.some((stem) => key.startsWith(stem)),
  );
  expect(unused).toEqual([]);
});

test("index.html names texts of the catalogue", () => {
  const page = readFileSync(`${APP}../../index.html`, "utf8");
  const names = [...page.matchAll(/data-(?:text|label|role-text)="([^"]*)"/g)].map(([, k]) => k!);
  expect(names.length).toBeGreaterThan(5);
  for (const name of names) expect(named("page", name), name).not.toBeNull();
});

describe("a literal in the code", () => {
  test("is found where users would see it", () => {
    const found = (code: string) => visibleLiterals(code).map(({ text }) => text);
    expect(found('h("p", {}, "Hello");')).toEqual(["Hello"]);
    expect(found('h("button", { title: "Go" }, icon("M0"));')).toEqual(["Go"]);
    expect(found("setText(p, `${n} balls`);")).toEqual([" balls"]);
    expect(found('store.refuse("No");')).toEqual(["No"]);
    expect(found('const NAMES = { a: "Two words" };')).toEqual(["Two words"]);
    expect(found('throw new PageError("no place");')).toEqual(["no place"]);
    expect(found('p.textContent = "Done";')).toEqual(["Done"]);
    expect(found('h("p", {}, on ? "yes" : "no");')).toEqual(["yes", "no"]);
    expect(found('h("p", { class: "row end" }, t("aim.tip"));')).toEqual([]);
    expect(found('document.querySelector("a b");')).toEqual([]);
  });

  test.each(SOURCES)("is not visible: %s", (name) => {
    expect(visibleLiterals(readFileSync(APP + name, "utf8"))).toEqual([]);
  });
});

test("every ruling of the referee has a text", () => {
  const code = files(RULES, ".rs")
    .filter((name) => !name.startsWith("scenarios") && name !== "request.rs")
    .map((name) => readFileSync(RULES + name, "utf8").split("#[cfg(test)]")[0]!)
    .join("\n");
  const fouls = /fn words\(self\)[^]*?\n {4}\}\n/.exec(
    readFileSync(`${RULES}ruling.rs`, "utf8"),
  )![0];
  const said = [
    ...[...fouls.matchAll(/=> "([^"]+)"/g)],
    ...[...code.matchAll(/(?:won|choice|lost)\([^;]*?"([a-z][^"]* [^"]*)"\)/g)],
    ...[...code.matchAll(/why(?: =|:) "([^"]+)"/g)],
  ].map(([, text]) => text!);
  expect(said.length).toBeGreaterThan(30);
  expect([...new Set(said)].filter((text) => !keyOf(text, "referee."))).toEqual([]);
});

describe("a text", () => {
  test("has its placeholders filled in, in the order of its language", () => {
    const texts = (["en", "de", "zh"] as const).map((language: Language) => {
      setLanguage(language);
      return t("chance.failed", { failed: 1, count: 2, why: "{count}" });
    });
    expect(texts[0]).toMatch(/^1 of 2 .*\{count\}$/);
    expect(texts[1]).toMatch(/^1 von 2 /);
    expect(texts[2]).toMatch(/^2 种变化中有 1 种/);
  });

  test("has the plural form of its language", () => {
    expect([1, 2].map((count) => t("events.count", { count }))).toEqual(["1 event", "2 events"]);
    setLanguage("de");
    expect([1, 0].map((count) => t("events.count", { count }))).toEqual([
      "1 Ereignis",
      "0 Ereignisse",
    ]);
    setLanguage("zh");
    expect(t("events.count", { count: 1 })).toBe("1 个事件");
  });

  test("has numbers and lists as its language writes them", () => {
    expect([decimal(1234.5, 2), decimal(-0.001, 1), list(["a", "b", "c"])]).toEqual([
      "1234.50",
      "0.0",
      "a, b and c",
    ]);
    setLanguage("de");
    expect([decimal(1234.5, 2), list(["a", "b", "c"])]).toEqual(["1234,50", "a, b und c"]);
  });
});

test("the first known language of the browser's list is chosen, else English", () => {
  expect(preferred(["fr-FR", "zh-CN", "de"])).toBe("zh");
  expect(preferred(["de-AT"])).toBe("de");
  expect(preferred(["fr"])).toBe("en");
  expect(preferred([])).toBe("en");
});
