import { describe, expect, test } from "vitest";
import type { TraceEvent } from "../../../src/engine/index.ts";
import { list } from "../../../src/app/words/translate.ts";
import { eventInWords, rpm } from "../../../src/app/replay/replay-words.ts";

const event = (fields: object): TraceEvent =>
  ({ time: 0, before: [], after: [], ...fields }) as unknown as TraceEvent;

describe("an event in words", () => {
  test.each([
    [{ type: "cue-strike", balls: ["cue"] }, "cue strikes the cue ball"],
    [
      { type: "cue-strike", balls: ["cue", "1", "2"], tip_contacts: 1, pushed: false },
      "cue strikes the cue ball, which moves ball 1 and ball 2",
    ],
    [
      { type: "cue-strike", balls: ["cue", "1"], tip_contacts: 1, pushed: true },
      "cue strikes the cue ball, which moves ball 1 (push)",
    ],
    [
      { type: "cue-strike", balls: ["cue", "1"], tip_contacts: 2, pushed: true },
      "cue strikes the cue ball, which moves ball 1 (double hit, push)",
    ],
    [
      { type: "ball-collision", balls: ["cue", "1", "2"] },
      "the cue ball, ball 1 and ball 2 collide",
    ],
    [
      { type: "rail-collision", balls: ["8"], rail: "top", part: "nose" },
      "ball 8 hits the top rail",
    ],
    [
      { type: "rail-collision", balls: ["8"], rail: "left-upper", part: "point" },
      "ball 8 hits the point of the left upper rail",
    ],
    [
      { type: "pocket-collision", balls: ["9"], pocket: "top-left" },
      "ball 9 drops into the top left pocket",
    ],
    [
      { type: "motion-transition", balls: ["1"], from: "sliding", to: "rolling" },
      "ball 1 stops sliding, starts rolling",
    ],
    [
      { type: "motion-transition", balls: ["1"], from: "rolling", to: "rolling" },
      "ball 1 goes on rolling in a slower speed band",
    ],
    [
      { type: "motion-transition", balls: ["1"], from: "rolling", to: "stationary" },
      "ball 1 comes to rest",
    ],
    [
      { type: "motion-transition", balls: ["1"], from: "rolling", to: "airborne" },
      "ball 1 leaves the cloth",
    ],
    [{ type: "slate-collision", balls: ["cue"] }, "the cue ball lands"],
    [{ type: "off-table", balls: ["cue"] }, "the cue ball leaves the table"],
  ])("%o is %j", (fields, words) => {
    expect(eventInWords(event(fields))).toBe(words);
  });
});

test('a list has "and" before its last item', () => {
  expect([[], ["a"], ["a", "b"], ["a", "b", "c"]].map((items) => list(items))).toStrictEqual([
    "",
    "a",
    "a and b",
    "a, b and c",
  ]);
});

test("one turn per second is 60 rpm", () => {
  expect(rpm(2 * Math.PI)).toBeCloseTo(60, 10);
});
