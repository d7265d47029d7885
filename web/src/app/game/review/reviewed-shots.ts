/** The shots of a game, to be replayed one by one. The game stays as it is. */

import type { Engine, Trace } from "../../../engine/index.ts";
import type { Store } from "../../document/store.ts";
import { replay } from "../../replay/replay-control.ts";
import type { PlayedMove, Progress } from "../game-progress.ts";
import { standing } from "../awaited-turn.ts";

/** Traces by their moves. The history keeps the moves, and so keeps these entries alive. */
const known = new WeakMap<PlayedMove, Trace>();

/** Whether a move is a shot. */
export function isShot({ move }: PlayedMove): boolean {
  return "play" in move;
}

/** The trace of a move; null if the move is not a shot. */
export function traceOf({ steps, trace }: Progress, index: number): Trace | null {
  const step = steps[index];
  if (!step || !("play" in step.move)) return null;
  if (index === steps.findLastIndex(isShot)) return trace;
  let found = known.get(step);
  if (!found) {
    // Not from the start of the game: that would take longer with every move.
    const frame = step.from.copy();
    found = frame.play(step.move.play).trace;
    frame.free();
    known.set(step, found);
  }
  return found;
}

/** The index of the move whose shot is replayed; null if none is. */
export function replayedMove(store: Store, engine: Engine): number | null {
  const { trace } = store.session.replay;
  const progress = standing(store, engine);
  if (!trace || !progress) return null;
  const { steps } = progress;
  if (trace === progress.trace) return steps.findLastIndex(isShot);
  const index = steps.findIndex((step) => known.get(step) === trace);
  return index < 0 ? null : index;
}

/** The index of the shot before or after a move; null if there is none. */
export function neighbour(
  { steps }: Pick<Progress, "steps">,
  index: number,
  step: 1 | -1,
): number | null {
  for (let k = index + step; k >= 0 && k < steps.length; k += step) {
    if (isShot(steps[k]!)) return k;
  }
  return null;
}

/** Replays the shot of a move. @param still Whether to show its end at once. */
export function replayMove(store: Store, engine: Engine, index: number, still: boolean): void {
  const progress = standing(store, engine);
  const trace = progress && traceOf(progress, index);
  if (trace) replay(store, trace, still ? trace.duration : 0, !still);
}
