/**
 * Where balls lie in a photo. The calibration gives the size and shape of a ball's outline at each place of
 * the bed, so that only the place is searched: inside the outline the colours are not those of the cloth, and
 * along it they change.
 */

import type { Point } from "../../engine/index.ts";
import { meet, position, project, type Camera } from "../geometry/camera.ts";
import { meanRadius, outline, type OutlinePoint } from "./ball-outline.ts";
import { relativeSize } from "./ball-size.ts";
import { unlike, type Cloth, type Color } from "./cloth.ts";
import { closedShare, contrast } from "./contrast.ts";
import { sample, type Pixels } from "./pixels.ts";
import { refine } from "./refine.ts";

/** What is searched. */
export interface Searched {
  /** Playing area, m. */
  readonly size: Point;
  /** Of the balls, m. */
  readonly radius: number;
  /** Holes, m. */
  readonly pockets: readonly { readonly center: Point; readonly radius: number }[];
}

/** A ball in a photo. */
export interface SeenBall {
  /** Its centre in the photo, pixels. */
  readonly pixel: Point;
  /** m. */
  readonly place: Point;
  /** Its size in the photo, 1 as predicted. */
  readonly size: number;
  /** How clearly it is seen, from 0 to 1. */
  readonly score: number;
  /** Its outline, relative to `pixel`. */
  readonly points: readonly OutlinePoint[];
}

/** Step of the search, in radii: an outline that is off by half of it still follows the ball. */
const STEP = 0.3;
/** How far a centre may lie beyond the places that a ball can have, in radii: errors of the calibration. */
const BEYOND = 0.3;
/** Rings and rays of the samples inside an outline, as shares of the radius. */
const RINGS = [0.3, 0.6, 0.88];
const RAYS = 12;
/** Least share of the samples inside an outline that are not cloth, and weight of that share in the score. */
const FILLED = 0.3;
const FILLING = 0.6;
/** Contrast of a clear outline above that of bare cloth, of 255. */
const CLEAR = 30;
/** Least share of the points of an outline at which the colours change. */
const CLOSED = 0.6;
/** Least score, also by a rail, where the shade of the cushion has edges, and least share of a ball that no other ball explains. */
const LEAST = 0.3;
const LEAST_BY_RAIL = 0.5;
/** How far from a nose this shade reaches, and how near to a hole its edge looks like a ball, in radii. */
const SHADED = 3.5;
const JAWS = 1.6;
const OWN = 0.45;
/** A ball this near to a nose, in radii, must differ from most of what is seen this far along the rail, in radii. */
const BY_RAIL = 4.5;
const ALONG = [-5, -2.5, 2.5, 5];
/** Least share of its samples that differ. */
const STANDS_OUT = 0.4;
/** How many of five pixels in the middle of a ball differ from the cloth at least. */
const LOOKS = 1;
/** Distance of two balls at least, in radii: 2 less the errors of both places. */
const APART = 1.5;
/** The finer search starts near the centre and reaches as far as a step of this one, in radii. */
const REACH = 0.4;

/** The balls, the clearest first. */
export function ballPlaces(
  pixels: Pixels,
  camera: Camera,
  cloth: Cloth,
  searched: Searched,
): SeenBall[] {
  const found = candidates(pixels, camera, cloth, searched).sort((a, b) => b.score - a.score);
  const balls: SeenBall[] = [];
  const { radius } = searched;
  const isFree = (place: Point) => balls.every((ball) => apart(ball.place, place) > APART * radius);
  for (const one of found) {
    if (!isFree(one.place)) continue;
    const pixel = refine(pixels, camera, one.pixel, { radius, slack: 0, reach: REACH });
    const ball = pixel && candidateAt(pixels, camera, cloth, searched, pixel);
    if (!ball || ball.score < LEAST || !isFree(ball.place)) continue;
    const toNose = [0, 1].map((i) => Math.min(ball.place[i]!, searched.size[i]! - ball.place[i]!));
    if (Math.min(...toNose) < SHADED * radius && ball.score < LEAST_BY_RAIL) continue;
    if (!isOwn(pixels, cloth, ball, balls)) continue;
    if (!standsOut(pixels, camera, cloth, searched, ball, balls)) continue;
    balls.push({ ...ball, size: relativeSize(pixels, camera, ball.pixel, radius) ?? 1 });
  }
  return balls;
}

/** Whether another ball, nearer to the camera, covers a pixel. */
export function covered(
  ball: SeenBall,
  pixel: Point,
  balls: readonly SeenBall[],
  camera: Camera,
  radius: number,
): boolean {
  const eye = position(camera);
  const away = ({ place: [x, y] }: SeenBall) => Math.hypot(x - eye[0], y - eye[1], radius - eye[2]);
  return balls.some((other) => other !== ball && away(other) < away(ball) && holds(other, pixel));
}

function apart(a: Point, b: Point): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}

function holds({ pixel, points }: SeenBall, at: Point): boolean {
  return apart(at, pixel) < meanRadius(points);
}

/** Whether enough of a ball lies outside the other balls, and differs from the cloth there. */
function isOwn(
  pixels: Pixels,
  cloth: Cloth,
  { pixel, place, points }: SeenBall,
  balls: readonly SeenBall[],
): boolean {
  const inside = samples(points).map(([x, y]): Point => [pixel[0] + x, pixel[1] + y]);
  const free = inside.filter((at) => !balls.some((other) => holds(other, at)));
  const under = cloth.at(place);
  const filled = free.filter((at) => isOther(pixels, cloth, under, at));
  return free.length >= OWN * inside.length && filled.length >= FILLED * free.length;
}

