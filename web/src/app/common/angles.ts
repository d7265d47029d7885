/** Angles: degrees and radians, and aiming in the plane of the table, in degrees as in shot files. */

import type { Point } from "../../engine/index.ts";

/**
 * Decimals of an azimuth that the page sets. 0.0001° moves the aim by 6 µm over the length of a
 * snooker table; more decimals would only make links longer.
 */
export const AZIMUTH_DIGITS = 4;

export const toDegrees = (radians: number): number => radians * (180 / Math.PI);
export const toRadians = (degrees: number): number => degrees * (Math.PI / 180);

/** A length (m) rounded to 0.1 mm, finer than a hand can place a ball. */
export function round4(metres: number): number {
  return Math.round(metres * 1e4) / 1e4;
}

/** The same direction in [0, 360), rounded to `AZIMUTH_DIGITS`. */
export function wrap(degrees: number): number {
  const scale = 10 ** AZIMUTH_DIGITS;
  const turned = Math.round((((degrees % 360) + 360) % 360) * scale) / scale;
  return turned === 360 ? 0 : turned;
}

/** Direction from one point to another, degrees counter-clockwise from +x. */
export function azimuthTo(from: Point, to: Point): number {
  return wrap(toDegrees(Math.atan2(to[1] - from[1], to[0] - from[0])));
}

/** Angle by which the direction from `center` turns between two points, in (−180, 180]. */
export function sweep(center: Point, before: Point, after: Point): number {
  const [ax, ay] = [before[0] - center[0], before[1] - center[1]];
  const [bx, by] = [after[0] - center[0], after[1] - center[1]];
  return toDegrees(Math.atan2(ax * by - ay * bx, ax * bx + ay * by));
}
