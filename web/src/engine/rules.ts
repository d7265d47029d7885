/**
 * What a game with a referee takes and gives. Players are 0 (who begins) and 1; balls are named by
 * their ids, pockets by their names. The JSON is that of Python's `Frame.to_dict`.
 */

import type { PocketName, Point, Shot, Strike, Trace } from "./types.js";

export type Player = 0 | 1;

/** What a player announces before a shot; no call at all is left out. */
export interface Call {
  readonly kind: "pocket" | "on" | "safety" | "push-out";
  /** The ball that is called into a pocket, or nominated as the ball on. */
  readonly ball?: string;
  /** The pocket that is called. */
  readonly into?: PocketName;
}

/** A shot as a player plays it. */
export interface Play {
  readonly strike: Strike;
  /** Where the cue ball is put first, m, if it is in hand. */
  readonly cue_ball?: Point;
  readonly call?: Call;
}

/** Where a cue ball in hand may be put. */
export type Region = "anywhere" | "behind-head-string" | "the-d";

export type Choice =
  | "play-on"
  | "play-from-hand"
  | "pass-back"
  | "rebreak"
  | "rebreak-by-other"
  | "spot-eight"
  | "replace"
  | "spot-frozen"
  | "spot-nearest";

/** The shot that is asked. */
export interface ShotRequest {
  readonly kind: "shot";
  readonly player: Player;
  readonly cue_ball: string;
  /** Null where the cue ball is played from where it lies. */
  readonly in_hand: Region | null;
  /** Balls of which one must be hit first; none where any may be. */
  readonly on: readonly string[];
  /** What may be announced; without "nothing", something must be. */
  readonly calls: readonly ("nothing" | Call["kind"])[];
}

/** A decision that is asked. */
export interface ChoiceRequest {
  readonly kind: "choice";
  readonly player: Player;
  readonly choices: readonly Choice[];
  /** In words. */
  readonly why: string;
}

/** The end of the frame. */
export interface OverRequest {
  readonly kind: "over";
  /** Null where it ends undecided. */
  readonly winner: Player | null;
  /** In words. */
  readonly why: string;
}

export type Request = ShotRequest | ChoiceRequest | OverRequest;

/** Everything there is to know of a frame. */
export interface FrameState {
  readonly game: string;
  readonly request: Request;
  readonly scores: readonly [number, number];
  readonly fouls_in_a_row: readonly [number, number];
  readonly shots: number;
  /** Where the balls on the table lie, m. */
  readonly balls: Readonly<Record<string, Point>>;
  /** What this game has and others have not. */
  readonly state: {
    /** Eight-ball: each player's group; null while the table is open. */
    readonly groups?: readonly ["solids" | "stripes" | null, "solids" | "stripes" | null];
    /** Snooker: what is on, whether there is a free ball, points of the present break. */
    readonly on?: "red" | "color" | "sequence";
    readonly free_ball?: boolean;
    readonly break?: number;
    /** Snooker: the most that the balls on the table are worth. */
    readonly points_left?: number;
    /** Three-cushion: innings of each player. */
    readonly innings?: readonly [number, number];
  };
}

/** What the referee says after a shot or a choice. */
export interface Ruling {
  readonly legal: boolean;
  /** `what` in words; `rule` its number in the rule book, or empty. */
  readonly fouls: readonly { readonly what: string; readonly rule: string }[];
  /** What each player's score changed by. */
  readonly points: readonly [number, number];
  /** Balls that were put on a spot. */
  readonly spotted: readonly string[];
  /** Whether the balls were racked again. */
  readonly racked: boolean;
}

/** What players can agree on before a frame. */
export interface FrameTerms {
  /** Points that win straight pool and three-cushion. Default 40. */
  readonly target?: number;
  /** Whether a foul and a miss is called in snooker. Default true. */
  readonly miss?: boolean;
  /** Shots in a row without progress that make a stalemate. Default 100. */
  readonly patience?: number;
}

export interface FrameOptions extends FrameTerms {
  /** As in a shot file; default: the game's own. */
  readonly table?: string | Readonly<Record<string, unknown>>;
  /** As in a shot file; default: the table's own. */
  readonly physics?: string | Readonly<Record<string, unknown>>;
  /** Which of the random racks. Default 0. */
  readonly seed?: number;
}

/**
 * One rack, frame or match between two players: it asks, and a player answers with `play` or `choose`,
 * until it is over.
 */
export interface Frame {
  /** As it stands. */
  readonly state: FrameState;
  /**
   * The box around the region in which the cue ball may be put (for the D, around the half disk): least
   * and largest corner, m. Null where the cue ball is not in hand.
   */
  readonly handBounds: readonly [Point, Point] | null;
  /** The shot that `play` would play. @throws CaromError as `play`. */
  shot(play: Play): Shot;
  /**
   * Plays a shot: it is simulated and ruled on, and the frame asks anew.
   * @throws CaromError if no shot is asked, for a call that is missing or not to be made, for a cue
   * ball put where it must not be, and for a strike that cannot be played. Nothing has changed then.
   */
  play(play: Play): { readonly ruling: Ruling; readonly trace: Trace };
  /** Answers a choice. @throws CaromError if none is asked, or not this one. */
  choose(choice: Choice): Ruling;
  /** The player whose turn it is gives up, and the other wins. @throws CaromError if it is over. */
  concede(): Ruling;
  /** The same frame once more: to try a shot and go back. */
  copy(): Frame;
  /** Gives the memory back at once; else the garbage collector does. Nothing works afterwards. */
  free(): void;
}
