import { expect, test } from "vitest";
import { azimuthTo, sweep, wrap } from "../../../src/app/common/angles.ts";

test("a direction is counter-clockwise from +x, in [0, 360)", () => {
  expect(azimuthTo([0, 0], [1, 0])).toBe(0);
  expect(azimuthTo([0, 0], [0, 2])).toBe(90);
  expect(azimuthTo([1, 1], [0, 0])).toBe(225);
  expect(azimuthTo([0, 0], [1, -1e-9])).toBe(0);
  expect(wrap(-0.00001)).toBe(0);
  expect(wrap(725.5)).toBe(5.5);
});

test("a sweep is the smaller angle, at any distance", () => {
  expect(sweep([0, 0], [1, 0], [0, 5])).toBeCloseTo(90, 12);
  expect(sweep([0, 0], [0, 5], [1, 0])).toBeCloseTo(-90, 12);
  expect(sweep([2, 2], [1, 2.1], [1, 1.9])).toBeCloseTo((2 * Math.atan(0.1) * 180) / Math.PI, 12);
  expect(sweep([0, 0], [0, 0], [1, 1])).toBe(0);
});

test("the sweeps of the parts of a path add up to the sweep of the whole path", () => {
  const way = Array.from(
    { length: 40 },
    (_, k) => [Math.cos(k / 10), 2 * Math.sin(k / 10)] as const,
  );
  const parts = way.slice(1).map((point, k) => sweep([0, 0], way[k]!, point));
  const whole = sweep([0, 0], way[0]!, way.at(-1)!);
  const sum = parts.reduce((a, b) => a + b, 0);
  expect(wrap(sum)).toBeCloseTo(wrap(whole), 3);
});
