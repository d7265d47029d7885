/**
 * What the viewer is given. Lengths in metres, angles in radians; the frame is the shot file's: origin
 * at the bottom left corner of the playing area, x along the width, y along the length, z up from the
 * slate.
 */

import { MOTIONS } from "../engine/types";

export { STRIDE } from "../engine/types";
export type { BallInfo, Geometry, Point } from "../engine/types";

/** Where a ball's orientation (x, y, z, w) and its motion's code stand among its `STRIDE` numbers. */
export const ORIENTATION = 9;
export const MOTION = 13;

/** Codes of the two motions after which a ball is no longer in play. */
export const POCKETED = MOTIONS.indexOf("pocketed");
export const OFF_TABLE = MOTIONS.indexOf("off-table");

export type Theme = "light" | "dark";
export type CameraMode = "top" | "orbit" | "cue";
export type Quality = "auto" | "low" | "high";

/** Where one ball's centre goes: `points` is x, y, z (m), t (s) per vertex. */
export interface BallPath {
  ball: number;
  points: Float64Array;
  /** `ghost`: a prediction, light and dashed. `trace`: what has happened. */
  style: "ghost" | "trace";
}

/** The cue at the ball it aims at. */
export interface CuePose {
  ball: number;
  /** Direction in which the cue moves, rad, counter-clockwise from +x; and the butt's elevation, rad. */
  azimuth: number;
  elevation: number;
  /** Tip offset, ball radii, as the shooter sees it: right and above are positive. */
  side: number;
  height: number;
  /** Distance of the tip from the ball, m. */
  pull: number;
}

/**
 * Something to point out. `kind` is an event's type (`ball-collision`, `rail-collision`, …), which gets a
 * small ring of its colour at `position`, `ghost-ball`: a translucent ball there, or `refused`: a red one, where a ball may not lie.
 */
export interface Mark {
  position: readonly [number, number, number];
  kind: string;
  /** The ball it is about: a ghost ball takes its radius and colour. */
  ball?: number;
}

/** A part of the cloth to point out: its outline, x, y (m) per corner, filled lightly in `color`. */
export interface Area {
  readonly outline: readonly (readonly [x: number, y: number])[];
  readonly color: string;
}

/** What lies under a point of the screen. */
export interface Pick {
  ball: number | null;
  /** x, y (m) at the height of the balls' centres; null above the horizon. */
  point: [number, number] | null;
}
