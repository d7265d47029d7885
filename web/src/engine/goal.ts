/** Goals of a shot and verdicts on it. The data is that of Python, key by key. */

import type { PocketName, Point } from "./places.ts";

/** A part of the cloth; a ball is in it if its centre is. Places and lengths in m. */
export type GoalArea =
  | { readonly center: Point; readonly radius: number }
  | { readonly from: Point; readonly to: Point }
  /** The corners of a polygon. */
  | { readonly outline: readonly Point[] }
  /** The D of a snooker table. */
  | { readonly marking: "d" };

/** What a shot must do, with areas of a type `A`. */
export type ConditionOf<A> =
  /** The ball falls, into the pocket if one is given. */
  | { readonly kind: "pot"; readonly ball: string; readonly pocket?: PocketName }
  /** A ball falls that is not the cue ball. */
  | { readonly kind: "pot-any" }
  /** The cue ball meets this ball first. */
  | { readonly kind: "first"; readonly ball: string }
  /** The cue ball meets `cushions` cushions or more before a ball. */
  | { readonly kind: "kick"; readonly cushions: number }
  /** The ball meets the noses of `cushions` cushions or more. */
  | { readonly kind: "cushions"; readonly ball: string; readonly cushions: number }
  /** The cue ball meets two balls, the second after `cushions` cushions or more. */
  | { readonly kind: "carom"; readonly cushions: number }
  /** The cue ball meets all these balls. */
  | { readonly kind: "touch"; readonly balls: readonly string[] }
  /** The cue ball does not meet this ball. */
  | { readonly kind: "avoid"; readonly ball: string }
  /** The ball, by default the cue ball, stops in the area. */
  | { readonly kind: "stop"; readonly ball?: string; readonly area: A }
  /** At the end the cue ball cannot meet the ball on a straight line. */
  | { readonly kind: "hidden"; readonly ball: string }
  /** At the end the cue ball can pot the ball directly. */
  | { readonly kind: "next"; readonly ball: string }
  /** At the end two balls lie at least so far apart (centres, m), or one has fallen. */
  | { readonly kind: "apart"; readonly balls: readonly string[]; readonly distance: number }
  /** At the end every other ball lies within this distance of the cue ball, m. */
  | { readonly kind: "gather"; readonly distance: number };

/** A condition in metres, as in the files of drills and studies. */
export type GoalCondition = ConditionOf<GoalArea>;

/** Points for the place where the cue ball stops. */
export interface ZoneOf<A> {
  readonly area: A;
  readonly points: number;
}

/** The goal of an attempt. */
export type GoalOf<A> =
  | {
      readonly kind: "shot";
      readonly needs: readonly ConditionOf<A>[];
      /** Points of an attempt that does it, without zones. Default 1. */
      readonly points?: number;
      /** From the smallest area to the largest. */
      readonly zones?: readonly ZoneOf<A>[];
    }
  | {
      readonly kind: "run";
      readonly balls: readonly string[];
      readonly order: "eight" | "rotation" | "sequence";
    };

/** A goal in metres, as in a drill file. */
export type Goal = GoalOf<GoalArea>;

/** How a shot went. */
export interface ShotVerdict {
  /** Points of the attempt so far. */
  readonly points: number;
  /** Null if the shot was good. */
  readonly fault:
    | { readonly kind: "scratch" | "no-pot" }
    /** The condition that is not met, and how far outside its area the cue ball stopped, m. */
    | { readonly kind: "need"; readonly index: number; readonly distance: number }
    | { readonly kind: "zone"; readonly distance: number }
    | { readonly kind: "wrong-first" | "wrong-ball"; readonly ball: string }
    | null;
  /** Balls that a run still has to pot. */
  readonly left: readonly string[];
}
