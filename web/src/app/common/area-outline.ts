/** Areas of goals on a table: outline, mark and size. */

import type { DrawnMark, Geometry, GoalArea, Point } from "../../engine/index.ts";
import { arc } from "./arc.ts";

/** Its corners, m. */
export function outlineOf(area: GoalArea, { size, markings }: Geometry): readonly Point[] {
  if ("outline" in area) return area.outline;
  if ("center" in area) return arc(area.center, area.radius);
  if ("from" in area) {
    const { from, to } = area;
    return [from, [to[0], from[1]], to, [from[0], to[1]]];
  }
  const { head_string: line, d_radius: radius } = markings!;
  return arc([size![0] / 2, line!], radius!, Math.PI);
}

/** The area as it is drawn. */
export function markOf(area: GoalArea, geometry: Geometry): DrawnMark {
  return "center" in area
    ? { kind: "circle", color: "blue", ...area }
    : { kind: "area", color: "blue", outline: outlineOf(area, geometry) };
}

/** Its size, m². */
export function sizeOf(area: GoalArea, geometry: Geometry): number {
  const corners = outlineOf(area, geometry);
  const twice = corners.map(([x, y], k) => {
    const [u, v] = corners.at(k - 1)!;
    return u * y - x * v;
  });
  return Math.abs(twice.reduce((sum, one) => sum + one, 0)) / 2;
}
