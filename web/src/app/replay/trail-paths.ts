/** The paths of the balls with points close in time, for trails, which end where the balls are. */

import { STRIDE, type Trace } from "../../engine/types.ts";
import { VERTEX } from "../../viewer/viewer-types.ts";

/**
 * Time (s) between two points of a path. Between them the ball is taken to move evenly; one that slides, and
 * so slows down by 2 m/s², is then less than 3 mm from there.
 */
const STEP = 0.1;

/** The paths of all balls, in the order of the shot. @param tolerance As in `Trace.polyline`, m. */
export function timedPaths(trace: Trace, tolerance: number): Float64Array[] {
  const count = Math.floor(trace.duration / STEP);
  const states = Array.from({ length: count }, (_, k) => trace.statesAt((k + 1) * STEP));
  return trace.shot.balls.map((_, ball) => {
    const exact = trace.polyline(ball, tolerance);
    const points: number[] = [...exact.subarray(0, VERTEX)];
    for (let at = VERTEX; at < exact.length; at += VERTEX) {
      const [from, to] = [exact[at - 1]!, exact[at + VERTEX - 1]!];
      for (let k = Math.floor(from / STEP) + 1; k <= count && k * STEP < to; k += 1) {
        points.push(...states[k - 1]!.subarray(ball * STRIDE, ball * STRIDE + 3), k * STEP);
      }
      points.push(...exact.subarray(at, at + VERTEX));
    }
    return Float64Array.from(points);
  });
}
