/**
 * Games with a referee. Player 0 breaks or starts; player 1 is the opponent. Balls are named by their ids, pockets
 * by their names. The data is that of Python's `Frame.to_dict`, key by key.
 */

import type {
  Noise,
  PocketName,
  Point,
  Shot,
  ShotFile,
  Strike,
  StrikeEntry,
  StrikeInput,
  Trace,
  VaryOptions,
} from "./types.ts";

/** A player of a frame, by number. */
export type Seat = 0 | 1;

/** A player's call before a shot; a shot without a call leaves it out. */
export interface Call {
  readonly kind: "pocket" | "on" | "safety" | "push-out";
  /** The ball that is called into a pocket, or nominated as the ball on. */
  readonly ball?: string;
  /** The pocket that is called. */
  readonly into?: PocketName;
}

/** A shot as a player plays it. */
export interface Play {
  /** Without an elevation it is the default one. The policies are those of a shot file. */
  readonly strike: StrikeInput & Pick<StrikeEntry, "obstruction" | "miscue">;
  /** Place of a cue ball in hand, m. */
  readonly cue_ball?: Point;
  readonly call?: Call;
  /** The contacts that cling, such as those of a drawn variant (`Shot.variant`). Default: none. */
  readonly cling?: NonNullable<ShotFile["cling"]>;
}

/** A play with all numbers of its strike; `Frame.play` takes it. */
export type PlannedPlay = Play & { readonly strike: Strike };

/** Region in which a cue ball in hand may be placed. */
export type Region = "anywhere" | "behind-head-string" | "the-d";

/** A decision that the referee offers. */
export type Choice =
  | "play-on"
  | "play-from-hand"
  | "pass-back"
  | "rebreak"
  | "rebreak-by-other"
  | "spot-eight"
  | "replace"
  | "spot-frozen"
  | "spot-nearest"
  | "play-from-anywhere";

/** The referee asks for a shot. */
export interface ShotRequest {
  readonly kind: "shot";
  readonly player: Seat;
  readonly cue_ball: string;
  /** Null if the cue ball is played from where it lies. */
  readonly in_hand: Region | null;
  /** Balls on, of which one must be hit first; empty if any ball may be hit first. */
  readonly on: readonly string[];
  /** Calls that are allowed; a call is required if "nothing" is not among them. */
  readonly calls: readonly ("nothing" | Call["kind"])[];
}

/** The referee asks for a decision. */
export interface ChoiceRequest {
  readonly kind: "choice";
  readonly player: Seat;
  readonly choices: readonly Choice[];
  /** The reason, as text. */
  readonly why: string;
}

/** The end of the frame. */
export interface OverRequest {
  readonly kind: "over";
  /** Null if the frame ends without a winner. */
  readonly winner: Seat | null;
  /** The reason, as text. */
  readonly why: string;
}

/** What the frame waits for. */
export type Request = ShotRequest | ChoiceRequest | OverRequest;

/** The complete state of a frame. */
export interface FrameState {
  readonly game: string;
  readonly request: Request;
  readonly scores: readonly [number, number];
  readonly fouls_in_a_row: readonly [number, number];
  readonly shots: number;
  /** Positions of the balls on the table, m. */
  readonly balls: Readonly<Record<string, Point>>;
  /** The state that is specific to the game. */
  readonly state: {
    /** Eight-ball, Chinese eight-ball: each player's group; null while the table is open. */
    readonly groups?: readonly ["solids" | "stripes" | null, "solids" | "stripes" | null];
    /** Snooker: the ball on, whether there is a free ball, and the points of the present break. */
    readonly on?: "red" | "color" | "sequence";
    readonly free_ball?: boolean;
    readonly break?: number;
    /** Snooker: the most points that the balls on the table can score. */
    readonly points_left?: number;
    /** Six-red snooker: fouls and misses in a row of the same player. */
    readonly misses?: number;
    /** Carom games: innings of each player. */
    readonly innings?: readonly [number, number];
  };
}

