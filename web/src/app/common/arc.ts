/** Corners of an arc of a circle, for areas of the cloth. */

import type { Point } from "../../engine/index.ts";

const CORNERS = 48;

/** From the angle `from` to `to`, rad counter-clockwise from +x; a whole circle by default. */
export function arc([x, y]: Point, radius: number, from = 0, to = 2 * Math.PI): Point[] {
  return Array.from({ length: CORNERS + 1 }, (_, k) => {
    const angle = from + ((to - from) * k) / CORNERS;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)] as const;
  });
}
