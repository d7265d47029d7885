/** How clearly an outline stands out in a photo. */

import type { Point } from "../../engine/index.ts";
import { meanRadius, type OutlinePoint } from "./ball-outline.ts";
import { sample, type Pixels } from "./pixels.ts";

/** Half the width over which an edge is measured, in radii and at least in pixels. */
const EDGE = 0.1;
const LEAST_EDGE = 1;
/** A stronger contrast counts as this one (of 255): lamps and rails may not outweigh the outline. */
const STRONGEST = 120;
/** Points below this share of the radius border the ball's shadow on the cloth, and count less. */
const SHADE = -0.5;
const SHADED = 0.4;

/** A difference this far above the grain of the cloth is an edge, of 255. */
const STEP = 4;

/** Weighted mean contrast across the outline of a ball at `center`, of 255. */
export function contrast(pixels: Pixels, points: readonly OutlinePoint[], center: Point): number {
  let [sum, total] = [0, 0];
  across(pixels, points, center, (difference, weight) => {
    total += weight;
    sum += weight * Math.min(STRONGEST, difference);
  });
  return sum / total;
}

/** Weighted share of an outline across which the contrast is clear: a straight edge crosses only a part. */
export function closedShare(
  pixels: Pixels,
  points: readonly OutlinePoint[],
  center: Point,
  grain: number,
): number {
  let [sum, total] = [0, 0];
  across(pixels, points, center, (difference, weight) => {
    total += weight;
    if (difference > grain + STEP) sum += weight;
  });
  return sum / total;
}

/** Reports the contrast across each point of an outline, of 255, and its weight. */
function across(
  pixels: Pixels,
  points: readonly OutlinePoint[],
  center: Point,
  report: (difference: number, weight: number) => void,
): void {
  const edge = Math.max(LEAST_EDGE, EDGE * meanRadius(points));
  for (const { offset, normal, height } of points) {
    const [x, y] = [center[0] + offset[0], center[1] + offset[1]];
    const isSeen =
      sample(pixels, x - edge * normal[0], y - edge * normal[1], INNER) &&
      sample(pixels, x + edge * normal[0], y + edge * normal[1], OUTER);
    const [r, g, b] = [0, 1, 2].map((c) => OUTER[c]! - INNER[c]!) as [number, number, number];
    report(isSeen ? Math.hypot(r, g, b) : 0, height < SHADE ? SHADED : 1);
  }
}

const INNER = new Float64Array(3);
const OUTER = new Float64Array(3);
