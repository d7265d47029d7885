import { expect, test } from "vitest";
import { IVORY, look } from "../../../src/viewer/balls/look";

test("a pool ball has its number's colour, and the ones above eight are striped", () => {
  expect(look("3", 0)).toMatchObject({ striped: false, label: "3", dots: "" });
  expect(look("11", 0)).toMatchObject({ body: look("3", 0).body, striped: true, label: "11" });
  expect(look("8", 0).striped).toBe(false);
  expect(look("15", 0).body).toBe(look("7", 0).body);
});

test("a number that no pool ball has is a name like any other", () => {
  expect(look("16", 0).body).toBe(look("something", 0).body);
  expect(look("0", 0).striped).toBe(false);
});

test("a colour's name may carry a number", () => {
  for (const id of ["red", "red4", "red-4", "Red 4"])
    expect(look(id, 0).body).toBe(look("red", 9).body);
});

test("the cue ball has dots that show its spin, a snooker ball has none, a carom ball has", () => {
  expect(look("cue", 0)).toMatchObject({ body: IVORY, label: "" });
  expect(look("cue", 0).dots).not.toBe("");
  expect(look("yellow", 1).dots).toBe("");
  expect(look("yellow", 1, true).dots).not.toBe("");
});

test("balls of other names differ by their place in the shot and bear their first two letters", () => {
  expect(look("first", 0).body).not.toBe(look("second", 1).body);
  expect(look("first", 0).label).toBe("fi");
});

test("names of the language's own objects are names like any other", () => {
  expect(look("constructor", 0).label).toBe("co");
});
