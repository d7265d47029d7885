/**
 * The camera of a photo from taps on the table's landmarks.
 *
 * The estimate maximises the posterior density for Gaussian errors of the taps and Gaussian priors of the
 * lens, by the Levenberg–Marquardt method (Zhang 2000, section 3.2, minimises the same distances without
 * priors). Six taps measure the distortion; with four taps its prior keeps it near zero. A photo from
 * straight above does not contain the focal length; then the prior decides, and the balls hardly depend
 * on it.
 */

import type { Point, Vector } from "../../engine/index.ts";
import { position, project, rotated, type Camera } from "./camera.ts";
import { pose } from "./homography.ts";
import { CORNERS, PLACES, RIGHT, type Landmarks } from "./landmarks.ts";
import { inverse, normal, solve, type Matrix } from "./linear.ts";

/** Standard deviation of a tap, as a share of the photo's width: 1.5 pixels of 1200. */
export const TAP_ERROR = 1.5 / 1200;

/**
 * Prior of the focal length as a share of the photo's longer side: the field of view is 70° at the median
 * and between 48° and 95° for nineteen phones of twenty.
 */
const FOCAL = 0.714;
const FOCAL_SPREAD = 0.23;
/** What is known of k₁ besides the taps: mean and standard deviation. */
export interface Distortion {
  readonly k1: number;
  readonly spread: number;
}

/** A point of a straight edge of the table, the pixel at which the edge is seen, and its normal there. */
export interface EdgePoint {
  readonly place: Vector;
  readonly pixel: Point;
  readonly normal: Point;
}

/**
 * What a photo shows besides the taps. Each edge is parallel to a rail, at a distance that is not known: the
 * points of one edge may all be off by the same distance.
 */
export interface Evidence {
  readonly distortion: Distortion;
  readonly edges: readonly (readonly EdgePoint[])[];
}

/**
 * Standard deviation of a point of an edge, pixels: a few times that of one point on a rendered photo, since
 * edges of real tables have errors in common.
 */
const EDGE_ERROR = 2;

/** The prior of k₁. Pictures of phones are mostly corrected to within 0.05. */
export const UNKNOWN: Distortion = { k1: 0, spread: 0.08 };
const TAPS_ONLY: Evidence = { distortion: UNKNOWN, edges: [] };

/**
 * Standard deviation of a careless tap, as a share of the width: 5 pixels of 1200, or a fifth of the
 * opening of a pocket. Larger disagreement means that the taps are not this table's landmarks.
 */
export const CARELESS = 5 / 1200;

/** 99.9 % quantiles of the χ² distribution with 2, 4 and 6 degrees of freedom: four, five and six taps. */
const QUANTILES = [13.8, 18.5, 22.5] as const;

/** Most steps of the minimisation, and the change of the cost that ends it. */
const STEPS = 60;
const SETTLED = 1e-9;
/** Step of numerical derivatives; every parameter is of the order of 1. */
const DIFFERENCE = 1e-6;

/** The width and height of a photo, pixels. */
export type Size = readonly [width: number, height: number];

/** A calibrated photo. */
export interface Calibration {
  readonly camera: Camera;
  /** Of the parameters: rotation vector (rad), translation (m), ln f, k₁. */
  readonly covariance: Matrix;
  /** Index into PLACES of each tap. */
  readonly places: readonly number[];
  /** Root mean square distance of the taps from their landmarks, pixels. */
  readonly residual: number;
  /** Whether the taps agree with the table. */
  readonly fits: boolean;
}

/**
 * Calibrates a photo by four taps on the corners, and up to two more on the middles of the long rails, in
 * any order; null if no camera sees the landmarks there.
 *
 * @param turned - The table's length points up in the photo, or to the right if it lies across. If this is
 * set, it points down, or to the left.
 */
export function calibrate(
  table: Landmarks,
  taps: readonly Point[],
  photo: Size,
  turned = false,
): Calibration | null {
  let best: { fit: Fit; problem: Problem } | null = null;
  for (const arrangement of arrangements(taps)) {
    const problem = { table, taps, photo, places: arrangement, evidence: TAPS_ONLY };
    const fit = fitted(problem);
    if (fit && !(best && best.fit.cost <= fit.cost)) best = { fit, problem };
  }
  if (!best) return null;
  const { fit, problem } = best;
  if (isUpright(fit.camera, table.size) !== turned) return fit;
  return fitted({ ...problem, places: problem.places.map((place) => (place + 3) % PLACES.length) });
}

/** A calibration as its taps and further evidence give it; null if no camera sees the landmarks there. */
export function calibrateAgain(
  { places }: Calibration,
  table: Landmarks,
  taps: readonly Point[],
  photo: Size,
  evidence: Evidence,
): Calibration | null {
  return fitted({ table, taps, photo, places, evidence });
}

/** The parameters' neighbours of a camera, for derivatives: `by` is added to parameter `index`. */
export function shifted(camera: Camera, index: number, by: number): Camera {
  const step = new Array<number>(8).fill(0);
  step[index] = by;
  return moved(camera, step);
}

interface Fit extends Calibration {
  readonly cost: number;
}

interface Problem {
  readonly table: Landmarks;
  /** Indices into PLACES. */
  readonly places: readonly number[];
  readonly taps: readonly Point[];
  readonly photo: Size;
  readonly evidence: Evidence;
}

/**
 * The ways in which taps can be the landmarks, except for a half turn: the place of each tap. A photo is not
 * mirrored, so that the order of the taps around their centre is the order of the landmarks.
 */
