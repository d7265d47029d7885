/** The pose of a camera from points of a plane, for a known focal length: the start of a calibration. */

import type { Point, Vector } from "../../engine/index.ts";
import { cross, dot, type Camera, type Rotation } from "./camera.ts";
import { normal, solve } from "./linear.ts";

/** A picture for which a pose is wanted. */
export interface Lens {
  /** Focal length, pixels. */
  readonly focal: number;
  /** Principal point, pixels. */
  readonly center: Point;
}

/**
 * The camera without distortion that sees `points` (m, all at one height) at `pixels`, at least four;
 * null if three of them lie on a line.
 *
 * Source: Zhang (2000), section 3.1 and appendix A: the homography H = K [r₁ r₂ t] by least squares, then
 * r₁, r₂ and t from its columns, and r₃ = r₁ × r₂. Departures: the last entry of H is 1, because the
 * table's centre is in front of the camera; r₁ and r₂ are made orthogonal by equal turns.
 */
export function pose(
  points: readonly Vector[],
  pixels: readonly Point[],
  lens: Lens,
): Camera | null {
  const origin = mean(points);
  const h = homography(
    points.map(([x, y]) => [x - origin[0], y - origin[1]]),
    pixels.map(([u, v]) => [(u - lens.center[0]) / lens.focal, (v - lens.center[1]) / lens.focal]),
  );
  if (!h) return null;
  const column = (j: number): Vector => [h[j]!, h[3 + j]!, h[6 + j]!];
  const [a, b, c] = [column(0), column(1), column(2)];
  const scale = 2 / (Math.hypot(...a) + Math.hypot(...b));
  const rotation = orthogonal(unit(a), unit(b));
  if (!rotation) return null;
  const translation = c.map((value, i) => scale * value - dot(rotation[i]!, origin));
  return { ...lens, rotation, translation: translation as unknown as Vector, k1: 0 };
}

/** The homography from the plane to the picture, row by row. */
function homography(points: readonly Point[], pixels: readonly Point[]): number[] | null {
  const rows: number[][] = [];
  const right: number[] = [];
  points.forEach(([x, y], k) => {
    const [u, v] = pixels[k]!;
    rows.push([x, y, 1, 0, 0, 0, -u * x, -u * y], [0, 0, 0, x, y, 1, -v * x, -v * y]);
    right.push(u, v);
  });
  const equations = normal(rows, right);
  const h = solve(equations.matrix, equations.right);
  return h && [...h, 1];
}

/** The rotation whose first two columns are nearest to two unit vectors; null if these are parallel. */
function orthogonal(a: Vector, b: Vector): Rotation | null {
  const sum = unit([a[0] + b[0], a[1] + b[1], a[2] + b[2]]);
  const difference = unit([a[0] - b[0], a[1] - b[1], a[2] - b[2]]);
  const [x, y] = [0, 1].map((k) =>
    sum.map((value, i) => (value + (k === 0 ? 1 : -1) * difference[i]!) * Math.SQRT1_2),
  ) as unknown as [Vector, Vector];
  const z = cross(x, y);
  if (![...x, ...y, ...z].every(Number.isFinite)) return null;
  return [0, 1, 2].map((i) => [x[i]!, y[i]!, z[i]!]) as unknown as Rotation;
}

function unit(v: Vector): Vector {
  const length = Math.hypot(...v);
  return [v[0] / length, v[1] / length, v[2] / length];
}

function mean(points: readonly Vector[]): Vector {
  const sum = (axis: 0 | 1 | 2) => points.reduce((total, point) => total + point[axis], 0);
  return [sum(0) / points.length, sum(1) / points.length, sum(2) / points.length];
}
