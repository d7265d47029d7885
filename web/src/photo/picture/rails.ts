/**
 * The camera by the rails of the table, which are straight. First the distortion: at the right k₁ the lines
 * along the rails stand out most. Then the points of these lines count as measurements beside the taps.
 */

import type { Point, Vector } from "../../engine/index.ts";
import {
  calibrateAgain,
  type Calibration,
  CARELESS,
  type Distortion,
  type EdgePoint,
  UNKNOWN,
} from "../geometry/calibrate.ts";
import { project, type Camera } from "../geometry/camera.ts";
import type { Landmarks } from "../geometry/landmarks.ts";
import { sample, type Pixels } from "./pixels.ts";

/** Range and step of the k₁ that are tried; between them a parabola decides. */
const LEAST = -0.24;
const MOST = 0.2;
const STEP = 0.02;
/** Standard deviation of a k₁ that is tried: so small that the taps do not move it. */
const FIXED = 1e-3;
/** Standard deviation of the one that was found: twice the median error on rendered photos. */
const FOUND = 0.04;
/** How often the points of the lines are searched, each time near the last camera. */
const ROUNDS = 2;
/** How far from a line its points are searched, and in which steps, pixels. */
const SEARCHED = 5;
const FINE = 0.5;
/** A point counts if it has this share of the contrast of its line. */
const CLEAR = 0.4;
/** Least number of points of a line. */
const ENOUGH = 8;

/**
 * Where lines are searched: from inside the nose to the wood, at the height of the nose, m. Some tables have
 * wider cushions than others, so that it is not known which line is the strongest.
 */
const INSIDE = -0.03;
const OUTSIDE = 0.09;
const OFFSETS = 30;
/** Points along a part of a rail, and the shares of the rail that are free of pockets. */
const POINTS = 32;
const LONG_PARTS = [
  [0.06, 0.44],
  [0.56, 0.94],
] as const;
const SHORT_PARTS = [[0.12, 0.88]] as const;
/** Distance (m) over which the direction away from the bed is measured. */
const ASIDE = 0.05;
/** Half the width over which an edge is measured, pixels. */
const EDGE = 1.5;
/** Least contrast of a line (of 255), on average of the rails, and how much it exceeds the median of all k₁. */
const WEAKEST = 12;
const DISTINCT = 1.15;

/** A part of a rail: a line of the nose, and the direction away from the bed. */
interface Part {
  readonly from: Point;
  readonly to: Point;
  readonly out: Point;
  /** m. */
  readonly height: number;
}

/**
 * The calibration with what the rails show; the given one if no lines stand out.
 *
 * @param taps - Those of the calibration.
 * @param pixels - The whole photo.
 * @param known - k₁, if it was found before: the search for it takes longest.
 */
export function straightened(
  found: Calibration,
  table: Landmarks,
  taps: readonly Point[],
  pixels: Pixels,
  known: number | null = null,
): Calibration {
  if (!found.fits) return found;
  const parts = partsOf(table);
  const photo = [pixels.width, pixels.height] as const;
  const fit = (distortion: Distortion, edges: readonly (readonly EdgePoint[])[] = []) =>
    calibrateAgain(found, table, taps, photo, { distortion, edges });
  const k1 = known ?? distortionOf(pixels, parts, (tried) => fit({ k1: tried, spread: FIXED }));
  const distortion = k1 === null ? UNKNOWN : { k1, spread: FOUND };
  let best = k1 === null ? found : fit(distortion);
  for (let round = 0; best && round < ROUNDS; round += 1) {
    const { camera } = best;
    const edges = parts.map((part) => edgeOf(pixels, camera, part));
    const clear = edges.filter(({ length }) => length >= ENOUGH);
    if (clear.length === 0) return found;
    best = fit(distortion, clear) ?? best;
  }
  // Lines that contradict the taps are not the rails.
  return best && best.residual <= CARELESS * pixels.width ? { ...best, fits: true } : found;
}

/** The k₁ at which the lines along the rails stand out most; null if none stands out from the others. */
function distortionOf(
  pixels: Pixels,
  parts: readonly Part[],
  fit: (k1: number) => Calibration | null,
): number | null {
  const tried = Array.from({ length: Math.round((MOST - LEAST) / STEP) + 1 }, (_, k) => {
    const camera = fit(LEAST + k * STEP)?.camera;
    if (!camera) return 0;
    const all = parts.map((part) => strongest(pixels, camera, part).contrast);
    return all.reduce((sum, contrast) => sum + contrast, 0) / all.length;
  });
  const most = Math.max(...tried);
  const at = tried.indexOf(most);
  const median = tried.toSorted((a, b) => a - b)[tried.length >> 1]!;
  const isInside = at > 0 && at < tried.length - 1;
  if (!isInside || most < WEAKEST || most < DISTINCT * median) return null;
  const [before, after] = [tried[at - 1]!, tried[at + 1]!];
  const curvature = before - 2 * most + after;
  return LEAST + (at + (curvature < 0 ? (before - after) / (2 * curvature) : 0)) * STEP;
}

