import { expect, test } from "vitest";
import {
  anglesOf,
  automatic,
  azimuthOf,
  changed,
  elevationOf,
  isAutomatic,
} from "../../../src/app/document/strike-angles.ts";

const RADIAN = { ball: "cue", speed: 2, azimuth: 1.234567890123456, elevation: 0.1 };
const DEGREE = { ball: "cue", speed: 2, azimuth_deg: 71.5 };

test("angles in radians keep their bits, and are shown in degrees", () => {
  expect(anglesOf(RADIAN)).toEqual({ azimuth: 1.234567890123456, elevation: 0.1 });
  expect(azimuthOf(RADIAN)).toBeCloseTo(70.73553, 5);
  expect(elevationOf(RADIAN, 0)).toBeCloseTo(5.72958, 5);
});

test("angles in degrees are shown as they are", () => {
  expect(azimuthOf(DEGREE)).toBe(71.5);
  expect(elevationOf({ ...DEGREE, elevation_deg: 0 }, 0.2)).toBe(0);
  expect(anglesOf({ ...DEGREE, elevation_deg: 0 })).toEqual({
    azimuth: (71.5 * Math.PI) / 180,
    elevation: 0,
  });
});

test("an omitted elevation is automatic, and the engine's angle is shown", () => {
  expect([DEGREE, RADIAN, { ...DEGREE, elevation_deg: 0 }].map(isAutomatic)).toEqual([
    true,
    false,
    false,
  ]);
  expect(elevationOf(DEGREE, Math.PI / 60)).toBeCloseTo(3, 12);
  expect(anglesOf(DEGREE).elevation).toBeUndefined();
  expect(automatic({ ...DEGREE, elevation_deg: 20 })).toEqual(DEGREE);
  expect(isAutomatic(changed(DEGREE, { elevation_deg: 20 }))).toBe(false);
});

test("a new angle in degrees replaces the one in radians, and no other", () => {
  const { azimuth, ...rest } = RADIAN;
  expect(azimuth).toBeGreaterThan(0);
  expect(changed(RADIAN, { azimuth_deg: 10 })).toEqual({ ...rest, azimuth_deg: 10 });
  expect(changed(RADIAN, { speed: 3 })).toEqual({ ...RADIAN, speed: 3 });
});
