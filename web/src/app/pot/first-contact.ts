/** How the cue ball meets the first ball: what players call the cut. */

import type { Trace, TraceEvent } from "../../engine/index.ts";
import { toDegrees } from "../common/angles.ts";

/** The first contact of the cue ball with another ball. */
export interface Contact {
  /** Id of the object ball. */
  readonly ball: string;
  /** Angle between the cue ball's direction and the line of centres, degrees. */
  readonly cut: number;
  /**
   * How much of the ball is covered by the cue ball as the player sees it, 1 (full) to 0 (not at all):
   * 1 − sin(cut) for equal balls.
   */
  readonly fullness: number;
}

/** The event in which the cue ball meets its first ball, and the places of both in it. */
export interface ContactEvent {
  readonly event: TraceEvent;
  readonly own: number;
  readonly other: number;
}

/** The first event of some types in which the struck ball meets a ball or a cushion; null if there is none. */
export function firstMeeting(
  { shot, events }: Trace,
  ...types: readonly TraceEvent["type"][]
): { readonly event: TraceEvent; readonly own: number } | null {
  const id = shot.struck === null ? undefined : shot.balls[shot.struck]?.id;
  const event = events.find(
    ({ type, balls }) =>
      types.includes(type) &&
      balls.some((ball) => ball === id) &&
      // A strike meets the balls that touch the cue ball: it moves them at once.
      (type !== "cue-strike" || balls.length > 1),
  );
  return event ? { event, own: event.balls.indexOf(id!) } : null;
}

/** The first contact of a shot; null if the cue ball meets no ball, or several at once. */
export function firstContactEvent(trace: Trace): ContactEvent | null {
  const met = firstMeeting(trace, "ball-collision");
  return met?.event.balls.length === 2 ? { ...met, other: 1 - met.own } : null;
}

/** The cut of the first contact; null as for `firstContactEvent`. */
export function firstContact(trace: Trace): Contact | null {
  const found = firstContactEvent(trace);
  if (!found) return null;
  const { event, own, other } = found;
  const [from, to] = [event.before[own]!, event.before[other]!];
  const [x, y] = [to.position[0] - from.position[0], to.position[1] - from.position[1]];
  const [vx, vy] = from.velocity;
  const across = Math.abs(vx * y - vy * x) / (Math.hypot(x, y) * Math.hypot(vx, vy));
  const cut = toDegrees(Math.asin(Math.min(1, across)));
  return { ball: event.balls[other]!, cut, fullness: 1 - Math.min(1, across) };
}
