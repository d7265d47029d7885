/** Drill files and puzzles. The data is that of Python, key by key. */

import type { Goal, GoalArea } from "./goal.ts";
import type { BallEntry, ShotFile, Strike } from "./types.ts";

export type * from "./goal.ts";

/** A drill file. */
export interface DrillFile {
  readonly format: "carom-drill/1";
  readonly name: string;
  readonly text?: string;
  readonly table: string;
  /** Id of the cue ball. Default `cue`. */
  readonly cue?: string;
  readonly attempts: number;
  /** After this number of misses the drill ends early. */
  readonly misses?: number;
  readonly order?: "same" | "ladder" | "turns";
  readonly steps: readonly {
    readonly balls: readonly BallEntry[];
    readonly hand?: GoalArea;
    /** Speed of the cue with which the aim begins, m/s. */
    readonly speed?: number;
    readonly goal: Goal;
  }[];
}

/** The chance of each level of play, by its name. */
export type LevelChances = Readonly<Record<string, number>>;

/** A puzzle. */
export interface Puzzle {
  /** Its theme and number, such as `cut-17`. */
  readonly id: string;
  readonly theme: string;
  /** Its difficulty on the scale of the levels' ratings. */
  readonly rating: number;
  /** The layout, with a strike at the first object ball. */
  readonly shot: ShotFile;
  readonly goal: Goal;
  /** Of each level with its best way. */
  readonly chances: LevelChances;
  /** Different ways to solve it; the first one is the best for a club player. */
  readonly ways: readonly { readonly strike: Strike; readonly chances: LevelChances }[];
}

/** A puzzle of the list. */
export type ListedPuzzle = readonly [id: string, rating: number];
