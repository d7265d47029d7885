/** The messages between a thinker and its worker. */

import type { TableOptions } from "./drawn-tables.ts";
import type { Refusal } from "./error.ts";
import type { Analysis, Decision, PlayerOptions, Progress } from "./player.ts";
import type { FrameRecord } from "./rules.ts";

/** A question: the decision in a frame, or with `count` its best plays. */
export interface ThinkRequest {
  /** Number of the question, from 1 on. */
  readonly id: number;
  readonly frame: FrameRecord;
  readonly player: PlayerOptions;
  readonly tables: TableOptions;
  readonly count: number | null;
}

/** An error as a message. */
export interface Failure {
  readonly message: string;
  /** Null unless the error is a `CaromError`. */
  readonly refusal: Refusal | null;
}

export type ToThinker =
  | { readonly kind: "engine"; readonly module: WebAssembly.Module }
  | ({ readonly kind: "think" } & ThinkRequest)
  /** Ends all questions up to this one after their present rounds. */
  | { readonly kind: "stop"; readonly last: number };

export type FromThinker =
  | { readonly kind: "ready" }
  | { readonly kind: "unready"; readonly failure: Failure }
  | { readonly kind: "progress"; readonly id: number; readonly progress: Progress }
  | { readonly kind: "result"; readonly id: number; readonly result: Decision | Analysis }
  | { readonly kind: "failed"; readonly id: number; readonly failure: Failure };

/** One end of a connection. */
export interface ThinkerPort<Sent, Received> {
  postMessage(message: Sent): void;
  onmessage: ((event: { readonly data: Received }) => void) | null;
}
