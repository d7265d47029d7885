/** Actions on a replay, shared by buttons and keys. */

import { STROKE } from "./replay-clock.ts";
import type { Store } from "../document/store.ts";
import { type Moment, moments, next, previous } from "./event-moments.ts";
import type { Trace } from "../../engine/index.ts";

const found = new WeakMap<Trace, readonly Moment[]>();

/** The moments of the replayed trace; none while aiming. */
export function momentsOf(trace: Trace | null): readonly Moment[] {
  if (!trace) return [];
  let list = found.get(trace);
  if (!list) found.set(trace, (list = moments(trace.events)));
  return list;
}

/** Pauses at a time (s), clamped to the shot's duration. */
export function seek(store: Store, time: number): void {
  const { trace } = store.session.replay;
  if (!trace) return;
  const within = Math.min(Math.max(time, 0), trace.duration);
  store.setPart("replay", { playing: false, stroke: 0, time: within });
}

/** Pauses or plays. At the end of the replay it plays from the start. */
export function togglePlaying(store: Store): void {
  const { trace, playing, time } = store.session.replay;
  if (!trace) return;
  if (playing) store.setPart("replay", { playing: false });
  else if (time >= trace.duration) replay(store, trace);
  else store.setPart("replay", { playing: true });
}

/** Pauses at the next event, or at the end. */
export function stepForwards(store: Store): void {
  const { trace, time } = store.session.replay;
  if (!trace) return;
  const moment = next(momentsOf(trace), time);
  seek(store, moment?.time ?? trace.duration);
}

/** Pauses at the previous event, or at the start. */
export function stepBackwards(store: Store): void {
  const { trace, time } = store.session.replay;
  if (!trace) return;
  seek(store, previous(momentsOf(trace), time)?.time ?? 0);
}

/** Shows a trace from `time` (s) on; from its start on with the stroke of the cue, if it has one. */
export function replay(store: Store, trace: Trace, time = 0, playing = true): void {
  const stroke = playing && time === 0 && trace.shot.strike ? STROKE : 0;
  const shown = { ...store.session.replay, trace, stroke, time, playing };
  store.setSession({ mode: "replay", replay: shown, refusal: null });
}

/** Ends the replay and returns to aiming the same shot. */
export function leave(store: Store): void {
  const shown = { ...store.session.replay, trace: null, stroke: 0, time: 0, playing: false };
  store.setSession({ mode: "aim", replay: shown });
}