/** The referee's ruling after a shot or a choice. */
/** What a referee counts in a game without pockets. */
export interface CaromCount {
  /** Object balls that the cue ball touched: 2 for two and more. */
  readonly balls: number;
  /** Cushions that it touched before the second of them, or in the whole shot if it touched fewer than two. */
  readonly cushions: number;
  /** Cushions that the shot needs. */
  readonly needed: number;
  /** Whether the balls stayed in a corner's zone, so that the carom does not count. */
  readonly stayed: boolean;
}

export interface Ruling {
  readonly legal: boolean;
  /** `what` is the foul as text; `rule` its number in the rule book, or empty. */
  readonly fouls: readonly { readonly what: string; readonly rule: string }[];
  /** Change of each player's score. */
  readonly points: readonly [number, number];
  /** Balls that were spotted. */
  readonly spotted: readonly string[];
  /** Whether the balls were racked again. */
  readonly racked: boolean;
  /** Only for shots of games without pockets. */
  readonly carom?: CaromCount;
}

/** The facts of a game. */
export interface GameFacts {
  readonly name: string;
  /** The table on which it is played by default. */
  readonly table: string;
  /** Number of players: 1 or 2. */
  readonly players: number;
  /** Number of balls, with the cue balls. */
  readonly balls: number;
  /** Whether each player has a cue ball of its own: the first two balls. */
  readonly own_cue_balls: boolean;
  /** What the players try to do with the object balls. */
  readonly objective: "any-ball" | "lowest-first" | "groups" | "reds-and-colors" | "caroms";
  /** The number of the ball that decides the game, if a single ball does. */
  readonly deciding_ball: number | null;
  /** How the winner is found: by the last ball, by the points at the end, or by a number of points. */
  readonly scoring: "last-ball" | "points" | "target";
  /** The usual number of points that win; null without such a number. */
  readonly usual_points: number | null;
  /** The largest break without fouls, where the points at the end decide. */
  readonly maximum: number | null;
  /** What the opening shot is for. */
  readonly opening: "break" | "safety" | "carom";
  /** Whether the players lag for the break. */
  readonly lag: boolean;
  /** Whether a foul may also be a miss. */
  readonly miss: boolean;
}

/** Terms that the players agree on before a frame. `Engine.defaultTerms` has the defaults. */
export interface FrameTerms {
  /** Points that win straight pool and the games of carom. */
  readonly points?: number;
  /** @deprecated Old name of `points`. */
  readonly target?: number;
  /** Whether a foul and a miss is called in snooker. */
  readonly miss?: boolean;
  /** Number of consecutive shots without progress that make a stalemate. */
  readonly patience?: number;
}

export interface FrameOfTerms extends FrameTerms {
  /**
   * The player who shoots next. Default: in games in which each player has a cue ball, the player whose
   * cue ball the shot strikes; otherwise player 0.
   */
  readonly player?: 0 | 1;
}

export interface FrameOptions extends FrameTerms {
  /** As in a shot file; default: the game's own. */
  readonly table?: string | Readonly<Record<string, unknown>>;
  /** As in a shot file; default: the table's own. */
  readonly physics?: string | Readonly<Record<string, unknown>>;
  /**
   * Seed of the rack, a whole number; or 16 hexadecimal digits, as records of matches have it, because a
   * number does not hold 64 bits. Default 0.
   */
  readonly seed?: number | string;
}

/** A move of a record: a play with all numbers of its strike, a choice, or a concession. */
export type FrameMove =
  | {
      readonly play: PlannedPlay;
      /** What the page's analysis has of the shot: a text `tree/1`. A frame does not keep it. */
      readonly variations?: string;
    }
  | { readonly choice: Choice }
  | { readonly concede: true };

/** How a recorded frame starts: from its racks, or from the balls of a shot. */
export type FrameSetup = FrameTerms & { readonly game: string } & (
    | {
        readonly table: ShotFile["table"];
        readonly physics?: NonNullable<ShotFile["physics"]>;
        readonly seed: number | string;
      }
    | {
        readonly shot: ShotFile;
        /** The player who shoots first; 0 if absent. */
        readonly player?: 0 | 1;
      }
  );

