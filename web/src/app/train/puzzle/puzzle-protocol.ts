/** The messages between the page and the worker that makes puzzles. */

import type { Puzzle } from "../../../engine/index.ts";

export interface ToMaker {
  readonly module: WebAssembly.Module;
  /** Such as `cut-17`. */
  readonly id: string;
}

export type FromMaker =
  | { readonly kind: "puzzle"; readonly puzzle: Puzzle }
  | { readonly kind: "failed"; readonly message: string };
