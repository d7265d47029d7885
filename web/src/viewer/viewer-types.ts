/**
 * Data for the viewer. Lengths are in metres, angles in radians; coordinates are those of a shot file:
 * origin at the bottom left corner of the playing area, x along the width, y along the length, z up from
 * the slate.
 */

import { MOTIONS } from "../engine/types.ts";

export type { BallInfo, DrawnMark, Geometry, Point } from "../engine/types.ts";

/**
 * Offsets of a ball's position, velocity, angular velocity, orientation (x, y, z, w) and motion code among its
 * `STRIDE` numbers.
 */
export const POSITION = 0;
export const VELOCITY = 3;
export const SPIN = 6;
export const ORIENTATION = 9;
export const MOTION = 13;

/** Codes of the two motions after which a ball is no longer in play. */
export const POCKETED = MOTIONS.indexOf("pocketed");
export const OFF_TABLE = MOTIONS.indexOf("off-table");

export type Theme = "light" | "dark";
export type CameraMode = "top" | "orbit" | "cue";
export type Quality = "auto" | "low" | "high";

/** Numbers per vertex of a path: x, y, z (m), t (s). */
export const VERTEX = 4;

/** Path of a ball's centre: `points` has `VERTEX` numbers per vertex. */
export interface BallPath {
  ball: number;
  points: Float64Array;
  /**
   * `ghost`: a prediction, light and dashed. `trace`: a played shot. `contact-line`: a thin line to aim by.
   * `filmed`: what a camera saw, dotted.
   */
  style: "ghost" | "trace" | "contact-line" | "filmed";
}

/** The cue behind the ball that it strikes. */
export interface CuePose {
  ball: number;
  /** Direction in which the cue moves, rad, counter-clockwise from +x; and the butt's elevation, rad. */
  azimuth: number;
  elevation: number;
  /** Tip offset in ball radii as the shooter sees it; right and above are positive. */
  side: number;
  height: number;
  /** Distance of the tip from the ball, m. */
  pull: number;
}

/**
 * A mark at `position`. `kind` is the type of an event (`ball-collision`, `rail-collision`, …), shown as a
 * small ring in its colour; `ghost-ball`, a translucent ball; `filmed`, a ring of the ball's size and colour;
 * or `refused`, a red ball at a place where no ball may lie.
 */
export interface Mark {
  position: readonly [number, number, number];
  kind: string;
  /** Index of the ball; a ghost ball has its radius and colour. */
  ball?: number;
}

/** A marked area of the cloth: x, y (m) of each corner, filled lightly in `color`. */
export interface Area {
  readonly outline: readonly (readonly [x: number, y: number])[];
  readonly color: string;
}

/** The ball and the place under a point of the screen. */
export interface PickResult {
  ball: number | null;
  /** x, y (m) at the height of the balls' centres; null above the horizon. */
  point: [number, number] | null;
}

/** What is under a pointer. A ball goes before a pocket, a pocket before a rail. */
export interface HitResult extends PickResult {
  /** Name of the pocket, also somewhat beside it, and of the rail; null if there is none. */
  pocket: string | null;
  rail: string | null;
}

/** What is lit: a pocket or a rail by name, a ball by its index. */
export interface Lit {
  readonly pocket?: string;
  readonly rail?: string;
  readonly ball?: number;
  /** Whether the light pulses, unless motion is reduced. The table is then drawn all the time. */
  readonly pulses?: boolean;
}
