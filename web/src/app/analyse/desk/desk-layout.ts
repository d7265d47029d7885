/** Layouts of an analysis, and the aim of a ball at a pocket by geometry. */

import { CaromError } from "../../../engine/error.ts";
import type {
  BallEntry,
  Engine,
  Noise,
  Pocket,
  PocketName,
  Point,
  Shot,
  ShotFile,
  Strike,
  Trace,
} from "../../../engine/index.ts";
import { STRIDE } from "../../../engine/types.ts";
import { toRadians } from "../../common/angles.ts";

/** Cuts beyond this are not tried, rad: 75°. */
const THINNEST = toRadians(75);

/** A shot file with a strike. */
export type Layout = ShotFile & { readonly strike: NonNullable<ShotFile["strike"]> };

/** A pocket for a ball, as seen from the cue ball. */
export interface PotLine {
  readonly pocket: PocketName;
  /** From the cue ball to the ghost ball, rad. */
  readonly azimuth: number;
  /** Error of the azimuth at which the ball just falls, rad: an estimate by geometry. */
  readonly tolerance: number;
}

/** The direct lines of a ball, those with the largest tolerance first. Balls in the way are not looked at. */
export function potLines(
  pockets: readonly Pocket[],
  cue: Point,
  ball: Point,
  radius: number,
): PotLine[] {
  const lines = pockets.flatMap(({ name, center, radius: hole }) => {
    const [px, py] = [center[0] - ball[0], center[1] - ball[1]];
    const far = Math.hypot(px, py);
    const ghost = [ball[0] - (2 * radius * px) / far, ball[1] - (2 * radius * py) / far] as const;
    const [gx, gy] = [ghost[0] - cue[0], ghost[1] - cue[1]];
    const near = Math.hypot(gx, gy);
    const cos = (gx * px + gy * py) / (near * far);
    if (near < 1e-6 || cos < Math.cos(THINNEST)) return [];
    // An error of the cue's direction grows by the distance over the diameter, and by the cut.
    const growth = near / (2 * radius * cos);
    const tolerance = Math.atan2(Math.max(hole - radius / 2, radius / 4), far) / growth;
    return [{ pocket: name, azimuth: Math.atan2(gy, gx), tolerance }];
  });
  return lines.sort((a, b) => b.tolerance - a.tolerance);
}

/** The chance that a normal error with deviation `sigma` is within ± `tolerance`. */
export function within(tolerance: number, sigma: number): number {
  if (sigma === 0) return 1;
  // Abramowitz & Stegun 7.1.26: an error below 1.5e-7.
  const x = tolerance / (sigma * Math.SQRT2);
  const s = 1 / (1 + 0.3275911 * x);
  const polynomial =
    s *
    (0.254829592 + s * (-0.284496736 + s * (1.421413741 + s * (-1.453152027 + s * 1.061405429))));
  return 1 - polynomial * Math.exp(-x * x);
}

/** The chance of the best pot of a ball with the cue ball at a place, estimated by geometry. */
export function estimate(shot: Shot, cue: Point, ball: Point, noise: Noise): number {
  const radius = shot.balls[0]!.radius;
  const [best] = potLines(shot.geometry.pockets, cue, ball, radius);
  return best ? within(best.tolerance, noise.azimuth) : 0;
}

/** The engine's shot of a layout; null if the balls cannot lie there. */
export function read(engine: Engine, file: ShotFile): Shot | null {
  try {
    return engine.shot(file);
  } catch (error) {
    if (error instanceof CaromError) return null;
    throw error;
  }
}

/** Where a ball is, m; null if the layout does not have it. */
export function placeOf({ balls }: Pick<ShotFile, "balls">, id: string): Point | null {
  const position = balls.find((ball) => ball.id === id)?.position;
  return position ? [position[0], position[1]] : null;
}

/** The layout after a shot; null if the cue ball is no longer on the table. */
export function after(file: Layout, trace: Trace): Layout | null {
  const { pocketed, off_table: off } = trace.outcome;
  const gone = new Set([...off, ...pocketed.map(([ball]) => ball)]);
  if (gone.has(file.strike.ball)) return null;
  const ends = trace.statesAt(trace.duration);
  const ids = trace.shot.balls.map(({ id }) => id);
  const balls = file.balls.flatMap((entry): BallEntry[] => {
    const at = ids.indexOf(entry.id) * STRIDE;
    return gone.has(entry.id) ? [] : [{ ...entry, position: [ends[at]!, ends[at + 1]!] }];
  });
  return { ...file, balls };
}

/** The layout with a strike; without an elevation, at the default one. */
export function struck(file: Layout, strike: Partial<Strike>): Layout {
  const { ball } = file.strike;
  const { speed = 2, azimuth = 0, side = 0, height = 0, elevation } = strike;
  const entry = {
    ball,
    speed,
    azimuth,
    side,
    height,
    ...(elevation !== undefined && { elevation }),
  };
  return { ...file, strike: entry };
}
