/** The interface of the engine that `load` returns. */

import type { DrillFile, GoalArea, GoalCondition, ListedPuzzle, Puzzle } from "./drill-goals.ts";
import type { CaromError } from "./error.ts";
import type { EvaluateOptions, Evaluation } from "./evaluation.ts";
import type { MatchRecord } from "./match.ts";
import type { StudyFile, TaskVerdict } from "./study.ts";
import type { Player, PlayerOptions } from "./player.ts";
import type {
  Frame,
  FrameOfTerms,
  FrameOptions,
  FrameRecord,
  FrameTerms,
  GameFacts,
} from "./rules.ts";
import type { Batch, Geometry, Noise, Point, Shot, ShotFile, Trace, TraceFile } from "./types.ts";

/** Options of `Engine.breakShot`. */
export interface BreakOptions {
  /** Table preset; default: the game's usual table. */
  readonly table?: string;
  /** Cue speed, m/s; default: the game's usual break. */
  readonly speed?: number;
  /** Seed of the rack (order of the balls, gaps), a whole number. Default 0. */
  readonly seed?: number;
  /** Mean gap between neighbouring balls, m; 0 to 0.005; default: the preset's, or 0.0001 (a triangle). */
  readonly gap?: number;
  /** How players open the game, such as "rail" in nine-ball; default: from the middle, without spin. */
  readonly preset?: string;
}

/** Options of `Engine.rollingBands`. */
export interface RollingOptions {
  /** Highest speed at which the law is followed, m/s; faster balls have the last band. Default 3. */
  readonly fastest?: number;
  /** Largest error of the place where a ball stops, as a share of the roll's length. Default 0.005. */
  readonly share?: number;
  /** An error that is always allowed, m; the larger of the two counts. Default 0.005. */
  readonly least?: number;
  /** m/s². Default 9.80665, as in the presets except `poolfiz`. */
  readonly gravity?: number;
}

/** A speed band of rolling friction. */
export interface RollingBand {
  /** Highest speed of the band, m/s; the last band has none. */
  readonly up_to?: number;
  /** Coefficient of rolling friction in the band. */
  readonly friction: number;
}

