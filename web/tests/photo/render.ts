/**
 * Photos of known layouts: a table with rails, pockets and balls, drawn by casting rays through the
 * camera's model, with light, shadows, the blur of a lens and the noise of a sensor.
 */

import type { Geometry, Point, Vector } from "../../src/engine/index.ts";
import { position, project, ray, type Camera } from "../../src/photo/geometry/camera.ts";
import type { Pixels } from "../../src/photo/picture/pixels.ts";
import { look } from "../../src/viewer/balls/look.ts";
import type { Random } from "./random.ts";

export interface SceneBall {
  readonly id: string;
  readonly position: Point;
}

export interface Scene {
  readonly table: Geometry;
  readonly balls: readonly SceneBall[];
  /** m. */
  readonly radius: number;
  readonly camera: Camera;
  /** Where lamps hang above the table, m. */
  readonly lamps: readonly Vector[];
  readonly cloth: Color;
  /** Index of each ball's skin; by default its index in the scene. */
  readonly skins?: readonly number[];
}

/** A rectangle of a photo, pixels. */
export interface Frame {
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
}

export type Color = readonly [red: number, green: number, blue: number];

const CLOTHS: readonly Color[] = [
  [30, 120, 80],
  [40, 95, 150],
  [25, 80, 60],
  [120, 40, 45],
  [90, 95, 100],
];
const WOOD: Color = [96, 60, 34];
const FLOOR: Color = [120, 112, 104];
const DARK: Color = [14, 13, 12];
const WHITE: Color = [244, 238, 221];

/** Samples per pixel along each axis, and standard deviation of the lens' blur, pixels. */
const SAMPLES = 2;
const BLUR = 0.7;
/** Standard deviation of the sensor's noise, of 255. */
const NOISE = 4;
/** A ball throws its shadow at most this far, in radii. */
const SHADOW = 6;
/** Half the angular width of a stripe, and the angular radius of a number's circle, as sines. */
const STRIPE = 0.6;
const CIRCLE = 0.45;

/** A scene with a random cloth and one or two lamps. */
export function lit(random: Random, scene: Omit<Scene, "lamps" | "cloth" | "skins">): Scene {
  const [width, length] = scene.table.size!;
  const lamp = (share: number): Vector => [
    width * random.uniform(0.3, 0.7),
    length * (share + random.uniform(-0.1, 0.1)),
    random.uniform(0.8, 1.6),
  ];
  const lamps = random.choice([[lamp(0.5)], [lamp(0.3), lamp(0.7)]]);
  return { ...scene, lamps, cloth: random.choice(CLOTHS) };
}

/** The photo, or a part of it, by this number of samples per pixel along each axis. */
export function render(scene: Scene, frame: Frame, random: Random, samples = SAMPLES): Pixels {
  const border = Math.ceil(3 * BLUR);
  const [across, down] = [frame.width + 2 * border, frame.height + 2 * border];
  const [columns, rows] = [across * samples, down * samples];
  const fine = new Float32Array(columns * rows * 3);
  const painter = new Painter(near(scene, frame));
  for (let j = 0; j < rows; j += 1) {
    for (let i = 0; i < columns; i += 1) {
      const x = frame.left - border + (i + 0.5) / samples;
      const y = frame.top - border + (j + 0.5) / samples;
      fine.set(painter.color([x, y]), 3 * (j * columns + i));
    }
  }
  const smooth = blurred(blurred(fine, columns, rows, samples), rows, columns, samples);
  const data = new Uint8ClampedArray(frame.width * frame.height * 4);
  for (let y = 0; y < frame.height; y += 1) {
    for (let x = 0; x < frame.width; x += 1) {
      const at = 4 * (y * frame.width + x);
      const [i, j] = [(x + border) * samples, (y + border) * samples];
      for (let c = 0; c < 3; c += 1) {
        let sum = 0;
        for (let k = 0; k < samples * samples; k += 1) {
          const row = j + Math.floor(k / samples);
          sum += smooth[3 * (row * columns + i + (k % samples)) + c]!;
        }
        data[at + c] = sum / samples ** 2 + random.gaussian(NOISE);
      }
      data[at + 3] = 255;
    }
  }
  return { ...frame, data };
}

