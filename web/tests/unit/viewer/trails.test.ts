import { expect, test } from "vitest";
import { shadow } from "../../../src/viewer/overlay/ball-paths.ts";
import { between, parts, trail } from "../../../src/viewer/overlay/trails.ts";

const R = 0.028575;
/** A ball that rolls for a second, flies for a second and rolls again: x, y, z, t per point. */
const JUMP = [0, 0, R, 0, 1, 0, R, 1, 1.5, 0, R + 0.1, 1.5, 2, 0, R, 2, 3, 0, R, 3];

test("a jump splits a path into rolling, flight and rolling", () => {
  const found = parts(JUMP, R);
  expect(found.map(({ flies }) => flies)).toEqual([false, true, false]);
  expect(found.map(({ points }) => [points[0], points.at(-4)])).toEqual([
    [0, 1],
    [1, 2],
    [2, 3],
  ]);
});

test("hops that cannot be seen do not count as flight", () => {
  expect(parts([0, 0, R, 0, 1, 0, R + 0.002, 1, 2, 0, R, 2], R)).toHaveLength(1);
});

test("the shadow of a flight is on the cloth and beside the ball by its height", () => {
  const [x, y, z, t] = shadow([1, 2, R + 0.1, 0.5], R) as [number, number, number, number];
  expect(z).toBeLessThan(0.002);
  expect(t).toBe(0.5);
  expect(Math.hypot(x - 1, y - 2)).toBeGreaterThan(0.03);
  expect(shadow([1, 2, R, 0.5], R).slice(0, 2)).toEqual([1, 2]);
});

test("the part of a path between two times ends at exact places", () => {
  const part = between(JUMP, 0.25, 1.25);
  expect(part.slice(0, 4)).toEqual([0.25, 0, R, 0.25]);
  expect(part.at(-4)).toBeCloseTo(1.25, 12);
  expect(between(JUMP, 3.5, 4)).toEqual([]);
});

test("a trail covers the last second and weakens with age", () => {
  const pieces = trail(JUMP, 1);
  expect(pieces[0]!.points.at(-1)).toBe(1);
  expect(pieces.at(-1)!.points[3]).toBe(0);
  const strengths = pieces.map(({ strength }) => strength);
  expect(strengths).toEqual([...strengths].sort((a, b) => b - a));
  expect(trail(JUMP, 4.1)).toEqual([]);
});
