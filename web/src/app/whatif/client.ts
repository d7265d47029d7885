// The page's end of the worker.

import type { Engine, Noise, Shot } from "../../engine/index.ts";
import type { FromWorker, ToWorker } from "./protocol.ts";
import { Tally } from "./tally.ts";

/** What is known of a request so far. */
export interface Progress {
  tally: Tally;
  /** The struck ball's ways in some of the variants: x, y, z (m) per point of each. */
  paths: readonly Float32Array[];
  done: boolean;
  /** Since the request, ms. */
  elapsed: number;
}

export interface Ear {
  progress: (progress: Progress) => void;
  refused: (message: string) => void;
}

/** The part of a worker that the client needs. */
export type Line = Pick<Worker, "postMessage" | "onmessage" | "onerror" | "terminate">;

/** Asks a worker for variants; a new question makes the one before it stale. */
export class Variants {
  readonly #worker: Line;
  readonly #ear: Ear;
  #generation = 0;
  #progress: Progress | null = null;
  #asked = 0;

  constructor(worker: Line, engine: Pick<Engine, "module">, ear: Ear) {
    this.#worker = worker;
    this.#ear = ear;
    worker.onmessage = ({ data }: MessageEvent<FromWorker>) => this.#hear(data);
    worker.onerror = () =>
      ear.refused("This browser does not let the page simulate beside itself.");
    this.#send({ kind: "engine", module: engine.module });
  }

  /** Asks for `count` variants of a shot, and for `paths` of the struck ball's ways. */
  ask(shot: Shot, noise: Noise, seed: number, count: number, paths: number): void {
    const generation = ++this.#generation;
    this.#asked = performance.now();
    this.#progress = {
      tally: new Tally(shot.balls.length, count),
      paths: [],
      done: false,
      elapsed: 0,
    };
    this.#send({ kind: "simulate", generation, shot: shot.json(), noise, seed, count, paths });
  }

  /** What is known of the last question; null if there is none. */
  get present(): Progress | null {
    return this.#progress;
  }

  /** Forgets the question. */
  cancel(): void {
    this.#progress = null;
    this.#send({ kind: "cancel", generation: ++this.#generation });
  }

  close(): void {
    this.#worker.terminate();
  }

  #send(message: ToWorker): void {
    this.#worker.postMessage(message);
  }

  #hear(message: FromWorker): void {
    const now = this.#progress;
    if (message.generation !== this.#generation || !now) return;
    if (message.kind === "refused") {
      this.#progress = null;
      this.#ear.refused(message.message);
      return;
    }
    if (message.kind === "paths") now.paths = message.paths;
    else now.tally.add(message);
    now.done = now.tally.count === now.tally.total;
    now.elapsed = performance.now() - this.#asked;
    this.#ear.progress(now);
  }
}
