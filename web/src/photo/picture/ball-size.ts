/** How large a ball is in a photo, compared with what the table's calibration predicts. */

import type { Point } from "../../engine/index.ts";
import type { Camera } from "../geometry/camera.ts";
import { contrast } from "./contrast.ts";
import { outline } from "./ball-outline.ts";
import type { Pixels } from "./pixels.ts";

/** Range and step of the searched sizes: a pool ball on a 12-foot table would be 0.6 of its size. */
const LEAST = 0.55;
const MOST = 1.8;
const STEP = 0.02;
/** How far the centre may be from the one that was found for the predicted size, in radii. */
const SHIFTS = [-0.2, 0, 0.2];

/** The size at which the outline around `center` has the most contrast, 1 as predicted; null if unseen. */
export function relativeSize(
  pixels: Pixels,
  camera: Camera,
  center: Point,
  radius: number,
): number | null {
  const points = outline(camera, center, radius);
  if (!points) return null;
  const reach = Math.hypot(...points[0]!.offset);
  let best = { size: 1, value: -1 };
  for (let size = LEAST; size <= MOST; size += STEP) {
    const scaled = points.map((point) => ({
      ...point,
      offset: [size * point.offset[0], size * point.offset[1]] as const,
    }));
    for (const dx of SHIFTS) {
      for (const dy of SHIFTS) {
        const at: Point = [center[0] + reach * dx, center[1] + reach * dy];
        const value = contrast(pixels, scaled, at);
        if (value > best.value) best = { size, value };
      }
    }
  }
  return best.size;
}