/** Whether a ball by a rail is more than the rail: that looks alike to the left and to the right. */
function standsOut(
  pixels: Pixels,
  camera: Camera,
  cloth: Cloth,
  { size, radius }: Searched,
  { place, pixel, points }: SeenBall,
  balls: readonly SeenBall[],
): boolean {
  const near = [0, 1].map((i) => Math.min(place[i]!, size[i]! - place[i]!) < BY_RAIL * radius);
  return [0, 1].every((axis) => {
    if (!near[axis]) return true;
    const inside = samples(points);
    const beside = ALONG.flatMap((by) => {
      const [x, y] = place;
      const along: Point = axis === 0 ? [x, y + by * radius] : [x + by * radius, y];
      const isBall = balls.some((ball) => apart(ball.place, along) < 2 * radius);
      const at = project(camera, [...along, radius]);
      return at && !isBall ? [at] : [];
    });
    const unlikeIt = beside.filter((at) => {
      const other = inside.filter(([x, y]) => {
        const isSeen =
          sample(pixels, pixel[0] + x, pixel[1] + y, COLOR) &&
          sample(pixels, at[0] + x, at[1] + y, BESIDE);
        const [r, g, b] = [0, 1, 2].map((c) => COLOR[c]! - BESIDE[c]!) as [number, number, number];
        return isSeen && Math.hypot(r, g, b) > cloth.threshold;
      });
      return other.length >= STANDS_OUT * inside.length;
    });
    return 2 * unlikeIt.length > beside.length || beside.length === 0;
  });
}

/** Places inside an outline, relative to its centre, pixels. */
export function samples(points: readonly OutlinePoint[], rings = RINGS): Point[] {
  const every = points.length / RAYS;
  return rings.flatMap((ring) =>
    Array.from({ length: RAYS }, (_, k): Point => {
      const [x, y] = points[Math.floor(k * every)]!.offset;
      return [ring * x, ring * y];
    }),
  );
}

/** The best place in each neighbourhood of the grid. */
function candidates(pixels: Pixels, camera: Camera, cloth: Cloth, searched: Searched): SeenBall[] {
  const { size, radius } = searched;
  const step = STEP * radius;
  const [columns, rows] = size.map((side) => Math.floor((side - 2 * radius) / step) + 3) as [
    number,
    number,
  ];
  const grid = Array.from({ length: columns * rows }, (_, k) => {
    const place: Point = [
      radius + (k % columns) * step - step,
      radius + Math.floor(k / columns) * step - step,
    ];
    const pixel = project(camera, [...place, radius]);
    if (!pixel || !mayBeBall(pixels, camera, cloth, place, radius, pixel)) return null;
    return candidateAt(pixels, camera, cloth, searched, pixel);
  });
  return grid.flatMap((one, k) => {
    if (!one || one.score < LEAST) return [];
    const [i, j] = [k % columns, Math.floor(k / columns)];
    for (let dj = -1; dj <= 1; dj += 1) {
      for (let di = -1; di <= 1; di += 1) {
        if (i + di < 0 || i + di >= columns || j + dj < 0 || j + dj >= rows) continue;
        const near = grid[k + dj * columns + di];
        if (near && near.score > one.score) return [];
      }
    }
    return [one];
  });
}

const COLOR = new Float64Array(3);
const BESIDE = new Float64Array(3);

/** Whether a pixel shows something else than cloth. */
function isOther(pixels: Pixels, cloth: Cloth, under: Color, [x, y]: Point): boolean {
  if (!sample(pixels, x, y, COLOR)) return false;
  return unlike([COLOR[0]!, COLOR[1]!, COLOR[2]!], under) > cloth.threshold;
}

/** A quick look at the middle of a ball: most of the bed is bare cloth. */
function mayBeBall(
  pixels: Pixels,
  camera: Camera,
  cloth: Cloth,
  place: Point,
  radius: number,
  [x, y]: Point,
): boolean {
  const eye = position(camera);
  const away = Math.hypot(place[0] - eye[0], place[1] - eye[1], radius - eye[2]);
  const half = (0.5 * radius * camera.focal) / away;
  const under = cloth.at(place);
  const looks: readonly Point[] = [
    [x, y],
    [x - half, y],
    [x + half, y],
    [x, y - half],
    [x, y + half],
  ];
  return looks.filter((at) => isOther(pixels, cloth, under, at)).length >= LOOKS;
}

/** What is seen at a pixel, if a ball had its centre there; null if no ball of the table can. */
export function candidateAt(
  pixels: Pixels,
  camera: Camera,
  cloth: Cloth,
  { size, radius, pockets }: Searched,
  pixel: Point,
): SeenBall | null {
  const points = outline(camera, pixel, radius);
  const place = points && meet(camera, pixel, radius);
  if (!points || !place) return null;
  const least = (1 - BEYOND) * radius;
  if ([0, 1].some((i) => place[i]! < least || place[i]! > size[i]! - least)) return null;
  if (pockets.some(({ center, radius: hole }) => apart(center, place) < hole + JAWS * radius))
    return null;
  const under = cloth.at(place);
  const inside = samples(points);
  const filled = inside.filter(([x, y]) =>
    isOther(pixels, cloth, under, [pixel[0] + x, pixel[1] + y]),
  ).length;
  const share = filled / inside.length;
  const closed = share < FILLED ? 0 : closedShare(pixels, points, pixel, cloth.grain);
  const edge = closed < CLOSED ? 0 : contrast(pixels, points, pixel) - cloth.grain;
  const clear = closed * Math.min(1, Math.max(0, edge / CLEAR));
  return { pixel, place, size: 1, points, score: clear * (1 - FILLING + FILLING * share) };
}