/** The scene with the balls that may be seen, or whose shadows may fall, in a part of the photo. */
function near(scene: Scene, frame: Frame): Scene {
  const { camera, radius } = scene;
  const balls = scene.balls.filter(({ position: [x, y] }) => {
    const pixel = project(camera, [x, y, radius]);
    const edge = project(camera, [x, y, 2 * radius]);
    if (!pixel || !edge) return true;
    const reach = 2 * SHADOW * Math.hypot(pixel[0] - edge[0], pixel[1] - edge[1]);
    const beside = (at: number, start: number, length: number) =>
      at < start - reach || at > start + length + reach;
    return !beside(pixel[0], frame.left, frame.width) && !beside(pixel[1], frame.top, frame.height);
  });
  const kept = new Map(scene.balls.map((ball, index) => [ball, index]));
  return { ...scene, balls, skins: balls.map((ball) => kept.get(ball)!) };
}

/** A Gaussian blur along the rows of an image, which is transposed on the way. */
function blurred(
  image: Float32Array,
  columns: number,
  rows: number,
  samples: number,
): Float32Array {
  const deviation = BLUR * samples;
  const reach = Math.ceil(3 * deviation);
  const weights = Array.from({ length: 2 * reach + 1 }, (_, k) =>
    Math.exp(-0.5 * ((k - reach) / deviation) ** 2),
  );
  const total = weights.reduce((sum, w) => sum + w, 0);
  const out = new Float32Array(image.length);
  for (let j = 0; j < rows; j += 1) {
    for (let i = 0; i < columns; i += 1) {
      for (let c = 0; c < 3; c += 1) {
        let sum = 0;
        for (let k = -reach; k <= reach; k += 1) {
          const from = Math.min(columns - 1, Math.max(0, i + k));
          sum += weights[k + reach]! * image[3 * (j * columns + from) + c]!;
        }
        out[3 * (i * rows + j) + c] = sum / total;
      }
    }
  }
  return out;
}

interface PaintedBall {
  readonly center: Vector;
  /** The colour in a direction from the centre. */
  readonly paint: (normal: Vector) => Color;
}

/** The colour of what a camera sees at a pixel. */
class Painter {
  readonly #scene: Scene;
  readonly #eye: Vector;
  readonly #balls: readonly PaintedBall[];

