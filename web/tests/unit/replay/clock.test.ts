import { describe, expect, test } from "vitest";
import {
  advance,
  LONGEST_FRAME,
  Pace,
  PICTURES_PER_READING,
  RATES,
} from "../../../src/app/replay/clock.ts";

describe("the clock of the replay", () => {
  test("shows the same time after a second, however many frames were drawn", () => {
    for (const rate of RATES) {
      for (const frames of [10, 60, 144]) {
        let time = 0;
        for (let i = 0; i < frames; i++) time = advance(time, 1 / frames, rate, 10);
        expect(time).toBeCloseTo(rate, 12);
      }
    }
  });

  test("stops at the end", () => {
    expect(advance(0.9, 0.2, 1, 1)).toBe(1);
    expect(advance(1, 0.2, 1, 1)).toBe(1);
  });

  test("does not leap after the page was asleep, nor go back when the wall clock does", () => {
    expect(advance(1, 3600, 0.5, 10)).toBe(1 + LONGEST_FRAME * 0.5);
    expect(advance(1, -5, 1, 10)).toBe(1);
  });

  test("has new words for every sixth picture, so that slow pictures need not wait for them", () => {
    const pace = new Pace();
    const told = Array.from({ length: 3 * PICTURES_PER_READING }, () => pace.due());
    expect(told.filter(Boolean)).toHaveLength(3);
    expect(told[PICTURES_PER_READING - 1]).toBe(true);
  });
});
