/** Simulates variants in a worker, so that the page stays responsive. */

import { load } from "../../engine/core.ts"; // without embedded WebAssembly: the page sends it
import type { Engine } from "../../engine/index.ts";
import { nextTask } from "../../engine/next-task.ts";
import type { FromWorker, ToWorker } from "./variants-protocol.ts";
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
