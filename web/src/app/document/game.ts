/** A game as the document stores it: its set-up and its moves. Its state is computed from these. */

import type { Call, Choice, FrameOptions, Play, ShotFile } from "../../engine/index.ts";

/** One value per player; the player who breaks is first. */
export type Pair<T> = readonly [T, T];

/** Longest name of a player, in characters: the score has no room for more. */
export const LONGEST_NAME = 20;

export interface Setup {
  /** One of the engine's rule sets. */
  readonly rules: string;
  readonly options: FrameOptions;
  /** The shot whose balls, table and physics the game starts from; null: a new rack. */
  readonly from: ShotFile | null;
  readonly names: Pair<string>;
  /** Each player's preset of execution noise; null: no errors. */
  readonly skills: Pair<string | null>;
}

export type Move =
  { readonly play: Play } | { readonly choice: Choice } | { readonly concede: true };

/** Immutable. Games that share the `moves` object are at the same point of the same frame. */
export interface Game {
  readonly setup: Setup;
  readonly moves: readonly Move[];
  /** The call for the shot that is being aimed; it may be incomplete. */
  readonly call: Call | null;
}

/** A game without moves. */
export function newGame(setup: Setup): Game {
  return { setup, moves: [], call: null };
}
