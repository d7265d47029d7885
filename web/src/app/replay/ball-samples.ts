/** A ball's speed and spin against time. */

import { STRIDE, type Trace } from "../../engine/types.ts";
import { SPIN, VELOCITY } from "../../viewer/viewer-types.ts";

/** A ball's motion at increasing times. An impact has two samples, before and after it. */
export interface Samples {
  /** s */
  times: number[];
  /** m/s */
  speed: number[];
  /** The magnitude of the angular velocity, rad/s. */
  spin: number[];
  /** The vertical component (English), rad/s; positive is counter-clockwise seen from above. */
  side: number[];
}

/** Number of intervals of the grid: enough for a smooth curve at the panel's width. */
const INTERVALS = 160;

/** Samples the exact motion of ball `ball`; at its events the values jump. */
export function sample(trace: Trace, ball: number): Samples {
  const samples: Samples = { times: [], speed: [], spin: [], side: [] };
  const add = (time: number, velocity: ArrayLike<number>, spin: ArrayLike<number>): void => {
    samples.times.push(time);
    samples.speed.push(length(velocity));
    samples.spin.push(length(spin));
    samples.side.push(spin[2]!);
  };
  const states = new Float64Array(STRIDE * trace.shot.balls.length);
  const addExact = (time: number): void => {
    trace.statesAt(time, states);
    const at = ball * STRIDE;
    add(
      time,
      states.subarray(at + VELOCITY, at + VELOCITY + 3),
      states.subarray(at + SPIN, at + SPIN + 3),
    );
  };

  const id = trace.shot.balls[ball]!.id;
  const step = trace.duration / INTERVALS;
  let tick = 0;
  for (const event of trace.events) {
    const index = event.balls.indexOf(id);
    if (index < 0) continue;
    for (; tick * step < event.time; tick++) addExact(tick * step);
    for (const state of [event.before[index], event.after[index]]) {
      if (state) add(event.time, state.velocity, state.angular_velocity);
    }
  }
  for (; tick <= INTERVALS; tick++) addExact(Math.min(tick * step, trace.duration));
  return samples;
}

/** The Euclidean length of a vector of three. */
export function length(v: ArrayLike<number>): number {
  return Math.hypot(v[0]!, v[1]!, v[2]!);
}
