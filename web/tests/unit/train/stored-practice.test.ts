import { expect, test } from "vitest";
import { practiceOfText } from "../../../src/app/train/stored-practice.ts";

const running = {
  drill: "stop",
  place: "page",
  errors: null,
  puzzle: null,
  points: [1, 0],
  shots: 0,
  left: [],
  said: "Made.",
  result: null,
  solved: false,
};
const set = { format: "carom-shot/1", table: "wpa-9ft", balls: [], strike: { ball: "cue" } };
const stored = { kept: { running, page: { set, seed: 7 }, shown: true }, before: "#s=1.abc" };

test("a stored drill is read back", () => {
  expect(practiceOfText(JSON.stringify(stored))).toEqual(stored);
});

test.each([
  ["{oops"],
  ["5"],
  ["null"],
  [JSON.stringify({ kept: null, before: null })],
  [JSON.stringify({ ...stored, before: 5 })],
  [JSON.stringify({ ...stored, kept: { ...stored.kept, page: {} } })],
  [JSON.stringify({ ...stored, kept: { ...stored.kept, page: { set: {}, seed: 1 } } })],
  ...(
    [
      { drill: 5 },
      { place: "moon" },
      { points: undefined },
      { points: ["1"] },
      { left: [1] },
      { puzzle: {} },
      { puzzle: { drill: {}, date: "2026-11-24" } },
      { puzzle: { id: "cut-17" } },
      { hints: "1" },
      { seen: 1 },
      { said: undefined },
    ] as const
  ).map((change) => [
    JSON.stringify({ ...stored, kept: { ...stored.kept, running: { ...running, ...change } } }),
  ]),
])("damaged: %s", (text) => {
  expect(practiceOfText(text)).toBeNull();
});
