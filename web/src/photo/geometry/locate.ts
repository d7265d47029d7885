/** Where the balls of a photo lie, and how exactly this is known. */

import type { Point } from "../../engine/index.ts";
import { shifted, TAP_ERROR, type Calibration } from "./calibrate.ts";
import { meet } from "./camera.ts";

/** A place on the table and its uncertainty. */
export interface Estimate {
  /** m. */
  readonly position: Point;
  /** Root mean square error, m. */
  readonly error: number;
}

/** Steps of numerical derivatives: a pixel, and a share of each parameter. */
const PIXEL = 1;
const PARAMETER = 1e-5;

/**
 * The place of a ball of `radius` (m) whose centre is seen at `pixel`: its centre lies that high above the
 * bed. Null if the pixel does not show the bed's plane.
 *
 * @param deviation - Of the pixel, as a share of the photo's width.
 */
export function locate(
  { camera, covariance }: Calibration,
  pixel: Point,
  radius: number,
  deviation = TAP_ERROR,
): Estimate | null {
  const position = meet(camera, pixel, radius);
  if (!position) return null;
  const by = (near: Point | null, step: number): Point =>
    near ? [(near[0] - position[0]) / step, (near[1] - position[1]) / step] : [Infinity, Infinity];
  const parameters = covariance.map((_, j) =>
    by(meet(shifted(camera, j, PARAMETER), pixel, radius), PARAMETER),
  );
  const pixels = [
    by(meet(camera, [pixel[0] + PIXEL, pixel[1]], radius), PIXEL),
    by(meet(camera, [pixel[0], pixel[1] + PIXEL], radius), PIXEL),
  ];
  const tap = deviation * 2 * camera.center[0];
  let variance = 0;
  for (const axis of [0, 1] as const) {
    for (const column of pixels) variance += (tap * column[axis]) ** 2;
    covariance.forEach((row, i) => {
      row.forEach((value, j) => {
        variance += value * parameters[i]![axis] * parameters[j]![axis];
      });
    });
  }
  return { position, error: Math.sqrt(variance) };
}
