/** Parts of paths: what is flown, what is on the table, and the last second before a time. */

import { VERTEX } from "../viewer-types.ts";

/** Height of a ball above the cloth from which its path counts as flight, m: lower hops are not seen. */
const FLIGHT = 0.004;
/** Duration of a trail, s, and the number of steps in which it fades. */
const DURATION = 1;
const STEPS = 8;

/** A part of a path, and whether the ball flies. */
export interface Part {
  points: number[];
  flies: boolean;
}

/**
 * Splits a path where the ball leaves the cloth and where it lands.
 *
 * @param points - x, y, z (m), t (s) per point.
 * @param radius - Radius of the ball, m.
 */
export function parts(points: ArrayLike<number>, radius: number): Part[] {
  const found: Part[] = [];
  for (let at = 0; at + VERTEX < points.length; at += VERTEX) {
    const top = Math.max(points[at + 2]!, points[at + 2 + VERTEX]!);
    const flies = top > radius + FLIGHT;
    let part = found.at(-1);
    if (part?.flies !== flies) {
      part = { points: slice(points, at, at + VERTEX), flies };
      found.push(part);
    }
    part.points.push(...slice(points, at + VERTEX, at + 2 * VERTEX));
  }
  return found;
}

/** The part of a path between two times (s), with its ends interpolated; empty outside the path. */
export function between(points: ArrayLike<number>, start: number, end: number): number[] {
  const found: number[] = [];
  for (let at = 0; at + VERTEX < points.length; at += VERTEX) {
    const [from, to] = [points[at + 3]!, points[at + 3 + VERTEX]!];
    if (to <= start || from >= end || to === from) continue;
    const [a, b] = [Math.max(start, from), Math.min(end, to)];
    if (found.length === 0) found.push(...interpolated(points, at, (a - from) / (to - from)));
    found.push(...interpolated(points, at, (b - from) / (to - from)));
  }
  return found;
}

/**
 * The trail of a ball: pieces from the newest to the oldest, and their strength from 1 towards 0. A trail
 * ends where the path ends, so it is gone a second after the ball has stopped.
 */
export function trail(
  points: ArrayLike<number>,
  time: number,
): { points: number[]; strength: number }[] {
  const step = DURATION / STEPS;
  return Array.from({ length: STEPS }, (_, i) => ({
    points: between(points, time - (i + 1) * step, time - i * step),
    strength: 1 - (i + 0.5) / STEPS,
  })).filter((piece) => piece.points.length > 0);
}

function interpolated(points: ArrayLike<number>, at: number, t: number): number[] {
  return [0, 1, 2, 3].map(
    (k) => points[at + k]! + t * (points[at + VERTEX + k]! - points[at + k]!),
  );
}

function slice(points: ArrayLike<number>, start: number, end: number): number[] {
  return Array.from({ length: end - start }, (_, k) => points[start + k]!);
}
