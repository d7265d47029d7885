/**
 * Ground plan of a table: joins the separate parts of its cushions and liners to closed lines, from which
 * the surfaces are made.
 */

import type { Geometry, Point } from "../viewer-types.ts";

/** Material of a piece of the edge. */
export type Material = "cushion" | "liner";

/** Consecutive parts of one cushion, or the wall of one pocket, as chords along the loop. */
export interface Run {
  material: Material;
  /** The cushion's rail; empty for a pocket. */
  rail: string;
  points: Point[];
}

/** The closed lines of a table's ground plan, counter-clockwise. */
export interface Outline {
  /** The edge that balls meet; each run starts at the end of the previous one. */
  runs: Run[];
  /** One polygon per cushion: its nose line, closed at the wood. */
  rubbers: Point[][];
  /** The wood's inner edge, around cushions and pockets. */
  woodInside: Point[];
  /** Extent of the wood beyond the nose lines, m: its width, or what the pockets need. */
  reach: number;
}

interface Part extends Run {
  used: boolean;
}

/** Ends of parts closer than this are joined, m: a micrometre, far below the length of any part. */
export const JOIN = 1e-6;
/** Largest angle between the chords of an arc, rad. */
const CHORD_ANGLE = Math.PI / 20;
/** Width of the wood behind a pocket, m: it carries the leather. */
const BEHIND_POCKET = 0.02;
/**
 * Radius of the rounded corners of a pocket's wall, m. It is less than the radius of every ball, so that no
 * ball reaches into a rounded corner.
 */
const CORNER_RADIUS = 0.024;

/**
 * The ground plan of a table with rails.
 *
 * @throws Error for unbounded cloth.
 */
export function outline(geometry: Geometry): Outline {
  const { size, cushion_width: cushion = 0, rail_width: rail = 0 } = geometry;
  if (!size) throw new Error("Unbounded cloth has no outline; draw a table with rails.");
  const runs = merge(chain(geometry)).map((run) =>
    run.material === "liner" ? { ...run, points: rounded(run.points, CORNER_RADIUS) } : run,
  );
  const woodInside: Point[] = [];
  const rubbers: Point[][] = [];
  for (const { material, points } of runs) {
    if (material === "liner") {
      append(woodInside, points);
      continue;
    }
    const ends = [points[0]!, points.at(-1)!].map((end) => behind(end, size, cushion));
    rubbers.push(deduplicated([ends[0]!, ...points, ends[1]!]));
    append(woodInside, ends);
  }
  const deepest = Math.max(...woodInside.map((p) => beyond(p, size)));
  return {
    runs,
    rubbers,
    woodInside: deduplicated(woodInside),
    reach: Math.max(rail, deepest + BEHIND_POCKET),
  };
}

/** The chords of the shorter arc between two points, or of the arc through the angle `via` (rad). */
export function arc(center: Point, start: Point, end: Point, via?: number): Point[] {
  const radius = Math.hypot(start[0] - center[0], start[1] - center[1]);
  const from = Math.atan2(start[1] - center[1], start[0] - center[0]);
  let sweep = turn(Math.atan2(end[1] - center[1], end[0] - center[0]) - from);
  if (via !== undefined) {
    const past = turn(via - from);
    const short = Math.sign(past) === Math.sign(sweep) && Math.abs(past) < Math.abs(sweep);
    if (!short) sweep -= 2 * Math.PI * Math.sign(sweep);
  }
  const count = Math.max(1, Math.ceil(Math.abs(sweep) / CHORD_ANGLE));
  const points = Array.from({ length: count + 1 }, (_, i): Point => {
    const angle = from + (sweep * i) / count;
    return [center[0] + radius * Math.cos(angle), center[1] + radius * Math.sin(angle)];
  });
  // Exact, so that neighbours join.
  points[0] = start;
  points[count] = end;
  return points;
}

/**
 * An open line whose corners are arcs of the given radius (m), or of a smaller one where its parts are too
 * short. The ends stay.
 */
