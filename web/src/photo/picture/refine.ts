/** Moves a tap to the centre of the ball that is seen there. */

import type { Point } from "../../engine/index.ts";
import type { Camera } from "../geometry/camera.ts";
import { outline, type OutlinePoint } from "./outline.ts";
import { sample, type Pixels } from "./pixels.ts";

/** Standard deviation of a refined centre, pixels: measured on rendered photos (docs/page.md). */
export const REFINED_ERROR = 0.6;

/** How far from the tap a ball's centre is searched, in radii: less than the way to a neighbour. */
const REACH = 0.7;
/** Step of the search, pixels. */
const STEP = 0.5;
/** Half the width over which an edge is measured, in radii and at least in pixels. */
const EDGE = 0.1;
const LEAST_EDGE = 1;
/** A stronger contrast counts as this one (of 255): lamps and rails may not outweigh the outline. */
const STRONGEST = 120;
/** Points below this share of the radius border the ball's shadow on the cloth, and count less. */
const SHADE = -0.5;
const SHADED = 0.4;
/** Share of the contrast that counts as lost at the end of the search: of two outlines the nearer wins. */
const FAR = 0.3;
/** Least mean contrast of an outline (of 255): more than twice the noise of a phone's picture. */
const WEAKEST = 12;

/**
 * The centre of the ball of `radius` (m) near a tap: where its outline has the strongest contrast. Null if
 * no outline stands out, so that the tap itself is the best estimate.
 */
export function refine(pixels: Pixels, camera: Camera, tap: Point, radius: number): Point | null {
  const points = outline(camera, tap, radius);
  if (!points) return null;
  const size = points.reduce((sum, { offset }) => sum + Math.hypot(...offset), 0) / points.length;
  const edge = Math.max(LEAST_EDGE, EDGE * size);
  const steps = Math.ceil((REACH * size) / STEP);
  let best: { i: number; j: number; value: number } | null = null;
  const value = (i: number, j: number) =>
    contrast(pixels, points, [tap[0] + STEP * i, tap[1] + STEP * j], edge) *
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

/** Weighted mean contrast across the outline of a ball at `center`, of 255. */
function contrast(
  pixels: Pixels,
  points: readonly OutlinePoint[],
  center: Point,
  edge: number,
): number {
  let [sum, total] = [0, 0];
  for (const { offset, normal, height } of points) {
    const [x, y] = [center[0] + offset[0], center[1] + offset[1]];
    const weight = height < SHADE ? SHADED : 1;
    total += weight;
    const inside = sample(pixels, x - edge * normal[0], y - edge * normal[1], INNER);
    if (!inside || !sample(pixels, x + edge * normal[0], y + edge * normal[1], OUTER)) continue;
    const [r, g, b] = [0, 1, 2].map((c) => OUTER[c]! - INNER[c]!) as [number, number, number];
    sum += weight * Math.min(STRONGEST, Math.hypot(r, g, b));
  }
  return sum / total;
}

const INNER = new Float64Array(3);
const OUTER = new Float64Array(3);

/** Where the parabola through three neighbouring values is highest, in steps from the middle one. */
function vertex(before: number, middle: number, after: number): number {
  const curvature = before - 2 * middle + after;
  return curvature < 0 ? Math.max(-1, Math.min(1, (before - after) / (2 * curvature))) : 0;
}