/** The engine. */
export interface Engine {
  /** The compiled module; a worker that receives it calls its own `load` with it. */
  readonly module: WebAssembly.Module;
  /** Name and version, `carom x.y.z`, as under `engine` in a trace file. */
  readonly version: string;
  /** One tip, the unit in which players count English, follow and draw, in ball radii. */
  readonly tip: number;
  /** The names of the games. */
  readonly games: readonly string[];
  /** The facts of every game, by its name. */
  readonly gameFacts: Readonly<Record<string, GameFacts>>;
  /** The terms of a frame that has no others: points, miss and patience. */
  readonly defaultTerms: Required<Omit<FrameTerms, "target">>;
  /** Table presets: the newest ones, then older editions. */
  readonly tables: readonly Geometry[];
  /**
   * The current name of the preset `name`, of a table or of physics: without a date if its values are the
   * newest. Records have dated names. A name that no preset has is returned as it is.
   */
  currentPresetName(name: string): string;
  /**
   * A shot file, or a frame's table and physics, with the dated names of presets, for a record: `pool`
   * will have other values one day.
   */
  withDatedNames<T extends Pick<ShotFile, "table" | "physics">>(file: T): T;
  /** Physics presets by current name: every parameter, as in a shot file. */
  readonly physics: Readonly<Record<string, Readonly<Record<string, unknown>>>>;
  /**
   * Speed bands that follow a measured deceleration of rolling balls, a + bv (a in m/s², b in 1/s): a
   * value of `physics.cloth.rolling_friction`. A number if one band is enough.
   * @throws CaromError if a value is out of range, or if the law needs more than 16 bands.
   */
  rollingBands(a: number, b: number, options?: RollingOptions): number | readonly RollingBand[];
  /** Reads a shot file. @throws CaromError that names the place, the fault and the remedy. */
  shot(file: string | ShotFile): Shot;
  /** Reads a saved trace. @throws CaromError as `shot`. */
  trace(file: string | TraceFile): Trace;
  /**
   * The trace so far of a shot that reached its cap of events, from the error that it raised; its `end` is
   * "cap". The shot is simulated again.
   * @throws CaromError for another error.
   */
  traceToCap(error: CaromError): Trace;
  /** The break of a game. @throws CaromError for an unknown name or an option out of range. */
  breakShot(game: string, options?: BreakOptions): Shot;
  /** The puzzles that were found good, with their ratings, theme by theme. */
  readonly puzzles: readonly ListedPuzzle[];
  /** Makes the puzzle of an id: a few tenths of a second. @throws CaromError if there is none. */
  puzzle(id: string): Puzzle;
  /** Reads a drill file, and returns it with its defaults. @throws CaromError as `shot`. */
  drill(file: string | DrillFile): DrillFile;
  /** How far (m) a place is outside an area of a table's preset; 0 inside. */
  areaDistance(area: GoalArea, table: string, at: Point): number;
  /** Simulates all shots, without traces. */
  simulate(shots: readonly Shot[]): Batch;
  /** The Computational Olympiad's noise times `multiplier`; its tournaments used 0.5, 1 and 2. */
  olympiad(multiplier?: number): Noise;
  /**
   * Presets of execution noise by name: levels of play from "beginner" to "professional" (estimated),
   * then "olympiad" (published).
   */
  readonly noisePresets: Readonly<Record<string, Noise>>;
  /**
   * Checks that a noise has every σ, each within its range.
   * @throws CaromError that names the σ.
   */
  checkNoise(noise: Noise): void;
  /** The same list as `games`. */
  readonly ruleSets: readonly string[];
  /** The table on which a game is played by default. @throws CaromError for an unknown game. */
  usualTable(game: string): string;
  /** Racks a frame of one of the `games`. @throws CaromError for an invalid option. */
  frame(game: string, options?: FrameOptions): Frame;
  /**
   * A frame that starts from the balls of a shot, on its table. The cue ball is played from where it lies;
   * balls that the shot does not have count as pocketed.
   * @throws CaromError if the game does not have these balls, or would be over with them.
   */
  frameOf(game: string, shot: Shot, terms?: FrameOfTerms): Frame;
  /**
   * Checks the keys of a record and the types of its parts, without playing it.
   * @throws CaromError that names the place.
   */
  checkRecord(record: FrameRecord): void;
  /**
   * The frame of a record, with every move repeated. The same version of the engine gives the same frame,
   * to the bit; with another version a shot may end differently, and a later move may then be refused.
   * @throws CaromError if this is not a record, or a move is not allowed; the message has the move's index.
   */
  replay(record: FrameRecord): Frame;
  /**
   * Reads the record of a match, the text of `match.jsonl` or of the `played.jsonl` of one that goes on,
   * without playing it.
   * @throws CaromError with the line and the key of a damaged value.
   */
  matchRecord(record: string): MatchRecord;
  /**
   * Reads a study, the text of a `carom-study/1`. Nothing in it is simulated.
   * @throws CaromError with the chapter and the place in it.
   */
  study(json: string): StudyFile;
  /**
   * How a shot stands to the goal of a task.
   * @throws CaromError for a condition that is unknown, or names no ball or pocket of the shot.
   */
  judge(trace: Trace, goal: readonly GoalCondition[]): TaskVerdict;
  /**
   * The chances of all results if a player who errs intends the strike of a shot, as `Shot.evaluate` of Python.
   * With a `posterior` they include what is not known about the table. 10 000 variants take some tenths
   * of a second or more: call it in a worker.
   * @param n Largest number of variants. Default 10 000.
   * @throws CaromError without a strike, for a number out of range, for an unknown ball or pocket to watch,
   * for a frame that requests another shot, and for a posterior that has too few tables, or on most of whose
   * tables balls have no room.
   */
  evaluate(shot: Shot, noise: Noise, n?: number, options?: EvaluateOptions): Evaluation;
  /** Names of the built-in players. */
  readonly players: readonly string[];
  /** A player that chooses shots and explains them. @throws CaromError for an invalid option. */
  player(options?: PlayerOptions): Player;
  /** The JSON Schema of a file format. */
  schema(kind: "shot" | "trace" | "study"): object;
}
