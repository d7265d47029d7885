import { afterEach, expect, test } from "vitest";
import { ballName, playedName, playedNames } from "../../../src/app/common/shot-words.ts";
import { setLanguage } from "../../../src/app/words/translate.ts";

afterEach(() => setLanguage("en"));

test.each([
  ["en", "a red", ["4 reds", "the blue"]],
  ["de", "Rote", ["4 Rote", "Blaue"]],
  ["zh", "红球", ["4颗红球", "蓝球"]],
] as const)("one of many reds has no number in the words of players: %s", (language, one, many) => {
  setLanguage(language);
  expect(playedName("red-15")).toBe(one);
  expect(playedNames(["red-15", "blue", "red-3", "red-4", "red-5"])).toEqual(many);
  expect(playedNames(["red-15", "blue"])).toEqual([one, many[1]]);
});

test("a list of balls tells the reds apart", () => {
  expect(ballName("red-15")).toBe("red 15");
  expect(ballName("red-3")).toBe("red 3");
});

test("the red of carom and a numbered ball have one name", () => {
  for (const id of ["red", "9", "cue"]) expect(playedName(id)).toBe(ballName(id));
});
