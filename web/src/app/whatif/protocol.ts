// What the page and the worker say to each other.

import type { Noise } from "../../engine/index.ts";

/** Many variants of one shot. */
export interface Request {
  /** Grows with every request; what belongs to an earlier one is stale. */
  generation: number;
  /** A `carom-shot/1`, as the engine writes it. */
  shot: string;
  noise: Noise;
  /** Variant i of a seed is the same on every machine and in every order. */
  seed: number;
  /** How many variants. */
  count: number;
  /** Of how many of them the cue ball's path is drawn. */
  paths: number;
}

export type ToWorker =
  | { kind: "engine"; module: WebAssembly.Module }
  | ({ kind: "simulate" } & Request)
  | { kind: "cancel"; generation: number };

/** Variants `first … first + count − 1`. */
export interface Chunk {
  generation: number;
  first: number;
  count: number;
  /** Where the struck ball ends, x and y in m; NaN where a variant failed. */
  ends: Float64Array;
  /** count × balls: the pocket's index or a code, as `Batch.pocket` has it. */
  pockets: Int8Array;
  /** Why variants failed, by their place in the chunk. */
  errors: ReadonlyMap<number, string>;
}

export type FromWorker =
  | ({ kind: "chunk" } & Chunk)
  /** The struck ball's ways, each x, y, z (m) per point. */
  | { kind: "paths"; generation: number; paths: Float32Array[] }
  | { kind: "refused"; generation: number; message: string };
