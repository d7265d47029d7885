/** The instants at which events happen, and the steps from one to the next. */

import type { TraceEvent } from "../../engine/index.ts";

/** The events of one instant. Simultaneous impacts are one step of the replay. */
export interface Moment {
  /** Time since the strike, s. */
  time: number;
  /** Indices of its events in the trace. */
  events: number[];
}

/**
 * The event that stands for each one in a list: a ball that hops to rest lands a dozen times, one after another,
 * and its first landing stands for all of them.
 */
export function representatives(events: readonly TraceEvent[]): readonly number[] {
  /** By ball, the first of the landings since its last other event. */
  const landings = new Map<string, number>();
  return events.map(({ type, balls }, index) => {
    const [ball = ""] = balls;
    const first = type === "slate-collision" ? landings.get(ball) : undefined;
    if (first !== undefined) return first;
    for (const each of balls) landings.delete(each);
    if (type === "slate-collision") landings.set(ball, index);
    return index;
  });
}

/** Groups the events of a trace, which are in the order of time, into moments. */
export function moments(events: readonly TraceEvent[]): Moment[] {
  const found: Moment[] = [];
  events.forEach((event, index) => {
    const last = found.at(-1);
    if (last?.time === event.time) last.events.push(index);
    else found.push({ time: event.time, events: [index] });
  });
  return found;
}

/** The first moment after `time`, if there is one. */
export function next(of: readonly Moment[], time: number): Moment | undefined {
  return of[countUpTo(of, time)];
}

/** The last moment before `time`, if there is one. */
export function previous(of: readonly Moment[], time: number): Moment | undefined {
  const count = countUpTo(of, time);
  return of[count - 1]?.time === time ? of[count - 2] : of[count - 1];
}

/** The last moment at or before `time`, if there is one. */
export function latest(of: readonly Moment[], time: number): Moment | undefined {
  return of[countUpTo(of, time) - 1];
}

/** The number of moments at or before `time`, by bisection. */
function countUpTo(of: readonly Moment[], time: number): number {
  let low = 0;
  let high = of.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (of[middle]!.time <= time) low = middle + 1;
    else high = middle;
  }
  return low;
}
