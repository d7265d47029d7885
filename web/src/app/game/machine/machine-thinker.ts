/** The page's player, in a worker of its own that starts when it is first asked. */

import ThinkerWorker from "../../../engine/thinker-worker.ts?worker&inline";
import type { Engine } from "../../../engine/index.ts";
import { connectThinker, type Thinker } from "../../../engine/thinker-client.ts";

/** The worker's name, by which a debugger and the tests tell it from the page's other workers. */
const NAME = "player";

let thinker: Promise<Thinker> | null = null;

/** The player; every part of the page that asks it shares the worker. */
export function thinkerOf(engine: Engine): Promise<Thinker> {
  thinker ??= connectThinker(engine, new ThinkerWorker({ name: NAME })).catch((error: unknown) => {
    // The next question tries again.
    thinker = null;
    throw error;
  });
  return thinker;
}

/**
 * Starts the worker before it is asked, and lets it choose a break with few simulations: the browser compiles
 * the engine's code while it runs, which took longer than the first decision of a machine.
 */
export function prepareThinker(engine: Engine): void {
  if (thinker) return;
  const frame = engine.frame("nine-ball");
  const { record } = frame;
  frame.free();
  thinkerOf(engine)
    .then((ready) => ready.choose(record, { name: "level-1" }))
    // A question of a game reports what is wrong.
    .catch(() => undefined);
}
