/** The page's side of a thinker. It starts no worker of its own, so a page can give one that it contains. */

import type { TableOptions } from "./drawn-tables.ts";
import type { Engine } from "./engine.ts";
import { CaromError } from "./error.ts";
import type { Analysis, Decision, ExplainOptions, PlayerOptions, Progress } from "./player.ts";
import type { Frame, FrameRecord } from "./rules.ts";
import type { Failure, FromThinker, ToThinker } from "./thinker-protocol.ts";

/** The part of a worker that a thinker uses. */
export type ThinkerWorker = Pick<Worker, "postMessage" | "onmessage" | "onerror" | "terminate">;

/** Options of a question; those of the player replace the thinker's. */
export interface ThinkOptions extends PlayerOptions, TableOptions {
  /** Receives what the search has found after every round. */
  readonly onProgress?: (progress: Progress) => void;
}

/** A player in a worker. Questions are answered one after the other. */
export interface Thinker {
  /** As `Player.choose`; a frame is sent as its record. */
  choose(frame: Frame | FrameRecord, options?: ThinkOptions): Promise<Decision>;
  /** As `Player.explain`. */
  explain(frame: Frame | FrameRecord, options?: ThinkOptions & ExplainOptions): Promise<Analysis>;
  /**
   * Ends the questions asked so far: each search ends when its present round does, and its result has the
   * best plays of the rounds until then. Every search has at least one round. Players of the literature
   * have only one.
   */
  stop(): void;
  /** Ends the worker at once. Questions without an answer are refused. */
  close(): void;
}

interface Question {
  readonly resolve: (result: Decision | Analysis) => void;
  readonly reject: (error: Error) => void;
  readonly onProgress: ((progress: Progress) => void) | undefined;
}

/**
 * A thinker in a worker that runs `carom-engine/thinker-worker`.
 *
 * @throws CaromError if the worker does not start.
 */
export async function connectThinker(
  engine: Pick<Engine, "module">,
  worker: ThinkerWorker,
  player: PlayerOptions = {},
): Promise<Thinker> {
  const thinker = new ConnectedThinker(worker, player);
  await thinker.start(engine.module);
  return thinker;
}

class ConnectedThinker implements Thinker {
  readonly #worker: ThinkerWorker;
  readonly #player: PlayerOptions;
  readonly #questions = new Map<number, Question>();
  #asked = 0;
  /** Why there are no more answers. */
  #end: Error | null = null;
  #started: { readonly resolve: () => void; readonly reject: (error: Error) => void } | null = null;

  constructor(worker: ThinkerWorker, player: PlayerOptions) {
    this.#worker = worker;
    this.#player = player;
    worker.onmessage = ({ data }: MessageEvent<FromThinker>) => this.#receive(data);
    worker.onerror = ({ message = "" }) => {
      const why = message === "" ? "" : ` (${message})`;
      this.#finish(
        new CaromError({
          kind: "system",
          place: "worker",
          fault: `it failed${why}`,
          remedy: "give a worker that runs carom-engine/thinker-worker",
        }),
      );
    };
  }

  start(module: WebAssembly.Module): Promise<void> {
    return new Promise((resolve, reject) => {
      this.#started = { resolve, reject };
      this.#send({ kind: "engine", module });
    });
  }

  choose(frame: Frame | FrameRecord, options: ThinkOptions = {}): Promise<Decision> {
    return this.#ask(frame, options, null) as Promise<Decision>;
  }

  explain(
    frame: Frame | FrameRecord,
    { count = 5, ...options }: ThinkOptions & ExplainOptions = {},
  ): Promise<Analysis> {
    return this.#ask(frame, options, count) as Promise<Analysis>;
  }

  async #ask(
    frame: Frame | FrameRecord,
    { onProgress, posterior, draws, ...player }: ThinkOptions,
    count: number | null,
  ): Promise<Decision | Analysis> {
    if (this.#end) throw this.#end;
    const record = "record" in frame ? frame.record : frame;
    const id = ++this.#asked;
    return new Promise((resolve, reject) => {
      this.#questions.set(id, { resolve, reject, onProgress });
      const asked = { ...this.#player, ...player };
      const tables = { ...(posterior && { posterior }), ...(draws !== undefined && { draws }) };
      this.#send({ kind: "think", id, frame: record, player: asked, tables, count });
    });
  }

  stop(): void {
    this.#send({ kind: "stop", last: this.#asked });
  }

  close(): void {
    this.#finish(
      new CaromError({
        kind: "wrong-state",
        place: "thinker",
        fault: "it was closed",
        remedy: "create another one",
      }),
    );
  }

  #send(message: ToThinker): void {
    this.#worker.postMessage(message);
  }

  #finish(error: Error): void {
    this.#end ??= error;
    this.#worker.terminate();
    this.#started?.reject(error);
    for (const { reject } of this.#questions.values()) reject(error);
    this.#questions.clear();
  }

  #receive(message: FromThinker): void {
    switch (message.kind) {
      case "ready":
        this.#started?.resolve();
        return;
      case "unready":
        this.#finish(errorOf(message.failure));
        return;
      case "progress":
        this.#questions.get(message.id)?.onProgress?.(message.progress);
        return;
      case "result":
        this.#questions.get(message.id)?.resolve(message.result);
        break;
      case "failed":
        this.#questions.get(message.id)?.reject(errorOf(message.failure));
    }
    this.#questions.delete(message.id);
  }
}

function errorOf({ message, refusal }: Failure): Error {
  return refusal ? new CaromError(refusal) : new Error(message);
}
