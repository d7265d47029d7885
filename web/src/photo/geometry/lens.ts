/** How much a lens bends straight lines. */

import type { Point } from "../../engine/index.ts";
import { project, type Camera } from "./camera.ts";

/** Points along a rail. */
const POINTS = 16;

/** Largest distance of a rail in the photo from the line between its ends, as a share of that line. */
export function bow(camera: Camera, [width, length]: Point): number {
  const corners: readonly Point[] = [
    [0, 0],
    [width, 0],
    [width, length],
    [0, length],
  ];
  return Math.max(...corners.map((from, k) => bent(camera, from, corners[(k + 1) % 4]!)));
}

function bent(camera: Camera, from: Point, to: Point): number {
  const seen = Array.from({ length: POINTS + 1 }, (_, k) => {
    const share = k / POINTS;
    const place = [from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])];
    return project(camera, [place[0]!, place[1]!, 0]);
  });
  const [first, last] = [seen[0], seen[POINTS]];
  if (!first || !last) return 0;
  const [x, y] = [last[0] - first[0], last[1] - first[1]];
  const length = Math.hypot(x, y);
  const away = seen.map((pixel) =>
    pixel ? Math.abs((pixel[0] - first[0]) * y - (pixel[1] - first[1]) * x) / length : 0,
  );
  return Math.max(...away) / length;
}
