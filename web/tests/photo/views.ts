/** Random cameras as people hold them, and random layouts. */

import type { Point, Vector } from "../../src/engine/index.ts";
import type { Size } from "../../src/photo/geometry/calibrate.ts";
import {
  cross,
  dot,
  project,
  type Camera,
  type Rotation,
} from "../../src/photo/geometry/camera.ts";
import type { Landmarks } from "../../src/photo/geometry/landmarks.ts";
import type { Random } from "./random.ts";

/** Where the photographer stands. */
export const STANDS = ["end", "side", "corner"] as const;
export type Stand = (typeof STANDS)[number];

/** Height of the bed above the floor, m: WPA equipment specifications, 29 ¼ to 31 inches. */
export const BED = 0.765;

/** Ranges of the random cameras. */
export const CAMERAS = {
  /** Of the longer side of the photo, degrees. */
  field_of_view_deg: [60, 80],
  /** Of the phone above the floor, m. */
  height: [1.4, 2.2],
  k1: [-0.15, 0.1],
  /** Standard deviation, degrees. */
  roll_deg: 2,
  /** Free share of the photo at each side. */
  margin: [0.02, 0.08],
} as const;

const LANDSCAPE: Size = [1200, 900];
const PORTRAIT: Size = [1200, 1600];

/** Steps backwards until the whole table is in the photo, m. */
const STEP = 0.05;

export interface View {
  readonly camera: Camera;
  readonly photo: Size;
  readonly stand: Stand;
}

/** A camera that sees all landmarks and whose photo is about centred on them. */
export function randomView(random: Random, table: Landmarks): View {
  const stand = random.choice(STANDS);
  const photo = stand === "end" ? random.choice([LANDSCAPE, PORTRAIT]) : LANDSCAPE;
  const half = (random.uniform(...CAMERAS.field_of_view_deg) * Math.PI) / 360;
  const lens = {
    focal: Math.max(...photo) / 2 / Math.tan(half),
    k1: random.uniform(...CAMERAS.k1),
    center: [photo[0] / 2, photo[1] / 2] as const,
  };
  const [width, length] = table.size;
  const height = random.uniform(...CAMERAS.height) - BED;
  const towards = direction(random, stand);
  const roll = (random.gaussian(CAMERAS.roll_deg) * Math.PI) / 180;
  const margin = random.uniform(...CAMERAS.margin);
  for (let distance = 0.3; distance < 12; distance += STEP) {
    const eye: Vector = [
      width / 2 + towards[0] * (width / 2 + distance),
      length / 2 + towards[1] * (length / 2 + distance),
      height,
    ];
    const camera = centred({ eye, roll, table, lens });
    if (camera && isInside(camera, table, photo, margin)) return { camera, photo, stand };
  }
  throw new Error("no place shows the whole table; widen the field of view");
}

/** Horizontal direction from the table's centre to the photographer. */
function direction(random: Random, stand: Stand): Point {
  const side = random.choice([-1, 1]);
  const aside = random.uniform(-0.4, 0.4);
  if (stand === "end") return [aside, side];
  if (stand === "side") return [side, aside];
  return [side * random.uniform(0.6, 1), random.choice([-1, 1]) * random.uniform(0.6, 1)];
}

interface Aim {
  readonly eye: Vector;
  readonly roll: number;
  readonly table: Landmarks;
  readonly lens: Pick<Camera, "focal" | "k1" | "center">;
}

/** The camera turned so that the landmarks are in the middle of the photo. */
function centred({ eye, roll, table, lens }: Aim): Camera | null {
  let [x, y] = [table.size[0] / 2, table.size[1] / 2];
  let camera = lookAt({ eye, target: [x, y, 0], roll, lens });
  for (let k = 0; k < 6; k += 1) {
    const seen = table.places.map((place) => project(camera, place));
    if (!seen.every((pixel) => pixel !== null)) return null;
    const off = [0, 1].map((axis) => {
      const values = seen.map((pixel) => pixel[axis]!);
      return (Math.min(...values) + Math.max(...values)) / 2 - lens.center[axis]!;
    });
    // A pixel is about this long on the bed.
    const scale = Math.hypot(eye[0] - x, eye[1] - y, eye[2]) / lens.focal;
    const [right, down] = camera.rotation;
    const flat = Math.hypot(down[0], down[1]);
    const depth = scale * Math.max(1, 0.5 / Math.max(0.2, Math.abs(down[2]) < 1 ? eye[2] : 1));
    x += scale * off[0]! * right[0] + (depth * off[1]! * down[0]) / Math.max(0.2, flat);
    y += scale * off[0]! * right[1] + (depth * off[1]! * down[1]) / Math.max(0.2, flat);
    camera = lookAt({ eye, target: [x, y, 0], roll, lens });
  }
  return camera;
}

interface Look {
  readonly eye: Vector;
  readonly target: Vector;
  /** rad. */
  readonly roll: number;
  readonly lens: Pick<Camera, "focal" | "k1" | "center">;
}

/** A camera at `eye` whose middle shows `target`. */
export function lookAt({ eye, target, roll, lens }: Look): Camera {
  const forward = unit([target[0] - eye[0], target[1] - eye[1], target[2] - eye[2]]);
  const level = unit(cross(forward, [0, 0, 1]));
  const below = cross(forward, level);
  const [cos, sin] = [Math.cos(roll), Math.sin(roll)];
  const right = level.map((v, i) => cos * v + sin * below[i]!) as unknown as Vector;
  const down = level.map((v, i) => cos * below[i]! - sin * v) as unknown as Vector;
  const rotation: Rotation = [right, down, forward];
  const translation = rotation.map((row) => -dot(row, eye)) as unknown as Vector;
  return { rotation, translation, ...lens };
}

function isInside(camera: Camera, table: Landmarks, photo: Size, margin: number): boolean {
  return table.places.every((place) => {
    const pixel = project(camera, place);
    return (
      pixel !== null &&
      [0, 1].every((i) => pixel[i]! > margin * photo[i]! && pixel[i]! < (1 - margin) * photo[i]!)
    );
  });
}

function unit(v: Vector): Vector {
  const length = Math.hypot(...v);
  return [v[0] / length, v[1] / length, v[2] / length];
}

/** Random places of `count` balls of `radius` (m) that do not overlap and lie on the bed. */
export function randomLayout(random: Random, size: Point, count: number, radius: number): Point[] {
  const balls: Point[] = [];
  while (balls.length < count) {
    const [x, y] = [0, 1].map((i) => random.uniform(radius, size[i]! - radius)) as [number, number];
    if (balls.every(([u, v]) => Math.hypot(u - x, v - y) > 2 * radius)) balls.push([x, y]);
  }
  return balls;
}