export function rounded(line: readonly Point[], radius: number): Point[] {
  const points = simplified(line);
  return points.flatMap((corner, i): Point[] => {
    const [before, after] = [points[i - 1], points[i + 1]];
    if (!before || !after) return [corner];
    const [a, b] = [distance(before, corner), distance(corner, after)];
    const [ux, uy] = [(before[0] - corner[0]) / a, (before[1] - corner[1]) / a];
    const [vx, vy] = [(after[0] - corner[0]) / b, (after[1] - corner[1]) / b];
    const half = Math.acos(Math.min(1, Math.max(-1, ux * vx + uy * vy))) / 2;
    const length = Math.min(radius / Math.tan(half), 0.49 * a, 0.49 * b);
    if (Math.PI / 2 - half < CHORD_ANGLE / 2 + JOIN) return [corner];
    const along = length / Math.cos(half) ** 2;
    const center: Point = [
      corner[0] + (along * (ux + vx)) / 2,
      corner[1] + (along * (uy + vy)) / 2,
    ];
    return arc(
      center,
      [corner[0] + length * ux, corner[1] + length * uy],
      [corner[0] + length * vx, corner[1] + length * vy],
    );
  });
}

/** A line without the inner points of straight parts. */
function simplified(line: readonly Point[]): Point[] {
  return line.filter((point, i) => {
    const [before, after] = [line[i - 1], line[i + 1]];
    if (!before || !after) return true;
    const cross =
      (point[0] - before[0]) * (after[1] - point[1]) -
      (point[1] - before[1]) * (after[0] - point[0]);
    return Math.abs(cross) > JOIN * distance(before, after);
  });
}

/** Area of a polygon, m²; positive if it is counter-clockwise. */
export function signedArea(polygon: readonly Point[]): number {
  let twice = 0;
  polygon.forEach(([x, y], i) => {
    const [nextX, nextY] = polygon[(i + 1) % polygon.length]!;
    twice += x * nextY - nextX * y;
  });
  return twice / 2;
}

/** Distance of a point beyond the nose lines, m; negative inside. */
export function beyond([x, y]: Point, [width, length]: Point): number {
  return Math.max(-x, x - width, -y, y - length);
}

/**
 * Distance from a place to the nose line in a direction, m.
 *
 * @param azimuth - Direction, rad.
 * @param size - Size of the playing area, m; null for unbounded cloth, for which the result is 2 m.
 */
export function reach(from: { x: number; y: number }, azimuth: number, size: Point | null): number {
  if (!size) return 2;
  const [dx, dy] = [Math.cos(azimuth), Math.sin(azimuth)];
  const toX = dx > 0 ? (size[0] - from.x) / dx : dx < 0 ? -from.x / dx : Infinity;
  const toY = dy > 0 ? (size[1] - from.y) / dy : dy < 0 ? -from.y / dy : Infinity;
  return Math.max(0, Math.min(toX, toY));
}

/** The parts in the order of the loop, counter-clockwise; each starts at the end of the previous one. */
function chain(geometry: Geometry): Run[] {
  const parts: Part[] = [...geometry.cushions, ...geometry.liners].map((part) => ({
    material: part.part === "liner" ? "liner" : "cushion",
    rail: part.part === "liner" ? "" : part.rail,
    points: part.center ? arc(part.center, part.start, part.end) : [part.start, part.end],
    used: false,
  }));
  const loop: Run[] = [];
  let next = parts.find((part) => part.material === "cushion");
  let flip = false;
  while (next) {
    next.used = true;
    loop.push(flip ? { ...next, points: next.points.toReversed() } : next);
    [next, flip] = nearest(parts, loop.at(-1)!.points.at(-1)!);
    if (next) close(loop, flip ? next.points.toReversed() : next.points, geometry);
  }
  close(loop, loop[0]!.points, geometry);
  if (signedArea(loop.flatMap((run) => run.points)) > 0) return loop;
  return loop.map((run) => ({ ...run, points: run.points.toReversed() })).reverse();
}

/** The unused part that starts at `point` or beyond the next gap, and whether it must be reversed. */
function nearest(parts: readonly Part[], point: Point): [Part | undefined, boolean] {
  const ends = parts.flatMap((part) => [
    { part, last: false, at: part.points[0]! },
    { part, last: true, at: part.points.at(-1)! },
  ]);
  let best: (typeof ends)[number] | undefined;
  let least = Infinity;
  for (const end of ends) {
    const gap = distance(end.at, point);
    if (end.part.used || gap >= least) continue;
    // The part after a gap starts with an end that joins no other part.
    const joined = (other: Part): boolean =>
      other !== end.part &&
      (distance(other.points[0]!, end.at) < JOIN || distance(other.points.at(-1)!, end.at) < JOIN);
    if (gap >= JOIN && parts.some(joined)) continue;
    [best, least] = [end, gap];
  }
  return [best?.part, best?.last ?? false];
}

