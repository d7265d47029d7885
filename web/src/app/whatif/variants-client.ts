/** The page's side of the what-if worker. */

import type { Engine, Noise, Shot } from "../../engine/index.ts";
import { refusalText } from "../common/refusals.ts";
import type { FromWorker, ToWorker } from "./variants-protocol.ts";
import { Tally } from "./variant-tally.ts";
import { t } from "../words/translate.ts";

/** The results of a request so far. */
export interface VariantsProgress {
  tally: Tally;
  /** Paths of the struck ball in some of the variants: x, y, z (m) per point. */
  paths: readonly Float32Array[];
  done: boolean;
  /** Since the request, ms. */
  elapsed: number;
}

/** Receives results and refusals. */
export interface VariantsListener {
  progress: (progress: VariantsProgress) => void;
  refused: (message: string) => void;
}

/** The part of a worker that the client uses. */
export type WorkerPort = Pick<Worker, "postMessage" | "onmessage" | "onerror" | "terminate">;

/** Requests variants from a worker. A new request cancels the previous one. */
export class Variants {
  readonly #worker: WorkerPort;
  readonly #listener: VariantsListener;
  #generation = 0;
  #progress: VariantsProgress | null = null;
  #asked = 0;

  constructor(worker: WorkerPort, engine: Pick<Engine, "module">, listener: VariantsListener) {
    this.#worker = worker;
    this.#listener = listener;
    worker.onmessage = ({ data }: MessageEvent<FromWorker>) => this.#receive(data);
    worker.onerror = () => listener.refused(t("whatif.no-worker"));
    this.#send({ kind: "engine", module: engine.module });
  }

  /** Requests `count` variants of a shot, and `paths` paths of the struck ball. */
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

  /** The results of the last request; null if there is none. */
  get present(): VariantsProgress | null {
    return this.#progress;
  }

  /** Cancels the request. */
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

  #receive(message: FromWorker): void {
    const now = this.#progress;
    if (message.generation !== this.#generation || !now) return;
    if (message.kind === "refused") {
      this.#progress = null;
      this.#listener.refused(refusalText(message.refusal));
      return;
    }
    if (message.kind === "paths") now.paths = message.paths;
    else now.tally.add(message);
    now.done = now.tally.count === now.tally.total;
    now.elapsed = performance.now() - this.#asked;
    this.#listener.progress(now);
  }
}
