/** Moves a tap to the centre of the ball that is seen there. */

import type { Point } from "../../engine/index.ts";
import type { Camera } from "../geometry/camera.ts";
import { contrast } from "./contrast.ts";
import { meanRadius, outline } from "./ball-outline.ts";
import type { Pixels } from "./pixels.ts";

/**
 * Standard deviation of a refined centre, pixels: between the median and the 95th percentile of the
 * distances on rendered photos (docs/photo.md).
 */
export const REFINED_ERROR = 0.6;

/** How far from an exact tap a ball's centre is searched, in radii: less than the way to a neighbour. */
const REACH = 0.7;
/** How far it is searched from the tap of a finger at most, in radii. */
const LONGEST_REACH = 1.5;
/** Step of the search, pixels. */
const STEP = 0.5;
/** Share of the contrast that counts as lost at the end of the search: of two outlines the nearer wins. */
const FAR = 0.3;
/** Least mean contrast of an outline (of 255): more than twice the noise of a phone's picture. */
const WEAKEST = 12;

/** What is searched near a tap. */
export interface Search {
  /** Of the ball, m. */
  readonly radius: number;
  /** How far the tap may be from the ball's centre, pixels; 0: a small share of the radius. */
  readonly slack: number;
  /** How far an exact tap may be from it, in radii; by default `REACH`. */
  readonly reach?: number;
}

/**
 * The centre of the ball near a tap: where its outline has the strongest contrast. Null if no outline
 * stands out, so that the tap itself is the best estimate.
 */
export function refine(
  pixels: Pixels,
  camera: Camera,
  tap: Point,
  { radius, slack, reach: near = REACH }: Search,
): Point | null {
  const points = outline(camera, tap, radius);
  if (!points) return null;
  const size = meanRadius(points);
  const reach = Math.max(near * size, Math.min(LONGEST_REACH * size, slack));
  const steps = Math.ceil(reach / STEP);
  let best: { i: number; j: number; value: number } | null = null;
  const value = (i: number, j: number) =>
    contrast(pixels, points, [tap[0] + STEP * i, tap[1] + STEP * j]) *
    (1 - (FAR * (i * i + j * j)) / steps ** 2);
  for (let i = -steps; i <= steps; i += 1) {
    for (let j = -steps; j <= steps; j += 1) {
      if (i * i + j * j > steps * steps) continue;
      const found = value(i, j);
      if (!best || found > best.value) best = { i, j, value: found };
    }
  }
  if (!best || best.value < WEAKEST) return null;
  const { i, j } = best;
  const x = i + vertex(value(i - 1, j), best.value, value(i + 1, j));
  const y = j + vertex(value(i, j - 1), best.value, value(i, j + 1));
  return [tap[0] + STEP * x, tap[1] + STEP * y];
}

/** Where the parabola through three neighbouring values is highest, in steps from the middle one. */
function vertex(before: number, middle: number, after: number): number {
  const curvature = before - 2 * middle + after;
  return curvature < 0 ? Math.max(-1, Math.min(1, (before - after) / (2 * curvature))) : 0;
}
