/** What is under a pointer: pocket or rail of a table. */

import { beyond } from "./table/table-outline.ts";
import type { Geometry, Point } from "./viewer-types.ts";

/** Reach of a pocket beyond its edge, CSS pixels: fingers are wide. */
const POCKET_REACH = 24;

/**
 * The pocket nearest to a pointer, within its radius and some pixels more; null if there is none.
 *
 * @param project - Position of a place (m) on the screen, px; null if it is behind the camera.
 */
export function pocketAt(
  [x, y]: Point,
  { pockets, cushion_height: height }: Geometry,
  project: (x: number, y: number, z: number) => readonly [number, number] | null,
): string | null {
  let best: string | null = null;
  let least = POCKET_REACH;
  for (const { name, center, radius } of pockets) {
    const [middle, edge] = [0, radius].map((r) => project(center[0] + r, center[1], height));
    if (!middle || !edge) continue;
    const size = Math.hypot(edge[0] - middle[0], edge[1] - middle[1]);
    const gap = Math.hypot(middle[0] - x, middle[1] - y) - size;
    if (gap <= least) [best, least] = [name, gap];
  }
  return best;
}

/** The rail whose cushion or wood is at a place (m); null on the bed and beyond the table. */
export function railAt(
  place: Point,
  { size, cushions, rail_width: width = 0 }: Geometry,
): string | null {
  if (!size) return null;
  const outside = beyond(place, size);
  if (outside < 0 || outside > width) return null;
  let best: string | null = null;
  let least = Infinity;
  for (const { part, rail, start, end } of cushions) {
    if (part !== "nose") continue;
    const gap = toSegment(place, start, end);
    if (gap < least) [best, least] = [rail, gap];
  }
  return best;
}

function toSegment([x, y]: Point, [ax, ay]: Point, [bx, by]: Point): number {
  const [dx, dy] = [bx - ax, by - ay];
  const t = ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy);
  const along = Math.min(1, Math.max(0, t));
  return Math.hypot(x - ax - along * dx, y - ay - along * dy);
}
