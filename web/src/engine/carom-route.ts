/** Routes of caroms, and readings of diamond systems. */

import type { Point, RailName } from "./places.ts";

export type SystemName = "corner-five" | "plus" | "two-to-one";

/** A number at a diamond, m. */
export interface DiamondNumber {
  readonly at: Point;
  readonly number: number;
  /** Numbers of a target are another scale than those of the lines. */
  readonly scale: "line" | "target";
}

/** What a diamond system says of the way of a ball. */
export interface DiamondReading {
  readonly system: SystemName;
  /** Numbers where the first line crosses the lines of sights, to a tenth. */
  readonly from: number;
  readonly over: number;
  /** Where the ball arrives by the system, and by the engine; null if it falls or stops before. */
  readonly predicted: number;
  readonly actual: number | null;
  /** The diamonds with their numbers. */
  readonly numbers: readonly DiamondNumber[];
  /** Places of `from`, `over`, `predicted` and `actual` on the lines of sights, m. */
  readonly places: {
    readonly from: Point;
    readonly over: Point;
    readonly predicted: Point;
    readonly actual: Point | null;
  };
}

/** The order of the rails of a carom. */
export type CaromFigure =
  | "direct"
  | "one-cushion"
  | "two-cushions"
  | "around-the-table"
  | "double-the-rail"
  | "across-the-table"
  | "across-then-corner"
  | "corner-then-across"
  | "ticky"
  | "cushion-first"
  | "umbrella"
  | "cushions-first"
  | "same-rail";

/** The route of a cue ball to its second object ball. */
export interface CaromRoute {
  readonly pattern: CaromFigure;
  /** The first and the second object ball. */
  readonly first: string;
  readonly second: string;
  /** The cushions up to the second ball in order: their kinds, and their rails. */
  readonly cushions: readonly ("long" | "short")[];
  readonly rails: readonly RailName[];
  /** Number of those before the first ball. */
  readonly cushions_first: number;
  /** How much of each ball the cue ball covers, 1 (full) to 0; null in a contact of several balls. */
  readonly fullness: readonly [number | null, number | null];
  /** How the sidespin acts at the first cushion; `none` below half a tip. */
  readonly side: "none" | "running" | "reverse";
  /** The system with which a player would reckon the way; null if none fits. */
  readonly system: DiamondReading | null;
}
