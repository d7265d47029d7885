/** The messages between the page and the worker that makes puzzles. */

import type { Puzzle } from "./daily-puzzle.ts";

export interface ToMaker {
  readonly module: WebAssembly.Module;
  /** "2026-11-23", UTC. */
  readonly date: string;
}

export type FromMaker =
  | { readonly kind: "puzzle"; readonly puzzle: Puzzle }
  | { readonly kind: "failed"; readonly message: string };
