/** The outline of a ball in a photo. */

import type { Point, Vector } from "../../engine/index.ts";
import { cross, meet, position, project, type Camera } from "../geometry/camera.ts";

/** A point of an outline, relative to the image of the ball's centre, pixels. */
export interface OutlinePoint {
  readonly offset: Point;
  /** Unit vector that points away from the ball. */
  readonly normal: Point;
  /** Sine of the angle above the ball's middle, from −1 at the lowest to 1 at the highest point. */
  readonly height: number;
}

/** Points on an outline. */
const POINTS = 48;

/**
 * The outline of a ball of `radius` (m) whose centre is seen at `pixel`; null if the bed is not there.
 *
 * The rays that touch a sphere touch it on a circle: for a centre at distance d from the eye, its plane is
 * R²/d in front of the centre and its radius is R √(1 − R²/d²).
 */
export function outline(camera: Camera, pixel: Point, radius: number): OutlinePoint[] | null {
  const place = meet(camera, pixel, radius);
  if (!place) return null;
  const center: Vector = [...place, radius];
  const eye = position(camera);
  const back: Vector = [eye[0] - center[0], eye[1] - center[1], eye[2] - center[2]];
  const distance = Math.hypot(...back);
  const towards = scaled(back, 1 / distance);
  const side = unit(cross(towards, [0, 0, 1]));
  const up = cross(side, towards);
  const ring = radius * Math.sqrt(1 - (radius / distance) ** 2);
  const forward = (radius * radius) / distance;
  const points: Point[] = [];
  for (let k = 0; k < POINTS; k += 1) {
    const angle = (2 * Math.PI * k) / POINTS;
    const [cos, sin] = [ring * Math.cos(angle), ring * Math.sin(angle)];
    const seen = project(
      camera,
      center.map((c, i) => c + forward * towards[i]! + cos * side[i]! + sin * up[i]!) as never,
    );
    if (!seen) return null;
    points.push([seen[0] - pixel[0], seen[1] - pixel[1]]);
  }
  return points.map((offset, k) => {
    const next = points[(k + 1) % POINTS]!;
    const last = points[(k + POINTS - 1) % POINTS]!;
    const tangent = [next[0] - last[0], next[1] - last[1]] as const;
    const length = Math.hypot(...tangent);
    const normal: Point = [tangent[1] / length, -tangent[0] / length];
    const outward = Math.sign(normal[0] * offset[0] + normal[1] * offset[1]);
    const height = Math.sin((2 * Math.PI * k) / POINTS);
    return { offset, normal: [outward * normal[0], outward * normal[1]], height };
  });
}

/** Mean distance of the points of an outline from the centre, pixels. */
export function meanRadius(points: readonly OutlinePoint[]): number {
  return points.reduce((sum, { offset }) => sum + Math.hypot(...offset), 0) / points.length;
}

function unit(v: Vector): Vector {
  return scaled(v, 1 / Math.hypot(...v));
}

function scaled(v: Vector, by: number): Vector {
  return [v[0] * by, v[1] * by, v[2] * by];
}
