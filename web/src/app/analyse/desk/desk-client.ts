/** The page's side of a desk. A question replaces the one before. */

import type { Engine } from "../../../engine/index.ts";
import { refusalText } from "../../common/refusals.ts";
import { t } from "../../words/translate.ts";
import type { FromDesk, Job, PartOf, Parts, ToDesk } from "./desk-protocol.ts";

/** The part of a worker that a desk uses. */
export type DeskWorker = Pick<Worker, "postMessage" | "onmessage" | "onerror" | "terminate">;

export interface Answer<Part> {
  part: (part: Part) => void;
  done?: () => void;
  refused?: (message: string) => void;
}

export class Desk {
  readonly #start: () => DeskWorker;
  readonly #engine: Pick<Engine, "module">;
  #worker: DeskWorker | null = null;
  #id = 0;
  #answer: Answer<Parts[keyof Parts]> | null = null;

  /** @param start Starts a worker that runs the desk; it is called with the first question. */
  constructor(start: () => DeskWorker, engine: Pick<Engine, "module">) {
    this.#start = start;
    this.#engine = engine;
  }

  ask<J extends Job>(job: J, answer: Answer<PartOf<J>>): void {
    this.#answer = answer as Answer<Parts[keyof Parts]>;
    this.#send({ kind: "ask", id: ++this.#id, job });
  }

  cancel(): void {
    if (!this.#answer) return;
    this.#answer = null;
    this.#send({ kind: "cancel", id: ++this.#id });
  }

  close(): void {
    this.#answer = null;
    this.#worker?.terminate();
    this.#worker = null;
  }

  #send(message: ToDesk): void {
    this.#worker ??= this.#open();
    this.#worker.postMessage(message);
  }

  #open(): DeskWorker {
    const worker = this.#start();
    worker.onmessage = ({ data }: MessageEvent<FromDesk>) => this.#receive(data);
    worker.onerror = () => this.#answer?.refused?.(t("whatif.no-worker"));
    worker.postMessage({ kind: "engine", module: this.#engine.module } satisfies ToDesk);
    return worker;
  }

  #receive(message: FromDesk): void {
    const answer = this.#answer;
    if (message.id !== this.#id || !answer) return;
    if (message.kind === "part") answer.part(message.part);
    else {
      this.#answer = null;
      if (message.kind === "done") answer.done?.();
      else answer.refused?.(refusalText(message.refusal));
    }
  }
}