  constructor(scene: Scene) {
    this.#scene = scene;
    this.#eye = position(scene.camera);
    this.#balls = scene.balls.map(({ id, position: [x, y] }, index) => ({
      center: [x, y, scene.radius],
      paint: skin(id, scene.skins?.[index] ?? index),
    }));
  }

  color(pixel: Point): Color {
    const direction = ray(this.#scene.camera, pixel);
    if (!direction) return FLOOR;
    const d = scaled(direction, 1 / Math.hypot(...direction));
    return this.#ball(d) ?? this.#rail(d) ?? this.#bed(d);
  }

  #ball(d: Vector): Color | null {
    const { radius } = this.#scene;
    let nearest = Infinity;
    let hit: PaintedBall | null = null;
    for (const ball of this.#balls) {
      const to = minus(ball.center, this.#eye);
      const along = dot(to, d);
      const beside = dot(to, to) - along * along;
      if (beside > radius * radius) continue;
      const distance = along - Math.sqrt(radius * radius - beside);
      if (distance < nearest) [nearest, hit] = [distance, ball];
    }
    if (!hit) return null;
    const point = plus(this.#eye, scaled(d, nearest));
    const normal = scaled(minus(point, hit.center), 1 / radius);
    return this.#shaded(hit.paint(normal), point, normal, d);
  }

  /** Light on a ball: diffuse and mirrored lamps, and the cloth's reflection from below. */
  #shaded(paint: Color, point: Vector, normal: Vector, d: Vector): Color {
    let diffuse = 0.22 + 0.1 * normal[2];
    let gloss = 0;
    for (const lamp of this.#scene.lamps) {
      const to = minus(lamp, point);
      const light = scaled(to, 1 / Math.hypot(...to));
      diffuse += (0.75 / this.#scene.lamps.length) * Math.max(0, dot(normal, light));
      const mirrored = minus(d, scaled(normal, 2 * dot(d, normal)));
      gloss += Math.max(0, dot(mirrored, light)) ** 120;
    }
    const bounce = 0.25 * Math.max(0, -normal[2]);
    return mixed(
      (c) => paint[c] * diffuse + this.#scene.cloth[c] * bounce + 255 * Math.min(1, gloss),
    );
  }

  /** Top of the rails and cushions, at the height of the nose. */
  #rail(d: Vector): Color | null {
    const { table } = this.#scene;
    const at = this.#at(d, table.cushion_height);
    if (!at) return null;
    const out = outside(at, table.size!);
    if (out <= 0 || out > table.rail_width!) return null;
    const wide = table.pockets.some(({ center, radius }) => {
      const apart = Math.hypot(at[0] - center[0], at[1] - center[1]);
      return apart < radius * (out < table.cushion_width! ? 1.3 : 1);
    });
    if (wide) return null;
    if (out < table.cushion_width!) return mixed((c) => this.#scene.cloth[c] * 0.95);
    return mixed((c) => WOOD[c] * (1 + 0.1 * Math.sin(90 * at[0]) * Math.sin(37 * at[1])));
  }

  #bed(d: Vector): Color {
    const { table, cloth, lamps } = this.#scene;
    const at = this.#at(d, 0);
    if (!at) return FLOOR;
    const hole = table.pockets.some(
      ({ center, radius }) => Math.hypot(at[0] - center[0], at[1] - center[1]) < radius,
    );
    if (hole) return DARK;
    const out = outside(at, table.size!);
    if (out > table.rail_width!) return FLOOR;
    if (out > table.cushion_width!) return DARK;
    const weave = 1 + 0.03 * Math.sin(2200 * at[0]) * Math.sin(2100 * at[1]);
    // The cloth below the nose of a cushion is in its shade.
    const shade = out > -0.02 ? 0.55 : 1;
    let light = 0;
    for (const lamp of lamps) {
      const to = minus(lamp, [at[0], at[1], 0]);
      light += (1.15 / lamps.length) * (to[2] / Math.hypot(...to)) ** 0.5;
    }
    return mixed((c) => cloth[c] * weave * shade * light * this.#shadow(at));
  }

  /** Share of the light that reaches the cloth beside the balls. */
  #shadow(at: Point): number {
    const { radius, lamps } = this.#scene;
    let share = 1;
    for (const { center } of this.#balls) {
      const apart = Math.hypot(at[0] - center[0], at[1] - center[1]) / radius;
      if (apart > SHADOW) continue;
      share *= 1 - 0.6 * Math.exp(-1.6 * apart * apart);
      for (const lamp of lamps) {
        const to = minus(lamp, [at[0], at[1], 0]);
        const d = scaled(to, 1 / Math.hypot(...to));
        const from = minus(center, [at[0], at[1], 0]);
        const along = dot(from, d);
        const beside = Math.sqrt(Math.max(0, dot(from, from) - along * along)) / radius;
        if (along > 0 && beside < 1.2) {
          share *= 1 - (0.5 / lamps.length) * Math.min(1, (1.2 - beside) / 0.4);
        }
      }
    }
    return share;
  }

  #at(d: Vector, height: number): Point | null {
    const steps = (height - this.#eye[2]) / d[2];
    return steps > 0 ? [this.#eye[0] + steps * d[0], this.#eye[1] + steps * d[1]] : null;
  }
}

/** How far a place is outside the playing area, m; negative inside. */
function outside([x, y]: Point, [width, length]: Point): number {
  return Math.max(-x, x - width, -y, y - length);
}

/** Colours of a ball by the direction from its centre; every ball lies differently. */
function skin(id: string, index: number): (normal: Vector) => Color {
  const { body, striped, label, dots } = look(id, index);
  const main = color(body);
  const [a, b] = [1.7 * index + 0.4, 0.9 * index + 0.2];
  const axis: Vector = [Math.cos(a) * Math.cos(b), Math.sin(a) * Math.cos(b), Math.sin(b)];
  const face: Vector = [-Math.sin(a), Math.cos(a), 0];
  return (normal) => {
    const number = Math.abs(dot(normal, face)) > Math.sqrt(1 - CIRCLE ** 2);
    if (label !== "" && number) {
      const digit = Math.abs(dot(normal, axis)) < 0.12 && Math.abs(dot(normal, face)) > 0.94;
      return digit ? DARK : WHITE;
    }
    if (dots !== "" && Math.abs(dot(normal, axis)) > 0.99) return color(dots);
    return striped && Math.abs(dot(normal, axis)) > STRIPE ? WHITE : main;
  };
}

function color(hex: string): Color {
  return [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16)) as unknown as Color;
}

function mixed(channel: (c: 0 | 1 | 2) => number): Color {
  return [channel(0), channel(1), channel(2)];
}

function dot(a: Vector, b: Vector): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

function plus(a: Vector, b: Vector): Vector {
  return [a[0] + b[0], a[1] + b[1], a[2] + b[2]];
}

function minus(a: Vector, b: Vector): Vector {
  return [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
}

function scaled(a: Vector, by: number): Vector {
  return [a[0] * by, a[1] * by, a[2] * by];
}
