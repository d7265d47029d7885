/** Pockets under a point of the table. */

import type { PocketName, Point, Shot } from "../../engine/index.ts";

/** A pocket is tapped within this multiple of its radius: it is small for a finger. */
const POCKET_REACH = 2;

/** The pocket at a point of the table; null if there is none. */
export function pocketAt({ geometry }: Shot, [x, y]: Point): PocketName | null {
  const found = geometry.pockets.find(
    ({ center, radius }) => Math.hypot(x - center[0], y - center[1]) < POCKET_REACH * radius,
  );
  return found?.name ?? null;
}
