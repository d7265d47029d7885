import { expect, test } from "vitest";
import { round, speedFrom, speedIn, SPEED_UNITS } from "../../../src/app/common/units.ts";

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
