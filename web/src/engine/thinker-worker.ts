/** The worker of a thinker, in browsers and in Node. */

import type { FromThinker, ThinkerPort, ToThinker } from "./thinker-protocol.ts";
import { serve } from "./thinker-server.ts";

type Port = ThinkerPort<FromThinker, ToThinker>;

/** In a variable, so that bundlers for browsers do not look for it. */
const NODE_THREADS = "node:worker_threads";

if (typeof postMessage === "function") {
  serve(globalThis as unknown as Port);
} else {
  void import(/* @vite-ignore */ NODE_THREADS).then(({ parentPort }: { parentPort: Port }) =>
    serve(parentPort),
  );
}
