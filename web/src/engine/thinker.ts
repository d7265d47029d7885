/** A player that thinks in a worker, so that the calling thread stays free. */

import type { Engine } from "./engine.ts";
import type { PlayerOptions } from "./player.ts";
import { connectThinker, type Thinker, type ThinkerWorker } from "./thinker-client.ts";

export type { Thinker, ThinkerWorker, ThinkOptions } from "./thinker-client.ts";

export interface ThinkerOptions extends PlayerOptions {
  /**
   * A worker that runs `carom-engine/thinker-worker`. A page in one file gives one that it contains.
   * Default: the file of the package.
   */
  readonly worker?: ThinkerWorker;
}

/** A worker of `node:worker_threads`. */
interface NodeWorker {
  postMessage(message: unknown): void;
  on(event: "message", listener: (data: unknown) => void): unknown;
  on(event: "error", listener: (error: Error) => void): unknown;
  terminate(): Promise<number>;
}

/** In a variable, so that bundlers for browsers do not look for it. */
const NODE_THREADS = "node:worker_threads";

/**
 * Starts a thinker: a player with these options, in a worker with the compiled module of `engine`.
 *
 * @throws CaromError if the worker does not start. An invalid option is refused by the first question.
 */
export async function createThinker(
  engine: Pick<Engine, "module">,
  { worker, ...player }: ThinkerOptions = {},
): Promise<Thinker> {
  return connectThinker(engine, worker ?? (await startWorker()), player);
}

async function startWorker(): Promise<ThinkerWorker> {
  if (typeof Worker === "function") {
    // Bundlers recognise this form.
    return new Worker(new URL("./thinker-worker.js", import.meta.url), { type: "module" });
  }
  const { Worker: Thread } = (await import(/* @vite-ignore */ NODE_THREADS)) as {
    Worker: new (url: URL) => NodeWorker;
  };
  return inNode(new Thread(new URL("./thinker-worker.js", import.meta.url)));
}

/** A worker of Node with the interface of browsers. */
function inNode(thread: NodeWorker): ThinkerWorker {
  const worker: {
    -readonly [K in keyof ThinkerWorker]: K extends `on${string}`
      ? ((event: { readonly data?: unknown; readonly message?: string }) => void) | null
      : unknown;
  } = {
    onmessage: null,
    onerror: null,
    postMessage: (message: unknown) => thread.postMessage(message),
    terminate: () => void thread.terminate(),
  };
  thread.on("message", (data: unknown) => worker.onmessage?.({ data }));
  thread.on("error", (error: Error) => worker.onerror?.(error));
  return worker as ThinkerWorker;
}
