/** Players: programs that answer the requests of a frame. The data is that of Python's `Player`, key by key. */

import type { CaromRoute } from "./carom-route.ts";
import type { TableOptions } from "./drawn-tables.ts";
import type { Choice, Frame, PlannedPlay } from "./rules.ts";
import type { Noise, PocketName, Point } from "./types.ts";

/** Error of a position that a player sees. */
export interface PositionError {
  /** Standard deviation of true minus perceived position, m: of each coordinate, or of x and of y. */
  readonly position: number | readonly [x: number, y: number];
  /** Correlation of the two coordinates, −1 to 1. Default 0. */
  readonly correlation?: number;
}

/** Errors of the positions that a player sees. */
export interface Perception extends PositionError {
  /** Of single balls, by id, in place of that of all. */
  readonly balls?: Readonly<Record<string, PositionError>>;
}

/** What a player knows of the errors, and what a decision may cost. */
export interface PlayerOptions {
  /**
   * One of `Engine.players`, such as `level-3`. A number of simulated shots may follow, as in
   * `carom:2000`. Default: `carom`, the player that searches.
   */
  readonly name?: string;
  /** Errors of the player's strikes. Default: those of a level, and else the Olympiad's. */
  readonly noise?: Noise;
  /** Errors of the opponent's strikes. Default: those of the player. */
  readonly opponentNoise?: Noise;
  /** Default: the player sees the balls exactly. */
  readonly perception?: Perception;
  /**
   * Largest number of simulated shots of a decision, up to 10 million. Default: the number in the
   * name, else 20 000, or no other limit if `time` or `rounds` is given.
   */
  readonly simulations?: number;
  /** Largest number of rounds of a decision. */
  readonly rounds?: number;
  /**
   * Time of a decision, s. No round begins that would probably end later, but every decision has at
   * least one round.
   */
  readonly time?: number;
  /** Seed of the random numbers of a decision, a whole number. Default 0. */
  readonly seed?: number;
}

/** What a decision has cost. */
export interface Spent {
  /** Number of simulated shots. */
  readonly simulations: number;
  /** Number of rounds of the search. A player with this number as `rounds` decides the same. */
  readonly rounds: number;
  /** Whether `stop` ended the search. */
  readonly interrupted: boolean;
}

/** A player's answer to the request of a frame. */
export interface Decision extends Spent {
  /** The shot as the player intends it; null if the decision is a choice or a concession. */
  readonly play: PlannedPlay | null;
  /** One of the choices of the request; null if the decision is a shot or a concession. */
  readonly choice: Choice | null;
  /** Whether the player gives up the frame. */
  readonly concession: boolean;
  /** The probability with which the player expects to win the frame; null if it does not estimate it. */
  readonly win_chance: number | null;
}

/** A probability that is estimated by counting, with its interval, of 95 % unless a level is given. */
export interface Chance {
  readonly probability: number;
  readonly low: number;
  readonly high: number;
  /** With drawn tables: its standard deviation from one table to another, without that of counting. */
  readonly spread?: number;
}

/** One of the best plays, with chances that are counted with errors which took no part in the choice. */
export interface Recommendation {
  /** What the play does without errors. The first five pot a ball; an indirect one has no legs. */
  readonly kind:
    | "direct"
    | "bank"
    | "kick"
    | "combination"
    | "indirect"
    | "safety"
    | "carom"
    | "break"
    | "push-out";
  /** The ball that is to fall, and its pocket; null if none is. */
  readonly ball: string | null;
  readonly pocket: PocketName | null;
  /** The balls on the way to the pocket, the cue ball first, each with its number of cushions. */
  readonly legs: readonly (readonly [ball: string, cushions: number])[];
  /** The route of a carom; null for another play. The caroms of an analysis have one pattern each. */
  readonly route: CaromRoute | null;
  readonly play: PlannedPlay;
  /** The estimated probability that the player wins the frame, and its standard error from the samples. */
  readonly win_chance: number;
  readonly error: number;
  /** Number of samples of the chances. */
  readonly samples: number;
  /** The chance that the player has the turn again or has won. */
  readonly kept: Chance;
  readonly foul: Chance;
  /** `win_chance` over the samples in which the turn is kept, and over the others; null without such. */
  readonly win_if_kept: number | null;
  readonly win_if_missed: number | null;
  /**
   * Where the cue ball comes to rest: number of samples in which it stayed on the table, mean place (m),
   * covariance (m²), and root mean square distance from the mean (m). Null where there are too few samples.
   */
  readonly leave: {
    readonly count: number;
    readonly mean: Point | readonly [null, null];
    readonly covariance: readonly (readonly [number | null, number | null])[];
    readonly spread: number | null;
  };
}

/** The best plays of a position, the best first. */
export interface Analysis extends Spent {
  readonly plays: readonly Recommendation[];
}

export interface ExplainOptions extends TableOptions {
  /** Largest number of plays, 1 to 1000. Default 5. */
  readonly count?: number;
}

/** What a search has found so far. */
export interface Progress extends Omit<Spent, "interrupted"> {
  /** The best play so far; null if there is none yet. */
  readonly play: PlannedPlay | null;
  /**
   * The estimated probability of winning with it. It is somewhat too high, because the same samples chose
   * the play; the final result has samples of its own.
   */
  readonly win_chance: number | null;
}

/**
 * A search that pauses after every round: call `playRound` until it returns false, then `end`. Between two
 * rounds a worker can receive messages.
 */
export interface Thought<T> {
  /**
   * Plays the next round if the budget allows one. A player of the literature, and a choice, take one
   * round.
   * @returns Whether it was played.
   * @throws CaromError if a shot reaches its cap of events.
   */
  playRound(): boolean;
  readonly progress: Progress;
  /**
   * The result of the rounds so far. The thought cannot be used afterwards.
   * @param interrupted Whether the search was ended early; the result has this value.
   * @throws CaromError as `playRound`.
   */
  end(interrupted?: boolean): T;
  /** Frees the memory of a thought that is not ended. */
  free(): void;
}

/**
 * A player that chooses shots and explains them. It works on the calling thread: on a page use
 * `createThinker` (`carom-engine/thinker`), which has a worker.
 */
export interface Player {
  /** The name of the built-in player. */
  readonly name: string;
  /** The errors of the player's strikes. */
  readonly noise: Noise;
  /**
   * Answers the request of a frame, which is not changed. With a `posterior` a shot is the best one of
   * `explain`; a choice is made on the learned table alone.
   * @throws CaromError if the frame is over, if a shot reaches its cap of events, and if the table of the
   * frame is not that of the posterior.
   */
  choose(frame: Frame, options?: TableOptions): Decision;
  /**
   * The best plays of the shot for which the frame asks. With a `posterior` the best plays of the search,
   * eight or more, are ranked by their chances on tables that may be the true one, and those are stated.
   * @throws CaromError as `choose`, if the frame asks for a choice, and for a player of the literature.
   */
  explain(frame: Frame, options?: ExplainOptions): Analysis;
  /** Begins what `choose` does. @throws CaromError as `choose`. */
  beginChoice(frame: Frame, options?: TableOptions): Thought<Decision>;
  /** Begins what `explain` does. @throws CaromError as `explain`. */
  beginAnalysis(frame: Frame, options?: ExplainOptions): Thought<Analysis>;
  /** Frees the memory at once instead of at garbage collection. The object is unusable afterwards. */
  free(): void;
}
