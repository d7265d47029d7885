/** What the parts of the replay's panel share. */

import type { Trace } from "../../engine/index.ts";

/** Called when the trace, the selected ball (its index) or the time (s) changes. */
export type Show = (trace: Trace, ball: number, time: number) => void;
