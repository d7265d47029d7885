/**
 * What a drill is: data alone. Lengths and places are in diamonds: quarters of the table's width and eighths
 * of its length, from the bottom left corner, on tables without diamonds too.
 */

import type { ConditionOf, GoalOf, ZoneOf } from "../../../engine/goal.ts";
import type { PocketName } from "../../../engine/types.ts";

/** x from 0 to 4 across the table, y from 0 to 8 along it. */
export type Diamonds = readonly [x: number, y: number];

/** A place on the table. */
export type Place =
  | Diamonds
  /** A spot of the table's markings, such as "blue". */
  | { readonly spot: string }
  /** A ball that touches a long rail, `y` diamonds up the table. */
  | { readonly rail: "left" | "right"; readonly y: number }
  /**
   * A place from which `ball` is aimed at `pocket`: `back` diamonds behind the ghost ball, on a line turned
   * by `cut_deg` from the straight shot, counter-clockwise. A negative `back` is beyond the ghost ball.
   */
  | {
      readonly ball: string;
      readonly pocket: PocketName;
      readonly back: number;
      readonly cut_deg?: number;
    };

/** A part of the cloth; a ball is in it if its centre is. */
export type Area =
  | { readonly center: Place; readonly radius: number }
  | { readonly from: Diamonds; readonly to: Diamonds }
  | { readonly outline: readonly Diamonds[] }
  /** The D of a snooker table. */
  | { readonly marking: "d" };

/** What a shot must do. Every shot must also keep the cue ball on the table. */
export type Condition = ConditionOf<Area>;

/** Points for the place where the cue ball stops. */
export type Zone = ZoneOf<Area>;

/** An attempt of one shot: its points if it meets its conditions, or the points of the first zone. */
export type ShotGoal = Extract<GoalOf<Area>, { kind: "shot" }>;

/**
 * An attempt of several shots, until one fails or the last ball falls: a point for every ball. "eight": in
 * any order, but the last ball of the list must be met and fall last. "rotation": the first ball of the list
 * that is left must be met first; the last ball ends the run whenever it falls. "sequence": the first ball
 * that is left must fall, and no other.
 */
export type RunGoal = Extract<GoalOf<Area>, { kind: "run" }>;

/** A layout with its goal. */
export interface Step {
  /** Places by ball; none with a rack. */
  readonly balls: Readonly<Record<string, Place>>;
  /** The game whose rack is broken. */
  readonly rack?: "nine-ball";
  /** Where the cue ball may be placed before the first shot; by default it stays where it is. */
  readonly hand?: Area;
  readonly goal: ShotGoal | RunGoal;
}

export interface Drill {
  /** Its texts have the keys `drill.<id>` and `drill-goal.<id>`, unless it has a name of its own. */
  readonly id: string;
  /** Name and description of a drill that a user has made. */
  readonly name?: string;
  readonly text?: string;
  readonly table: string;
  /** Id of the cue ball. */
  readonly cue: string;
  readonly attempts: number;
  /** After this number of misses the drill ends early. */
  readonly misses?: number;
  /**
   * Which step the next attempt has. "ladder": the next one after success, the one before after a failure;
   * step k gives k points, unless its goal has points of its own. "turns": one step after another. A drill of one step has "same".
   */
  readonly order: "same" | "ladder" | "turns";
  readonly steps: readonly Step[];
  /** Speed of the cue with which the aim begins, m/s. */
  readonly speed: number;
}
