import { expect, test } from "vitest";
import { load } from "../../../src/engine/index.ts";
import {
  estimatedPercent,
  round,
  speedFrom,
  speedIn,
  SPEED_UNITS,
  TIP,
} from "../../../src/app/common/units.ts";

test("a speed converted to a unit and back is unchanged", () => {
  expect(speedIn("km/h", 10)).toBeCloseTo(36, 12);
  expect(speedIn("mph", 10)).toBeCloseTo(22.3694, 4);
  for (const unit of Object.keys(SPEED_UNITS) as (keyof typeof SPEED_UNITS)[]) {
    expect(speedFrom(unit, speedIn(unit, 3.21))).toBeCloseTo(3.21, 12);
  }
});

test("numbers are rounded without a negative zero", () => {
  expect(round(0.1 + 0.2, 3)).toBe(0.3);
  expect(Object.is(round(-0.0001, 2), 0)).toBe(true);
});

test("the page and Python count English in the same tips", async () => {
  // Seen: two tips of follow on the page were ¾ of a tip in Python, whose tip was as wide as a cue's.
  expect(TIP).toBe((await load()).tip);
});

// Seen: a machine that was "100 % to stay at the table" missed.
test("an estimated chance is never a certainty", () => {
  expect([0, 0.004, 0.5, 0.994, 0.996, 1].map(estimatedPercent)).toEqual([0, 0, 50, 99, 99, 99]);
});
