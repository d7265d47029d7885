/** The page's player, in a worker of its own that starts when it is first asked. */

import ThinkerWorker from "../../../engine/thinker-worker.ts?worker&inline";
import type { Engine } from "../../../engine/index.ts";
import { connectThinker, type Thinker } from "../../../engine/thinker-client.ts";

let thinker: Promise<Thinker> | null = null;

/** The player; every part of the page that asks it shares the worker. */
export function thinkerOf(engine: Engine): Promise<Thinker> {
  thinker ??= connectThinker(engine, new ThinkerWorker()).catch((error: unknown) => {
    // The next question tries again.
    thinker = null;
    throw error;
  });
  return thinker;
}
