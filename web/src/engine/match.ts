/** Records of matches between programs, `carom-match/1`; docs/arena.md lists every key. */

import type { Call, FrameRecord, Seat } from "./rules.ts";
import type { Noise, PocketName, Point, Strike } from "./types.ts";

/** The settings of a match, with the keys that a viewer needs. */
export interface MatchHeader {
  readonly engine: string;
  readonly players: readonly [{ readonly name: string }, { readonly name: string }];
  readonly game: string;
  readonly noise: readonly [Noise, Noise];
  /** The number of pairs; with a test the largest number. */
  readonly pairs: number;
}

/** How a frame ended. */
export interface MatchFrameEnd {
  /** A player of the match, not a seat; null without one. */
  readonly winner: 0 | 1 | null;
  /** The points of the players; null if the frame does not count. */
  readonly points: readonly [number, number] | null;
  readonly reason: string;
  /** The reason in words. */
  readonly why: string;
}

/** A frame of a match without its moves. */
export interface MatchFrame {
  readonly frame: number;
  /** The player at each seat. */
  readonly seats: readonly [0 | 1, 0 | 1];
  /** Number of executed shots. */
  readonly shots: number;
  readonly scores: readonly [number, number];
  readonly end: MatchFrameEnd | null;
}

/** A move of a match, as it is written. */
export interface MatchMove {
  readonly seat: Seat;
  /** Index of the move in the game; undefined if it did not change the game. */
  readonly index?: number;
  /** The intended shot. */
  readonly play?: {
    readonly strike: Strike;
    readonly cue_ball?: Point;
    readonly call?: Omit<Call, "into"> & { readonly pocket?: PocketName };
  };
  readonly executed?: { readonly strike: Strike; readonly cue_ball?: Point };
  /** The hash of the shot's trace. */
  readonly trace?: string;
  /** The probability with which the player expected to win. */
  readonly win_chance?: number;
  /** Chances of the seat: before the shot, expected after the intended one, and after it. */
  readonly luck?: { readonly before: number; readonly expected: number; readonly after: number };
  readonly cost?: { readonly simulations: number; readonly seconds?: number };
  readonly refused?: { readonly place: string; readonly what: string; readonly remedy: string };
  readonly late?: true;
  readonly failed?: { readonly reason: string; readonly why: string };
}

/** A frame of a match as a game. */
export interface MatchGame {
  /** The executed shots, the choices and the concession. */
  readonly record: FrameRecord;
  /** All moves of the match, with intentions, chances and refused answers. */
  readonly moves: readonly MatchMove[];
}

/** The record of a match. */
export interface MatchRecord {
  readonly header: MatchHeader;
  /** Whether the match has ended. */
  readonly isFinished: boolean;
  readonly frames: readonly MatchFrame[];
  /** A frame as a game. @throws CaromError if there is no such frame, or a value of it is damaged. */
  game(frame: number): MatchGame;
  /** Frees the memory at once instead of at garbage collection. The object is unusable afterwards. */
  free(): void;
}
