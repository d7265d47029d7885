/** The worker's side of a thinker: one question after the other, round by round. */

import { load } from "./core.ts"; // without embedded WebAssembly: the page sends it
import type { Engine } from "./engine.ts";
import { CaromError, refusalOf } from "./error.ts";
import { nextTask } from "./next-task.ts";
import type { Analysis, Decision, Thought } from "./player.ts";
import type {
  Failure,
  FromThinker,
  ThinkerPort,
  ThinkRequest,
  ToThinker,
} from "./thinker-protocol.ts";

/** Answers the questions that come through `port`. */
export function serve(port: ThinkerPort<FromThinker, ToThinker>): void {
  /** Questions up to this one are stopped. */
  let stopped = 0;
  let engine: Promise<Engine> | null = null;
  let busy = Promise.resolve();

  port.onmessage = ({ data }) => {
    if (data.kind === "stop") stopped = Math.max(stopped, data.last);
    else if (data.kind === "engine") engine = begin(data.module);
    else busy = busy.then(() => answer(data));
  };

  async function begin(module: WebAssembly.Module): Promise<Engine> {
    const loading = load(module);
    loading.then(
      () => port.postMessage({ kind: "ready" }),
      (error: unknown) => port.postMessage({ kind: "unready", failure: failureOf(error) }),
    );
    return loading;
  }

  async function answer(request: ThinkRequest): Promise<void> {
    const { id } = request;
    try {
      if (!engine) throw new Error("a thinker gets its engine before the first question");
      const result = await think(await engine, request);
      port.postMessage({ kind: "result", id, result });
    } catch (error) {
      port.postMessage({ kind: "failed", id, failure: failureOf(error) });
    }
  }

  async function think(engine: Engine, request: ThinkRequest): Promise<Decision | Analysis> {
    const { id, count, tables } = request;
    const player = engine.player(request.player);
    const frame = engine.replay(request.frame);
    let thought: Thought<Decision | Analysis> | null = null;
    try {
      thought =
        count === null
          ? player.beginChoice(frame, tables)
          : player.beginAnalysis(frame, { count, ...tables });
      while (thought.playRound()) {
        port.postMessage({ kind: "progress", id, progress: thought.progress });
        await nextTask();
        if (stopped >= id) break;
      }
      return thought.end(stopped >= id);
    } finally {
      thought?.free();
      frame.free();
      player.free();
    }
  }
}

function failureOf(error: unknown): Failure {
  if (error instanceof CaromError) {
    return { message: error.message, refusal: refusalOf(error) };
  }
  return { message: error instanceof Error ? error.message : String(error), refusal: null };
}