/** A frame as plain values. Presets have dated names, so a record keeps its bits. */
export interface FrameRecord {
  readonly format: "carom-frame/1";
  /** Name and version of the engine that made it; records of early versions do not have it. */
  readonly engine?: string;
  readonly setup: FrameSetup;
  readonly moves: readonly FrameMove[];
}

/** The errors with which a player executes a play. */
export interface PlayErrors {
  /** Default: the play is played as it is given. */
  readonly noise?: Noise;
  /**
   * Seed of the errors, a whole number; or a seed for each player, as in a match. Default 0.
   */
  readonly seed?: number | readonly [number, number];
}

/** Variants of a play, each ruled on. Arrays have an entry for each variant, `cue_ball` two. */
export interface Successors {
  /** The player who is asked next; −1 if the frame is over. */
  readonly player: Int8Array;
  /** The winner; −1 if there is none. */
  readonly winner: Int8Array;
  /** 1 for a shot without a foul, else 0. */
  readonly legal: Uint8Array;
  /** Where the cue ball lies (x, y in m); NaN if it is not on the table. */
  readonly cue_ball: Float64Array;
}

/**
 * A frame between two players. Its state has a request, which a player answers with `play` or `choose`,
 * until the frame is over.
 */
export interface Frame {
  /** The present state. */
  readonly state: FrameState;
  /**
   * The box around the region in which the cue ball may be placed (for the D, around the half disk):
   * lower left and upper right corner, m. Null unless the cue ball is in hand.
   */
  readonly handBounds: readonly [Point, Point] | null;
  /**
   * The frame as text, from which a person or a language model can play: the score, the table, the balls, and
   * what the request allows.
   */
  describe(): string;
  /**
   * The JSON Schema of an answer to the present request: `{"play": …}`, `{"choice": …}` or `{"concede": true}`,
   * the form of a move in `record`.
   */
  answerSchema(): Readonly<Record<string, unknown>>;
  /** The shot that `play` would play. @throws CaromError as `play`. */
  shot(play: Play): Shot;
  /**
   * Plays a shot: simulates it and rules on it. The frame then has a new request. With a noise the player
   * errs: strike and cling are those of variant k of the seed (`Shot.variant`), where k is the number of
   * shots played so far; with a seed for each player, of the player's own shots. `record` has the strike that was played, and the contacts that cling.
   * @throws CaromError if the request is not for a shot, if a call is missing or not allowed, if the cue
   * ball may not be placed there, and if the strike cannot be played. The frame is then unchanged.
   */
  play(play: Play, errors?: PlayErrors): { readonly ruling: Ruling; readonly trace: Trace };
  /** Makes a choice. @throws CaromError unless the request offers it. */
  choose(choice: Choice): Ruling;
  /** The player at the table concedes. @throws CaromError if the frame is over. */
  concede(): Ruling;
  /**
   * The start of the frame and all its moves, as plain values that JSON can hold. `Engine.replay` restores
   * the frame.
   */
  readonly record: FrameRecord;
  /**
   * Sixteen hexadecimal digits over everything that decides how the frame goes on: game and options, table,
   * physics and policies, the exact bits of the balls' places, the request, scores and fouls, all that the
   * rules keep, and the seed of the racks to come. The same version of the engine gives the same value in
   * Rust, Python and JavaScript on every platform, so two programs that play one game can compare it.
   */
  readonly hash: string;
  /**
   * What may follow a play with execution noise: the variants `first … first + n − 1`, as in `Shot.vary`,
   * each ruled on. The frame is not changed.
   * @throws CaromError as `play`.
   */
  successors(play: Play, noise: Noise, n: number, options?: VaryOptions): Successors;
  /** An independent copy, for instance to try a shot. */
  copy(): Frame;
  /** Frees the memory at once instead of at garbage collection. The object is unusable afterwards. */
  free(): void;
}
