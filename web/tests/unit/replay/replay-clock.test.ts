import { describe, expect, test } from "vitest";
import {
  advance,
  LONGEST_FRAME,
  Pace,
  PICTURES_PER_READING,
  RATES,
  STROKE,
  strokePull,
} from "../../../src/app/replay/replay-clock.ts";

describe("the clock of the replay", () => {
  test("shows the same time after a second at every frame rate", () => {
    for (const rate of RATES) {
      for (const frames of [10, 60, 144]) {
        let time = 0;
        for (let i = 0; i < frames; i++) time = advance(time, 1 / frames, rate, 10);
        expect(time).toBeCloseTo(rate, 12);
      }
    }
  });

  test("stops at the end of the shot", () => {
    expect(advance(0.9, 0.2, 1, 1)).toBe(1);
    expect(advance(1, 0.2, 1, 1)).toBe(1);
  });

  test("does not jump after the page was paused, nor run backwards with the wall clock", () => {
    expect(advance(1, 3600, 0.5, 10)).toBe(1 + LONGEST_FRAME * 0.5);
    expect(advance(1, -5, 1, 10)).toBe(1);
  });

  test("updates the text at every sixth picture", () => {
    const pace = new Pace();
    const due = Array.from({ length: 3 * PICTURES_PER_READING }, () => pace.due());
    expect(due.filter(Boolean)).toHaveLength(3);
    expect(due[PICTURES_PER_READING - 1]).toBe(true);
  });
});

describe("the stroke of the cue", () => {
  test("begins where the cue was aimed, goes back, and ends at the ball", () => {
    expect(strokePull(STROKE, 0.1)).toBeCloseTo(0.1, 12);
    expect(strokePull(STROKE / 2, 0.1)).toBeCloseTo(0.15, 12);
    expect(strokePull(0, 0.1)).toBe(0);
  });

  test("is fastest at the ball", () => {
    const ways = [0.2, 0.15, 0.1, 0.05, 0].map((left) => strokePull(left, 0.1));
    const steps = ways.slice(1).map((pull, k) => ways[k]! - pull);
    expect(steps.toSorted((a, b) => a - b)).toEqual(steps);
  });
});