function arrangements(taps: readonly Point[]): number[][] {
  const center = [0, 1].map((axis) => taps.reduce((sum, tap) => sum + tap[axis]!, 0) / taps.length);
  const angle = ([x, y]: Point) => Math.atan2(y - center[1]!, x - center[0]!);
  // Pixels count downwards, so that counter-clockwise is a falling angle.
  const order = taps.map((_, k) => k).sort((a, b) => angle(taps[b]!) - angle(taps[a]!));
  const middles = taps.length - CORNERS.length;
  const cycle = PLACES.map((_, k) => k).filter(
    (k) => CORNERS.includes(k) || (k === RIGHT ? middles >= 1 : middles >= 2),
  );
  const turns = taps.length === 5 ? 5 : taps.length / 2;
  return Array.from({ length: turns }, (_, turn) =>
    taps.map((_, k) => cycle[(order.indexOf(k) + turn) % cycle.length]!),
  );
}

/** The camera of the least cost for taps in a given order; null if there is none above the table. */
function fitted(problem: Problem): Fit | null {
  const { table, places, taps, photo } = problem;
  const lens = {
    focal: FOCAL * Math.max(...photo),
    center: [photo[0] / 2, photo[1] / 2] as const,
  };
  const first = pose(
    places.map((place) => table.places[place]!),
    taps,
    lens,
  );
  const start = first && weighted(problem, first, TAP_ERROR);
  if (!start) return null;
  let camera: Camera = first;
  let errors: readonly number[] = start;
  let damping = 1e-3;
  for (let k = 0; k < STEPS; k += 1) {
    const { matrix, right } = normal(derivatives(problem, camera, errors), errors);
    const damped = matrix.map((row, i) => row.map((v, j) => (i === j ? v * (1 + damping) : v)));
    const step = solve(damped, right);
    const next: Camera | null =
      step &&
      moved(
        camera,
        step.map((v) => -v),
      );
    const found = next && weighted(problem, next, TAP_ERROR);
    if (!found || !(square(found) <= square(errors))) {
      damping *= 10;
      if (damping > 1e9) break;
      continue;
    }
    const gain = square(errors) - square(found);
    [camera, errors, damping] = [next, found, damping / 10];
    if (gain < SETTLED * (1 + square(found))) break;
  }
  return judged(problem, camera, errors);
}

/** A fit with its covariance, and whether it is plausible. */
function judged(problem: Problem, camera: Camera, errors: readonly number[]): Fit | null {
  const { places, taps, photo } = problem;
  if (position(camera)[2] <= 0) return null;
  const covariance = inverse(normal(derivatives(problem, camera, errors), errors).matrix);
  const careless = weighted(problem, camera, CARELESS);
  if (!covariance || !careless) return null;
  const distances = errors.slice(0, 2 * taps.length).map((error) => error * TAP_ERROR * photo[0]);
  return {
    camera,
    covariance,
    places,
    residual: Math.sqrt(square(distances) / taps.length),
    fits: square(careless) <= QUANTILES[taps.length - CORNERS.length]!,
    cost: square(errors),
  };
}

/** Errors of the taps and departures from the priors, in standard deviations; null if a point is unseen. */
function weighted(
  { table, places, taps, photo, evidence: { distortion, edges } }: Problem,
  camera: Camera,
  tap: number,
): number[] | null {
  const errors: number[] = [];
  const deviation = tap * photo[0];
  for (const [k, place] of places.entries()) {
    const pixel = project(camera, table.places[place]!);
    if (!pixel) return null;
    errors.push((pixel[0] - taps[k]![0]) / deviation, (pixel[1] - taps[k]![1]) / deviation);
  }
  for (const edge of edges) {
    const away: number[] = [];
    for (const { place, pixel, normal } of edge) {
      const seen = project(camera, place);
      if (!seen) return null;
      const along = (seen[0] - pixel[0]) * normal[0] + (seen[1] - pixel[1]) * normal[1];
      away.push(along / EDGE_ERROR);
    }
    const mean = away.reduce((sum, value) => sum + value, 0) / away.length;
    errors.push(...away.map((value) => value - mean));
  }
  const focal = Math.log(camera.focal / (FOCAL * Math.max(...photo)));
  return [...errors, focal / FOCAL_SPREAD, (camera.k1 - distortion.k1) / distortion.spread];
}

/** Derivatives of the weighted errors by the parameters. */
function derivatives(problem: Problem, camera: Camera, errors: readonly number[]): Matrix {
  const columns = Array.from({ length: 8 }, (_, j) =>
    weighted(problem, shifted(camera, j, DIFFERENCE), TAP_ERROR),
  );
  return errors.map((error, i) =>
    columns.map((column) => ((column?.[i] ?? error) - error) / DIFFERENCE),
  );
}

/** A camera after a change of its parameters. */
function moved(camera: Camera, step: readonly number[]): Camera {
  const [a, b, c, x, y, z, focal, k1] = step as [
    number,
    number,
    number,
    number,
    number,
    number,
    number,
    number,
  ];
  const [tx, ty, tz] = camera.translation;
  return {
    ...camera,
    rotation: rotated(camera.rotation, [a, b, c]),
    translation: [tx + x, ty + y, tz + z],
    focal: camera.focal * Math.exp(focal),
    k1: camera.k1 + k1,
  };
}

/** Whether the table's length points up in the photo, or to the right if it lies across. */
function isUpright(camera: Camera, [width, length]: Point): boolean {
  const ends = [0.25, 0.75].map((share) => project(camera, [width / 2, share * length, 0]));
  const [near, far] = ends;
  if (!near || !far) return true;
  const [right, down] = [far[0] - near[0], far[1] - near[1]];
  return Math.abs(right) > Math.abs(down) ? right > 0 : down < 0;
}

function square(values: readonly number[]): number {
  return values.reduce((sum, value) => sum + value * value, 0);
}
