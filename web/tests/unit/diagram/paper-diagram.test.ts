import { expect, test } from "vitest";
import { namesOf } from "../../../src/app/diagram/paper-diagram.ts";

test("balls have their numbers or the first letters of their colours", () => {
  expect(namesOf(["cue", "7", "12"])).toEqual(["", "7", "12"]);
  expect(namesOf(["cue", "yellow", "red"])).toEqual(["", "Y", "R"]);
  expect(namesOf(["brown", "blue", "black", "green"])).toEqual(["Br", "Blu", "Bla", "G"]);
});

test("several balls of one colour have no letter", () => {
  expect(namesOf(["red-1", "red-2", "pink"])).toEqual(["", "", "P"]);
});
