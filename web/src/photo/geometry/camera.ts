/**
 * A pinhole camera with radial distortion.
 *
 * A point X of the table has the coordinates R X + t in the camera's axes (x right, y down, z into the
 * picture). With x = X/Z, y = Y/Z and r² = x² + y² its pixel is c + f (1 + k₁ r²) (x, y).
 *
 * Source: Z. Zhang, "A flexible new technique for camera calibration", IEEE Transactions on Pattern
 * Analysis and Machine Intelligence 22 (2000) 1330–1334, sections 2.1 and 3.3. Departures: square pixels,
 * the principal point is the picture's centre, and k₂ = 0.
 */

import type { Point, Vector } from "../../engine/index.ts";

/** Rows of a rotation. */
export type Rotation = readonly [Vector, Vector, Vector];

export interface Camera {
  /** From the table's axes to the camera's. */
  readonly rotation: Rotation;
  /** The table's origin in the camera's axes, m. */
  readonly translation: Vector;
  /** Focal length, pixels. */
  readonly focal: number;
  /** Radial distortion; negative: barrel. */
  readonly k1: number;
  /** Principal point, pixels from the top left corner of the picture. */
  readonly center: Point;
}

/** Nearest depth at which a point is in the picture, m: nothing is photographed from 1 cm. */
const NEAREST = 0.01;

/** Newton steps of `undistorted`; the last ones change nothing. */
const STEPS = 12;

/** The pixel at which a point of the table (m) is seen; null if it is not in front of the camera. */
export function project(
  { rotation, translation, focal, k1, center }: Camera,
  p: Vector,
): Point | null {
  const [x, y, z] = rotation.map((row, i) => dot(row, p) + translation[i]!) as [
    number,
    number,
    number,
  ];
  if (z < NEAREST) return null;
  const [u, v] = [x / z, y / z];
  const squared = u * u + v * v;
  // Beyond this radius barrel distortion would fold the picture over itself.
  if (1 + 3 * k1 * squared <= 0) return null;
  const scale = focal * (1 + k1 * squared);
  return [center[0] + scale * u, center[1] + scale * v];
}

/** The point (m) of the plane at `height` (m) above the bed that is seen at a pixel; null if none is. */
export function meet(camera: Camera, pixel: Point, height: number): Point | null {
  const direction = ray(camera, pixel);
  if (!direction) return null;
  const eye = position(camera);
  const steps = (height - eye[2]) / direction[2];
  if (!(steps > 0) || !Number.isFinite(steps)) return null;
  return [eye[0] + steps * direction[0], eye[1] + steps * direction[1]];
}

/** The direction, in the table's axes, of what is seen at a pixel. */
export function ray({ rotation, focal, k1, center }: Camera, pixel: Point): Vector | null {
  const [u, v] = [(pixel[0] - center[0]) / focal, (pixel[1] - center[1]) / focal];
  const seen = Math.hypot(u, v);
  const radius = undistorted(seen, k1);
  if (radius === null) return null;
  const scale = seen > 0 ? radius / seen : 1;
  return transposed(rotation, [u * scale, v * scale, 1]);
}

/** Where the camera is, in the table's axes, m. */
export function position({ rotation, translation }: Camera): Vector {
  const [x, y, z] = transposed(rotation, translation);
  return [-x, -y, -z];
}

/** The rotation about the vector `w` by its length (rad), applied after `rotation`: Rodrigues' formula. */
export function rotated(rotation: Rotation, w: Vector): Rotation {
  const angle = Math.hypot(...w);
  if (angle === 0) return rotation;
  const axis: Vector = [w[0] / angle, w[1] / angle, w[2] / angle];
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  const columns = [0, 1, 2].map((j) => {
    const v: Vector = [rotation[0][j]!, rotation[1][j]!, rotation[2][j]!];
    const along = (1 - cos) * dot(axis, v);
    const side = cross(axis, v);
    return v.map((value, i) => cos * value + sin * side[i]! + along * axis[i]!);
  });
  return [0, 1, 2].map((i) => columns.map((column) => column[i]!)) as unknown as Rotation;
}

/** The radius r with r (1 + k₁ r²) = `seen`, by Newton's method; null beyond the fold. */
function undistorted(seen: number, k1: number): number | null {
  if (k1 < 0) {
    const fold = 1 / Math.sqrt(-3 * k1);
    if (seen >= (2 / 3) * fold) return null;
  }
  let r = seen;
  for (let k = 0; k < STEPS; k += 1) {
    r -= (r * (1 + k1 * r * r) - seen) / (1 + 3 * k1 * r * r);
  }
  return Number.isFinite(r) ? r : null;
}

export function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

export function cross(a: Vector, b: Vector): Vector {
  return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
}

function transposed(rotation: Rotation, v: Vector): Vector {
  const [a, b, c] = rotation;
  return [0, 1, 2].map((j) => a[j]! * v[0] + b[j]! * v[1] + c[j]! * v[2]) as unknown as Vector;
}
