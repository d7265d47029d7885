import { expect, test } from "vitest";
import { IVORY, look } from "../../../src/viewer/balls/look.ts";

test("a pool ball has the colour of its number, and numbers above eight are striped", () => {
  expect(look("3", 0)).toMatchObject({ striped: false, label: "3", dots: "" });
  expect(look("11", 0)).toMatchObject({ body: look("3", 0).body, striped: true, label: "11" });
  expect(look("8", 0).striped).toBe(false);
  expect(look("15", 0).body).toBe(look("7", 0).body);
});

test("a number that no pool ball has is treated as a name", () => {
  expect(look("16", 0).body).toBe(look("something", 0).body);
  expect(look("0", 0).striped).toBe(false);
});

test("the name of a colour may end in a number", () => {
  for (const id of ["red", "red4", "red-4", "Red 4"])
    expect(look(id, 0).body).toBe(look("red", 9).body);
});

test("cue ball and carom balls have dots that show the spin, snooker balls have none", () => {
  expect(look("cue", 0)).toMatchObject({ body: IVORY, label: "" });
  expect(look("cue", 0).dots).not.toBe("");
  expect(look("yellow", 1).dots).toBe("");
  expect(look("yellow", 1, true).dots).not.toBe("");
});

test("balls with other names have a colour by their index and a label of two letters", () => {
  expect(look("first", 0).body).not.toBe(look("second", 1).body);
  expect(look("first", 0).label).toBe("fi");
});

test("names of JavaScript's built-in properties are ordinary names", () => {
  expect(look("constructor", 0).label).toBe("co");
});