function partsOf({ size: [width, length], nose }: Landmarks): Part[] {
  const along = (share: number, x: number): Point => [x, share * length];
  const across = (share: number, y: number): Point => [share * width, y];
  const height = nose;
  return [
    ...LONG_PARTS.flatMap(([a, b]): Part[] => [
      { from: along(a, 0), to: along(b, 0), out: [-1, 0], height },
      { from: along(a, width), to: along(b, width), out: [1, 0], height },
    ]),
    ...SHORT_PARTS.flatMap(([a, b]): Part[] => [
      { from: across(a, 0), to: across(b, 0), out: [0, -1], height },
      { from: across(a, length), to: across(b, length), out: [0, 1], height },
    ]),
  ];
}

/** A line along a part of a rail that stands out: its distance from the nose, m, and its contrast, of 255. */
interface Line {
  readonly offset: number;
  readonly contrast: number;
  /** Mean difference of the colours on both sides. */
  readonly difference: readonly number[];
}

function strongest(pixels: Pixels, camera: Camera, part: Part): Line {
  let best: Line = { offset: 0, contrast: 0, difference: [0, 0, 0] };
  for (let k = 0; k <= OFFSETS; k += 1) {
    const offset = INSIDE + ((OUTSIDE - INSIDE) * k) / OFFSETS;
    const line = lineAt(pixels, camera, part, offset);
    if (line && line.contrast > best.contrast) best = line;
  }
  return best;
}

/** A point of a line, and the pixels across it. */
interface Crossing {
  readonly place: Vector;
  readonly pixel: Point;
  /** Away from the bed. */
  readonly normal: Point;
}

/** Points along a part of a rail, `offset` (m) from the nose; null if a part of the line is not seen. */
function crossings(
  camera: Camera,
  { from, to, out, height }: Part,
  offset: number,
): Crossing[] | null {
  const placeAt = (share: number, away = offset): Vector => [
    from[0] + share * (to[0] - from[0]) + away * out[0],
    from[1] + share * (to[1] - from[1]) + away * out[1],
    height,
  ];
  const places = Array.from({ length: POINTS + 1 }, (_, k) => placeAt(k / POINTS));
  const seen = places.map((place) => project(camera, place));
  const beside = project(camera, placeAt(0.5, offset + ASIDE));
  const middle = seen[POINTS / 2];
  if (!beside || !middle || !seen.every((pixel) => pixel !== null)) return null;
  return seen.slice(1, -1).map((pixel, k) => {
    const [last, next] = [seen[k]!, seen[k + 2]!];
    const [dx, dy] = [next[0] - last[0], next[1] - last[1]];
    const sign = Math.sign(-dy * (beside[0] - middle[0]) + dx * (beside[1] - middle[1]));
    const length = Math.hypot(dx, dy) || 1;
    return { place: places[k + 1]!, pixel, normal: [(-dy * sign) / length, (dx * sign) / length] };
  });
}

const INNER = new Float64Array(3);
const OUTER = new Float64Array(3);

/** The difference of the colours on both sides of a pixel, in `out`; false at the edge of the photo. */
function difference(
  pixels: Pixels,
  [x, y]: Point,
  [nx, ny]: Point,
  out: number[] | Float64Array,
): boolean {
  const [ex, ey] = [EDGE * nx, EDGE * ny];
  if (!sample(pixels, x - ex, y - ey, INNER) || !sample(pixels, x + ex, y + ey, OUTER))
    return false;
  for (let c = 0; c < 3; c += 1) out[c] = OUTER[c]! - INNER[c]!;
  return true;
}

const ACROSS = new Float64Array(3);

/** How much the colours on both sides of a line differ on average: noise cancels out. */
function lineAt(pixels: Pixels, camera: Camera, part: Part, offset: number): Line | null {
  const points = crossings(camera, part, offset);
  if (!points) return null;
  const mean = [0, 0, 0];
  let seen = 0;
  for (const { pixel, normal } of points) {
    if (!difference(pixels, pixel, normal, ACROSS)) continue;
    seen += 1;
    for (let c = 0; c < 3; c += 1) mean[c]! += ACROSS[c]!;
  }
  if (seen < POINTS / 2) return null;
  const averaged = mean.map((sum) => sum / seen);
  return { offset, contrast: Math.hypot(...averaged), difference: averaged };
}

/** The points of the strongest line along a part of a rail where they stand out. */
function edgeOf(pixels: Pixels, camera: Camera, part: Part): EdgePoint[] {
  const line = strongest(pixels, camera, part);
  const points = line.contrast < WEAKEST ? null : crossings(camera, part, line.offset);
  const along = line.difference.map((value) => value / line.contrast);
  const steps = Math.round(SEARCHED / FINE);
  return (points ?? []).flatMap(({ place, pixel, normal }) => {
    const values = Array.from({ length: 2 * steps + 1 }, (_, k) => {
      const by = (k - steps) * FINE;
      const at: Point = [pixel[0] + by * normal[0], pixel[1] + by * normal[1]];
      if (!difference(pixels, at, normal, ACROSS)) return 0;
      return ACROSS[0]! * along[0]! + ACROSS[1]! * along[1]! + ACROSS[2]! * along[2]!;
    });
    const most = Math.max(...values);
    const k = values.indexOf(most);
    if (most < CLEAR * line.contrast || k === 0 || k === values.length - 1) return [];
    const [before, after] = [values[k - 1]!, values[k + 1]!];
    const curvature = before - 2 * most + after;
    const by = (k - steps + (curvature < 0 ? (before - after) / (2 * curvature) : 0)) * FINE;
    const seen: Point = [pixel[0] + by * normal[0], pixel[1] + by * normal[1]];
    return [{ place, pixel: seen, normal }];
  });
}
