/** The messages between the page and the worker. */

import type { Noise, Refusal } from "../../engine/index.ts";

/** A request for variants of one shot. */
export interface VariantsRequest {
  /** Number of the request; messages of earlier ones are stale. */
  generation: number;
  /** A shot file, as the engine writes it. */
  shot: string;
  noise: Noise;
  /** Variant i of a seed is the same on every machine and in every order. */
  seed: number;
  /** How many variants. */
  count: number;
  /** Number of variants whose path of the struck ball is drawn. */
  paths: number;
}

export type ToWorker =
  | { kind: "engine"; module: WebAssembly.Module }
  | ({ kind: "simulate" } & VariantsRequest)
  | { kind: "cancel"; generation: number };

/** Variants `first … first + count − 1`. */
export interface Chunk {
  generation: number;
  first: number;
  count: number;
  /** Final x and y of the struck ball, m; NaN for failed variants. */
  ends: Float64Array;
  /** count × balls: the pocket's index or a code, as in `Batch.pocket`. */
  pockets: Int8Array;
  /** Errors of failed variants, by their index in the chunk. */
  refusals: ReadonlyMap<number, Refusal>;
}

export type FromWorker =
  | ({ kind: "chunk" } & Chunk)
  /** Paths of the struck ball: x, y, z (m) per point. */
  | { kind: "paths"; generation: number; paths: Float32Array[] }
  | { kind: "refused"; generation: number; refusal: Refusal };
