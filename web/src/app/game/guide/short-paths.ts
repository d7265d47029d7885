/** What a game shows of the aimed shot before it is played. */

import type { Trace, TraceEvent } from "../../../engine/index.ts";
import type { BallPath } from "../../../viewer/index.ts";
import { VERTEX } from "../../../viewer/viewer-types.ts";
import { firstMeeting } from "../../pot/first-contact.ts";

/** Length of a path behind the first contact, m: it shows a direction, and not how far the ball runs. */
const STUB = 0.2;

/** Events that turn a ball; a hop on the slate does not. */
const MEETINGS = ["ball-collision", "rail-collision", "pocket-collision"] as const;

/** The end of the aim line: the first ball or cushion that the struck ball meets; null if it meets none. */
export function endOfAimLine(trace: Trace): TraceEvent | null {
  return firstMeeting(trace, "cue-strike", ...MEETINGS)?.event ?? null;
}

/**
 * The short guide: the path of the struck ball to its first contact, and from there the directions of the
 * balls that met. What happens afterwards is not shown.
 *
 * @param tolerance Greatest distance of the drawn paths from the exact ones, m.
 */
export function shortPaths(trace: Trace, tolerance: number): BallPath[] {
  const { struck, balls } = trace.shot;
  if (struck === null) return [];
  const meeting = endOfAimLine(trace);
  // Of a rack that is hit, only the line to it is shown.
  const pair = meeting && meeting.balls.length <= 2 ? meeting.balls : [];
  const met = pair.map((id) => balls.findIndex((ball) => ball.id === id));
  return [...new Set([struck, ...met])].map((ball) => {
    const points = trace.polyline(ball, tolerance);
    const from = meeting?.time ?? Infinity;
    const until = meeting ? nextEvent(trace, balls[ball]!.id, meeting) : Infinity;
    return { ball, points: shortened(points, from, until), style: "ghost" };
  });
}

/** The time at which a ball next meets something after its first contact, s. */
function nextEvent({ events, duration }: Trace, id: string, meeting: TraceEvent): number {
  const next = events.find(
    ({ type, time, balls }) =>
      time > meeting.time && balls.includes(id) && MEETINGS.some((meets) => meets === type),
  );
  return next?.time ?? duration;
}

/** A path up to the time `from`, and then at most `STUB` further and not beyond the time `until`, s. */
function shortened(points: Float64Array, from: number, until: number): Float64Array {
  const kept: number[] = [];
  let left = STUB;
  for (let k = 0; k < points.length; k += VERTEX) {
    const vertex = points.subarray(k, k + VERTEX);
    const before = kept.slice(-VERTEX);
    if (before.length > 0 && before[3]! >= from) {
      const step = Math.hypot(
        vertex[0]! - before[0]!,
        vertex[1]! - before[1]!,
        vertex[2]! - before[2]!,
      );
      if (vertex[3]! > until) break;
      if (step >= left) {
        const share = left / step;
        kept.push(...before.map((value, i) => value + share * (vertex[i]! - value)));
        break;
      }
      left -= step;
    }
    kept.push(...vertex);
  }
  return Float64Array.from(kept);
}
