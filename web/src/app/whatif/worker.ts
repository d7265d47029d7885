// Simulates variants beside the page, so that the page stays fluid.

import { load } from "../../engine/core.ts"; // whose WebAssembly comes from the page
import type { Engine } from "../../engine/index.ts";
import type { FromWorker, ToWorker } from "./protocol.ts";
import { simulate, type Surroundings } from "./variants.ts";

let engine: Promise<Engine> | null = null;
let wanted = 0;

const surroundings: Surroundings = {
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
  await simulate(await engine, request, surroundings);
}

/** A task later. Timers would do, but browsers hold nested ones back by 4 ms each. */
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
