/** Where a dragged ball goes. */

import { describe, expect, test } from "vitest";
import type { Bed } from "../../../src/photo/index.ts";
import { snapped } from "../../../src/app/layout/ball-snap.ts";

const R = 0.03;
const REACH = 0.006;
/** A left and a bottom rail of 2 m whose corner is at the origin. */
const BED: Bed = {
  radius: R,
  reach: R,
  noses: [
    { axis: 0, at: 0, inward: 1, from: 0, to: 2 },
    { axis: 1, at: 0, inward: 1, from: 0, to: 2 },
  ],
};
const ball = (x: number, y: number) => ({ position: [x, y, R] as const, radius: R });
const apart = ([x, y]: readonly [number, number], [u, v]: readonly [number, number]) =>
  Math.hypot(x - u, y - v);

describe("a dragged ball", () => {
  test("stays where it is dragged if nothing is near", () => {
    expect(snapped([0.5, 0.5], BED, [ball(1, 1)], REACH)).toEqual([0.5, 0.5]);
  });

  test("goes onto a rail that is near, and no further than the rail", () => {
    expect(snapped([R + 0.004, 0.5], BED, [], REACH)).toEqual([R, 0.5]);
    expect(snapped([-0.2, 0.5], BED, [], REACH)).toEqual([R, 0.5]);
  });

  test("goes into a corner of two rails", () => {
    expect(snapped([R + 0.003, R + 0.002], BED, [], REACH)).toEqual([R, R]);
  });

  test("touches a ball that is near, to the engine's tolerance", () => {
    const place = snapped([1.05, 1.04], BED, [ball(1, 1)], REACH);
    expect(Math.abs(apart(place, [1, 1]) - 2 * R)).toBeLessThan(1e-12);
  });

  test("touches two balls that are near", () => {
    const others = [ball(1, 1), ball(1.07, 1)];
    const place = snapped([1.036, 1.05], BED, others, REACH);
    for (const { position } of others) {
      expect(Math.abs(apart(place, [position[0], position[1]]) - 2 * R)).toBeLessThan(1e-12);
    }
  });

  test("touches a ball and the rail behind it", () => {
    const place = snapped([R + 0.002, 1.062], BED, [ball(R, 1)], REACH);
    expect(place[0]).toBe(R);
    expect(place[1]).toBeCloseTo(1 + 2 * R, 12);
  });

  test("leaves a ball onto which it is dragged on the nearest side", () => {
    const place = snapped([1.01, 1], BED, [ball(1, 1)], REACH);
    expect(place[0]).toBeCloseTo(1 + 2 * R, 12);
    expect(place[1]).toBeCloseTo(1, 12);
  });

  test("is not attracted by balls that it may not touch", () => {
    const wanted = [1.063, 1] as const;
    expect(snapped(wanted, BED, [ball(1, 1)], REACH, false)).toEqual(wanted);
    expect(snapped([R + 0.004, 0.5], BED, [ball(1, 1)], REACH, false)).toEqual([R, 0.5]);
  });
});
