/** The worker's side of a desk: one question at a time, in steps between which a new one may come. */

import { load } from "../../../engine/core.ts"; // without embedded WebAssembly: the page sends it
import { refusalOf } from "../../../engine/error.ts";
import type { Engine } from "../../../engine/index.ts";
import { nextTask } from "../../../engine/next-task.ts";
import { chance } from "./chance.ts";
import { leave } from "./leave-strike.ts";
import { plan } from "./plan.ts";
import { pot } from "./pot-line.ts";
import type { FromDesk, Job, Parts, ToDesk } from "./desk-protocol.ts";
import { zone } from "./zone.ts";

/** One end of the connection. */
export interface DeskPort {
  postMessage(message: FromDesk): void;
  onmessage: ((event: { readonly data: ToDesk }) => void) | null;
}

/** Answers the questions that come through `port`. */
export function serveDesk(port: DeskPort): void {
  let engine: Promise<Engine> | null = null;
  let wanted = 0;

  port.onmessage = ({ data }) => {
    if (data.kind === "engine") {
      engine = load(data.module);
      return;
    }
    wanted = data.id;
    if (data.kind === "ask") void answer(data.id, data.job);
  };

  async function answer(id: number, job: Job): Promise<void> {
    try {
      const ready = await engine!;
      // Messages that came meanwhile are read first: a drag asks many questions at once.
      await nextTask();
      if (wanted !== id) return;
      for (const part of steps(ready, job)) {
        if (part) port.postMessage({ kind: "part", id, part });
        await nextTask();
        if (wanted !== id) return;
      }
      port.postMessage({ kind: "done", id });
    } catch (error) {
      port.postMessage({ kind: "failed", id, refusal: refusalOf(error as Error) });
    }
  }
}

/** The parts of an answer; null where a step has none. */
export function steps(engine: Engine, job: Job): Generator<Parts[keyof Parts] | null> {
  switch (job.kind) {
    case "chance":
      return chance(engine, job);
    case "pot":
      return pot(engine, job);
    case "leave":
      return leave(engine, job);
    case "zone":
      return zone(engine, job);
    case "plan":
      return plan(engine, job);
  }
}
