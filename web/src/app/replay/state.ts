/** What the parts of the replay's panel share. */

import type { Trace } from "../../engine/index.ts";

/** Called when the trace, the selected ball (its index) or the time (s) changes. */
export type Show = (trace: Trace, ball: number, time: number) => void;

/** Offsets of a ball's values in the array of `Trace.statesAt` (see `STRIDE`). */
export const POSITION = 0;
export const VELOCITY = 3;
export const SPIN = 6;
export const MOTION = 13;