/**
 * Closes a gap in the loop. With the pocket model `mouth-line` a table has no liners; the facings are then
 * extended to the far side of the hole.
 */
function close(loop: Run[], next: readonly Point[], { pockets, size }: Geometry): void {
  const before = loop.at(-1)!.points;
  const [end, start] = [before.at(-1)!, next[0]!];
  if (distance(end, start) < JOIN || !size) return;
  const middle: Point = [(end[0] + start[0]) / 2, (end[1] + start[1]) / 2];
  const pocket = pockets.toSorted(
    (a, b) => distance(a.center, middle) - distance(b.center, middle),
  )[0];
  if (!pocket) return;
  const { center, radius } = pocket;
  const across = Math.sign(center[0] - size[0] / 2);
  const side = Math.abs(center[1] - size[1] / 2) < radius;
  const outwards = Math.atan2(side ? 0 : Math.sign(center[1] - size[1] / 2), across);
  const from = onCircle(before.at(-2)!, end, center, radius);
  const to = onCircle(next[1]!, start, center, radius);
  const wall = arc(center, from, to, outwards);
  loop.push({ material: "liner", rail: "", points: deduplicated([end, ...wall, start]) });
}

/** The point at which the line from `a` through `b` leaves the circle, or else its nearest point to `b`. */
function onCircle(a: Point, b: Point, center: Point, radius: number): Point {
  const length = distance(a, b);
  const [dx, dy] = [(b[0] - a[0]) / length, (b[1] - a[1]) / length];
  const [x, y] = [b[0] - center[0], b[1] - center[1]];
  const foot = x * dx + y * dy;
  const square = foot * foot - x * x - y * y + radius * radius;
  if (square >= 0) {
    const along = Math.sqrt(square) - foot;
    return [b[0] + along * dx, b[1] + along * dy];
  }
  const scale = radius / Math.hypot(x, y);
  return [center[0] + x * scale, center[1] + y * scale];
}

/** Joins neighbouring parts of one rail or pocket to a run; the loop starts with a cushion. */
function merge(parts: readonly Run[]): Run[] {
  const runs: Run[] = [];
  for (const { material, rail, points } of parts) {
    const last = runs.at(-1);
    if (last?.material === material && last.rail === rail) append(last.points, points);
    else runs.push({ material, rail, points: [...points] });
  }
  // The loop may have started in the middle of a rail.
  const [first, last] = [runs[0]!, runs.at(-1)!];
  if (runs.length > 1 && first.material === last.material && first.rail === last.rail) {
    append(last.points, first.points);
    runs.splice(0, 1);
    runs.unshift(runs.pop()!);
  }
  return runs;
}

/** The point at the back of the cushion behind an end of its nose line. */
export function behind(point: Point, [width, length]: Point, cushion: number): Point {
  const [x, y] = point;
  const depths = [-x, x - width, -y, y - length];
  const deepest = Math.max(...depths);
  // In a corner without a pocket two rails meet; the point is behind both.
  const [left, right, bottom, top] = depths.map((depth) => deepest - depth < JOIN);
  return [
    left ? -cushion : right ? width + cushion : x,
    bottom ? -cushion : top ? length + cushion : y,
  ];
}

function append(line: Point[], points: readonly Point[]): void {
  for (const point of points) {
    const last = line.at(-1);
    if (!last || distance(last, point) > JOIN) line.push(point);
  }
}

function deduplicated(points: readonly Point[]): Point[] {
  const line: Point[] = [];
  append(line, points);
  if (line.length > 1 && distance(line[0]!, line.at(-1)!) <= JOIN) line.pop();
  return line;
}

function distance(a: Point, b: Point): number {
  return Math.hypot(a[0] - b[0], a[1] - b[1]);
}

/** The same angle in (−π, π]. */
function turn(angle: number): number {
  return Math.atan2(Math.sin(angle), Math.cos(angle));
}
