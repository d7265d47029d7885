/** A game as the document keeps it: how it began, and every move. All else follows from these. */

import type { Call, Choice, FrameOptions, Play, ShotFile } from "../../engine/index.ts";

/** Seats: who begins, and the other. */
export type Pair<T> = readonly [T, T];

/** Longest name of a player, in characters: the score has no room for more. */
export const LONGEST_NAME = 20;

export interface Setup {
  /** One of the engine's rule sets. */
  readonly rules: string;
  readonly options: FrameOptions;
  /** The balls, table and physics with which it goes on; null: the balls are racked. */
  readonly from: ShotFile | null;
  readonly names: Pair<string>;
  /** Whose errors each player makes: a preset of execution noise, or null for none. */
  readonly skills: Pair<string | null>;
}

export type Move =
  { readonly play: Play } | { readonly choice: Choice } | { readonly concede: true };

/** Immutable. Two games with the same `moves` object are at the same point of the same frame. */
export interface Game {
  readonly setup: Setup;
  readonly moves: readonly Move[];
  /** What is announced for the shot that is being aimed; perhaps not yet complete. */
  readonly call: Call | null;
}

/** A game that has not begun. */
export function newGame(setup: Setup): Game {
  return { setup, moves: [], call: null };
}
