import { afterEach, expect, test } from "vitest";
import {
  ballName,
  distinctNames,
  playedName,
  playedNames,
  shortName,
} from "../../../src/app/common/shot-words.ts";
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

test("rows of a table give several reds their numbers, and the white its name beside a struck yellow", () => {
  expect(distinctNames(["cue", "red-1", "red-2"], "cue")).toEqual([
    "the cue ball",
    "red 1",
    "red 2",
  ]);
  expect(distinctNames(["cue", "yellow", "red-1"], "yellow")).toEqual([
    "the white",
    "the yellow",
    "a red",
  ]);
});

test.each([
  ["en", ["9", "cue ball", "red 3"]],
  ["de", ["9", "Spielball", "Rote 3"]],
  ["zh", ["9", "母球", "红球3"]],
] as const)("a small button names a ball without an article: %s", (language, names) => {
  setLanguage(language);
  expect(["9", "cue", "red-3"].map(shortName)).toEqual(names);
});
