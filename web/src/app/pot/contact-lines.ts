/** Lines that players aim by: the tangent line and the natural angle of the cue ball. */

import type { Point, Trace } from "../../engine/index.ts";
import { firstContactEvent } from "./first-contact.ts";

/** Length of a line, m. */
const LENGTH = 0.7;

/** Directions of the cue ball behind its first contact, with the place where they begin. */
export interface ContactLines {
  readonly from: Point;
  /** Unit vectors. */
  readonly tangent: Point;
  readonly natural: Point;
}

/**
 * The lines of the first contact; null if the cue ball meets no ball, or meets it full.
 *
 * For equal balls without friction and loss a cue ball that slides leaves along the tangent of the contact
 * with v·sin(cut). One that rolls keeps the spin of its roll, and rolls on with 5/7 of that velocity and 2/7
 * of the velocity before (D. G. Alciatore, "The amazing world of billiards physics", proof TP 3.3).
 */
export function contactLinesOf(trace: Trace): ContactLines | null {
  const found = firstContactEvent(trace);
  if (!found) return null;
  const { event, own, other } = found;
  const [ball, met] = [event.before[own]!, event.before[other]!];
  const [x, y] = [met.position[0] - ball.position[0], met.position[1] - ball.position[1]];
  const apart = Math.hypot(x, y);
  const [vx, vy] = ball.velocity;
  const speed = Math.hypot(vx, vy);
  // Along the tangent: (−y, x) over the distance of the centres.
  const across = (vy * x - vx * y) / apart;
  if (Math.abs(across) < 1e-3 * speed) return null;
  const slid: Point = [(-y / apart) * across, (x / apart) * across];
  const natural = unit([(5 / 7) * slid[0] + (2 / 7) * vx, (5 / 7) * slid[1] + (2 / 7) * vy]);
  return { from: [ball.position[0], ball.position[1]], tangent: unit(slid), natural };
}

function unit([x, y]: Point): Point {
  const length = Math.hypot(x, y);
  return [x / length, y / length];
}

/**
 * A line from a place of the cloth, as the points of a path: x, y, z (m), t (s). It ends at the edge of a
 * cloth of this size, less `radius`.
 */
export function lineFrom(
  [x, y]: Point,
  [dx, dy]: Point,
  size: Point | null,
  radius: number,
): Float64Array {
  const room = (at: number, step: number, most: number) =>
    step > 0 ? (most - radius - at) / step : step < 0 ? (radius - at) / step : Infinity;
  const free = size ? Math.min(room(x, dx, size[0]), room(y, dy, size[1])) : Infinity;
  const length = Math.max(0, Math.min(LENGTH, free));
  return Float64Array.of(x, y, radius, 0, x + length * dx, y + length * dy, radius, 0);
}
