/**
 * The cloth of a photo: its colour at each place of the bed, and how much a pixel differs from it. Light and
 * shade change the brightness of a colour, so that only the rest of a difference is evidence of a ball.
 */

import type { Point } from "../../engine/index.ts";
import { project, type Camera } from "../geometry/camera.ts";
import { sample, type Pixels } from "./pixels.ts";

export type Color = readonly [red: number, green: number, blue: number];

/** Side of the cells in which the light is taken as even, m: a few balls wide, less than the light of a lamp. */
const CELL = 0.16;
/** Samples along each side of a cell. */
const SAMPLES = 7;
/** Share of the samples, those nearest to the bed's usual colour, that show cloth in a cell. */
const CLEAN = 0.6;
/** Darkest shade and strongest light of the cloth in a cell, as a share of its usual brightness. */
const SHADE = 0.5;
const LIGHT = 1.25;
/** Difference of a pixel beyond the noise, in standard deviations of the cloth, and at least, of 255. */
const CLEAR = 5;
const LEAST = 16;

/** Mean difference of two pixels of bare cloth, in standard deviations. */
const GRAIN = 1.6;

export interface Cloth {
  /** The colour of the bed at a place (m), of 255. */
  at(place: Point): Color;
  /** The colour in the middle of the cells, of 255. */
  readonly usual: Color;
  /** Of 255: what differs more from the cloth is another thing. */
  readonly threshold: number;
  /** Usual difference of two pixels of bare cloth, of 255. */
  readonly grain: number;
}

/** The cloth of a table with a playing area of `size` (m); null if the photo shows too little of it. */
export function clothOf(pixels: Pixels, camera: Camera, size: Point): Cloth | null {
  const counts = size.map((side) => Math.max(2, Math.round(side / CELL))) as [number, number];
  const cells = Array.from({ length: counts[0] * counts[1] }, (_, k) =>
    samplesOf(pixels, camera, size, counts, [k % counts[0], Math.floor(k / counts[0])]),
  );
  const all = cells.flat();
  if (all.length < cells.length) return null;
  const usual = medianColor(all);
  const clean = cells.map((samples) => {
    const sorted = samples.toSorted((a, b) => unlike(a, usual) - unlike(b, usual));
    return sorted.slice(0, Math.ceil(CLEAN * sorted.length));
  });
  const colors = clean.map((samples) => (samples.length > 0 ? medianColor(samples) : usual));
  const smooth = colors.map((_, k) =>
    meanColor(neighbours(k, counts).map((near) => colors[near]!)),
  );
  const away = clean.flatMap((samples, k) => samples.map((color) => unlike(color, smooth[k]!)));
  const noise = 1.5 * median(away);
  return {
    usual,
    threshold: Math.max(LEAST, CLEAR * noise),
    grain: GRAIN * noise,
    at: (place) => between(smooth, counts, [0, 1].map((i) => place[i]! / size[i]!) as never),
  };
}

/** The part of a colour that no light and no shade on the cloth explains, of 255. */
export function unlike(color: Color, cloth: Color): number {
  const square = cloth[0] ** 2 + cloth[1] ** 2 + cloth[2] ** 2;
  const along = (color[0] * cloth[0] + color[1] * cloth[1] + color[2] * cloth[2]) / (square || 1);
  const light = Math.min(LIGHT, Math.max(SHADE, along));
  return Math.hypot(
    color[0] - light * cloth[0],
    color[1] - light * cloth[1],
    color[2] - light * cloth[2],
  );
}

function samplesOf(
  pixels: Pixels,
  camera: Camera,
  size: Point,
  counts: Point,
  cell: Point,
): Color[] {
  const found: Color[] = [];
  const out = new Float64Array(3);
  for (let k = 0; k < SAMPLES * SAMPLES; k += 1) {
    const within = [k % SAMPLES, Math.floor(k / SAMPLES)];
    const [x, y] = [0, 1].map(
      (i) => (size[i]! * (cell[i]! + (within[i]! + 0.5) / SAMPLES)) / counts[i]!,
    ) as [number, number];
    const pixel = project(camera, [x, y, 0]);
    if (pixel && sample(pixels, pixel[0], pixel[1], out)) found.push([out[0]!, out[1]!, out[2]!]);
  }
  return found;
}

/** A cell and those around it. */
function neighbours(k: number, [columns, rows]: Point): number[] {
  const [column, row] = [k % columns, Math.floor(k / columns)];
  const found: number[] = [];
  for (let j = Math.max(0, row - 1); j <= Math.min(rows - 1, row + 1); j += 1)
    for (let i = Math.max(0, column - 1); i <= Math.min(columns - 1, column + 1); i += 1)
      found.push(j * columns + i);
  return found;
}

/** The colour between the middles of four cells; shares of the bed's sides. */
function between(colors: readonly Color[], [columns, rows]: Point, [u, v]: Point): Color {
  const x = Math.min(Math.max(u * columns - 0.5, 0), columns - 1);
  const y = Math.min(Math.max(v * rows - 0.5, 0), rows - 1);
  const [i, j] = [Math.min(Math.floor(x), columns - 2), Math.min(Math.floor(y), rows - 2)];
  const [a, b] = [x - i, y - j];
  const [low, high] = [j * columns + i, (j + 1) * columns + i];
  return [0, 1, 2].map(
    (c) =>
      (1 - b) * ((1 - a) * colors[low]![c]! + a * colors[low + 1]![c]!) +
      b * ((1 - a) * colors[high]![c]! + a * colors[high + 1]![c]!),
  ) as unknown as Color;
}

export function median(values: readonly number[]): number {
  return values.toSorted((a, b) => a - b)[values.length >> 1] ?? 0;
}

function medianColor(colors: readonly Color[]): Color {
  return [0, 1, 2].map((c) => median(colors.map((color) => color[c]!))) as unknown as Color;
}

function meanColor(colors: readonly Color[]): Color {
  return [0, 1, 2].map(
    (c) => colors.reduce((sum, color) => sum + color[c]!, 0) / colors.length,
  ) as unknown as Color;
}
