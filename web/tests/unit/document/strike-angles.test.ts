import { expect, test } from "vitest";
import {
  anglesOf,
  azimuthOf,
  changed,
  elevationOf,
} from "../../../src/app/document/strike-angles.ts";

const RADIAN = { ball: "cue", speed: 2, azimuth: 1.234567890123456, elevation: 0.1 };
const DEGREE = { ball: "cue", speed: 2, azimuth_deg: 71.5 };

test("angles in radians keep their bits, and are shown in degrees", () => {
  expect(anglesOf(RADIAN)).toEqual({ azimuth: 1.234567890123456, elevation: 0.1 });
  expect(azimuthOf(RADIAN)).toBeCloseTo(70.73553, 5);
  expect(elevationOf(RADIAN)).toBeCloseTo(5.72958, 5);
});

test("angles in degrees are shown as they are; the elevation is 0 by default", () => {
  expect([azimuthOf(DEGREE), elevationOf(DEGREE)]).toEqual([71.5, 0]);
  expect(anglesOf(DEGREE)).toEqual({ azimuth: (71.5 * Math.PI) / 180, elevation: 0 });
});

test("a new angle in degrees replaces the one in radians, and no other", () => {
  const { azimuth, ...rest } = RADIAN;
  expect(azimuth).toBeGreaterThan(0);
  expect(changed(RADIAN, { azimuth_deg: 10 })).toEqual({ ...rest, azimuth_deg: 10 });
  expect(changed(RADIAN, { speed: 3 })).toEqual({ ...RADIAN, speed: 3 });
});
