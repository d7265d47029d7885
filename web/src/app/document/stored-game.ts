/** A game as the document stores it: its set-up and its moves. Its state is computed from these. */

import type {
  Call,
  Choice,
  FrameOfTerms,
  FrameOptions,
  Play,
  Seat,
  ShotFile,
  Strike,
} from "../../engine/index.ts";

/** One value per player; the player who breaks is first. */
export type Pair<T> = readonly [T, T];

/** Longest name of a player, in characters: the score has no room for more. */
export const LONGEST_NAME = 20;

/**
 * What is shown of an aimed shot: nothing, the aim line with the directions after the first contact, or
 * the whole shot.
 */
export type Guide = "none" | "short" | "full";

export const GUIDES: readonly Guide[] = ["none", "short", "full"];

/** The seed of a rack as a number, for what is drawn in the page; of 16 hexadecimal digits the last 12. */
export function seedOf({ seed = 0 }: Pick<FrameOptions, "seed">): number {
  return typeof seed === "number" ? seed : Number.parseInt(seed.slice(4), 16);
}

/** A match of several frames. */
export interface Race {
  /** Frames that win the race. */
  readonly to: number;
  /** Who breaks the next frame. */
  readonly breaks: "alternate" | "winner";
  /** Frames that each player has won before this one. */
  readonly won: Pair<number>;
  /** Whether the players have changed places since the first frame: the first of a pair breaks. */
  readonly turned: boolean;
}

export interface Setup {
  /** One of the engine's rule sets. */
  readonly rules: string;
  readonly options: FrameOptions & FrameOfTerms;
  /** The shot whose balls, table and physics the game starts from; null: a new rack. */
  readonly from: ShotFile | null;
  readonly names: Pair<string>;
  /** Each person's preset of execution noise; null: no errors. */
  readonly skills: Pair<string | null>;
  /** The level of each machine, such as "level-3"; null: a person. Left out: two persons. */
  readonly machines?: Pair<string | null>;
  /** Left out: short. */
  readonly guide?: Guide;
  /** Left out: a single frame. */
  readonly race?: Race;
  /** Time for a shot of a person, s. Left out: no limit. */
  readonly clock?: number;
}

export type Move =
  { readonly play: Play } | { readonly choice: Choice } | { readonly concede: true };

/**
 * Trees of shots as text, by the index of a move: what could have been played from the position before it.
 * The first shot of a tree is the move itself, for its comment.
 */
export type Variations = Readonly<Record<number, string>>;

/** What the record of a match has of a move beside the game. */
export interface MoveNote {
  readonly seat: Seat;
  /** Index of the move in the game. Left out: the move did not change the game. */
  readonly index?: number;
  /** The intended shot; the game has the executed one. */
  readonly play?: Play & { readonly strike: Strike };
  /** The probability with which the player expected to win. */
  readonly chance?: number;
  /** Chances of the player: before the shot, expected after the intended one, and after it. */
  readonly luck?: readonly [number, number, number];
  /** Why the answer was refused. */
  readonly refused?: string;
  /** Why the player gave no answer, which lost the frame. */
  readonly lost?: string;
}

/** What the record of a match has beside the game of a frame. */
export interface MatchNotes {
  /** The number of the frame in the match, from 0. */
  readonly frame: number;
  readonly moves: readonly MoveNote[];
  /** How the frame ended; why in words. Left out: it goes on. */
  readonly end?: { readonly reason: string; readonly why: string };
}

/** Immutable. Games that share the `moves` object are at the same point of the same frame. */
export interface Game {
  readonly setup: Setup;
  readonly moves: readonly Move[];
  /** The call for the shot that is being aimed; it may be incomplete. */
  readonly call: Call | null;
  /** The player at this page, if the other one is a friend who gets links. Left out: both are here. */
  readonly here?: Seat;
  /** Which players have used the extension of the shot clock. Left out: none. */
  readonly extended?: Pair<boolean>;
  /** Variations of shots, by the index of the move. Left out: none. */
  readonly variations?: Variations;
  /** Left out: the game is not a frame of a match. */
  readonly notes?: MatchNotes;
}

/** The level of the machine that plays for `player`; null if a person does. */
export function machineOf({ machines }: Setup, player: Seat): string | null {
  return machines?.[player] ?? null;
}

/** What is shown of an aimed shot: in free play the whole shot. */
export function guideOf(game: Game | null): Guide {
  return game ? (game.setup.guide ?? "short") : "full";
}

/** A game without moves. */
export function newGame(setup: Setup, here?: Seat): Game {
  return { setup, moves: [], call: null, ...(here !== undefined && { here }) };
}
