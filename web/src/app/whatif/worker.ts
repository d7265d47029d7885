/** Simulates variants in a worker, so that the page stays responsive. */

import { load } from "../../engine/core.ts"; // without embedded WebAssembly: the page sends it
import type { Engine } from "../../engine/index.ts";
import type { FromWorker, ToWorker } from "./protocol.ts";
import { simulate, type WorkerContext } from "./variants.ts";

let engine: Promise<Engine> | null = null;
let wanted = 0;

const context: WorkerContext = {
  send: (message: FromWorker, transfer) => postMessage(message, { transfer }),
  isStale: (generation) => generation !== wanted,
  pause: nextTask,
};

addEventListener("message", ({ data }: MessageEvent<ToWorker>) => {
  if (data.kind === "engine") {
    engine = load(data.module);
    return;
  }
  wanted = data.generation;
  if (data.kind === "simulate") void run(data);
});

async function run(request: Extract<ToWorker, { kind: "simulate" }>): Promise<void> {
  if (!engine) return;
  await simulate(await engine, request, context);
}

/** Resolves in the next task. Nested timers would work too, but browsers delay them by 4 ms each. */
function nextTask(): Promise<void> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
}
