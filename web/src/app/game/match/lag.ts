/**
 * The lag for the break, WPA Rules of Play (2016), 1.2: both players send a ball to the foot cushion and
 * back, and the one whose ball stops nearer to the head cushion wins.
 */

import type { Engine, Noise, Point, Seat, Shot, ShotFile, Trace } from "../../../engine/index.ts";

/** Share of the table's width at which each player's ball lies: on both sides of the long string. */
const PLACES = [0.25, 0.75] as const;

/** Distance of the balls behind the head string, m. */
const BEHIND = 0.05;

/** A place on the cloth of every table, m, from its corner. */
const PROBE = 0.4;

/** Why a lag cannot win. */
export type LagFault = "side" | "foot" | "gone" | "crossed";

export interface Lag {
  /** From the ball to the nose of the head cushion, m; for a bad lag null. */
  readonly distance: number | null;
  readonly fault: LagFault | null;
}

/** The table of a lag, with its physics. */
export type LagTable = Pick<ShotFile, "table" | "physics">;

/** The player's errors and the number of the variant. */
export interface LagErrors {
  readonly noise: Noise;
  readonly index: number;
  readonly seed: number;
}

/** The shot of a player, with only his ball: the other ball cannot be reached without a fault. */
function lagShot(engine: Engine, equipment: LagTable, player: Seat, speed: number): Shot {
  const file = (position: Point): ShotFile => ({
    format: "carom-shot/1",
    ...equipment,
    balls: [{ id: "cue", position }],
    strike: { ball: "cue", speed, azimuth_deg: 90 },
  });
  const probe = engine.shot(file([PROBE, PROBE]));
  const { size, markings } = probe.geometry;
  probe.free();
  const [width, length] = size!;
  const line = markings?.head_string ?? length / 4;
  return engine.shot(file([PLACES[player] * width, line - BEHIND]));
}

/** Plays a lag at a cue speed. */
export function playLag(
  engine: Engine,
  table: LagTable,
  player: Seat,
  speed: number,
  errors: LagErrors | null,
): Lag {
  const meant = lagShot(engine, table, player, speed);
  const shot = errors ? meant.variant(errors.noise, errors.index, { seed: errors.seed }) : meant;
  const trace = shot.simulate();
  const lag = judged(trace, player, shot.geometry.size![0]);
  trace.free();
  if (shot !== meant) shot.free();
  meant.free();
  return lag;
}

function judged(trace: Trace, player: Seat, width: number): Lag {
  const { outcome, events, shot } = trace;
  const bad = (fault: LagFault): Lag => ({ distance: null, fault });
  if (outcome.cue_ball_scratched || outcome.off_table.length > 0) return bad("gone");
  const rails = events.flatMap((event) => (event.type === "rail-collision" ? [event.rail] : []));
  if (rails.some((rail) => rail !== "top" && rail !== "bottom")) return bad("side");
  if (rails.filter((rail) => rail === "top").length !== 1) return bad("foot");
  const path = trace.polyline(0, 0.001);
  const side = player === 0 ? 1 : -1;
  for (let k = 0; k < path.length; k += 4) {
    if (side * (path[k]! - width / 2) > 0) return bad("crossed");
  }
  // Beyond the nose the ball lies in the jaws of a corner pocket, which does not count.
  const distance = path.at(-3)! - shot.balls[0]!.radius;
  return distance < 0 ? bad("gone") : { distance, fault: null };
}

/** The winner of two lags; null: they are played again. */
export function lagWinner([a, b]: readonly [Lag, Lag]): Seat | null {
  if (a.distance === b.distance) return null;
  if (a.distance === null) return 1;
  if (b.distance === null) return 0;
  return a.distance < b.distance ? 0 : 1;
}

/** Slowest and fastest cue speed of a lag, m/s, and steps of the search between them. */
export const LAG_SPEEDS = [0.5, 2.5] as const;
const STEPS = 70;

/** The speed at which a lag without errors stops nearest to the head cushion, m/s. */
export function bestLag(engine: Engine, table: LagTable, player: Seat): number {
  const [slow, fast] = LAG_SPEEDS;
  const speeds = Array.from({ length: STEPS + 1 }, (_, k) => slow + ((fast - slow) * k) / STEPS);
  const distance = (speed: number) =>
    playLag(engine, table, player, speed, null).distance ?? Infinity;
  return speeds
    .map((speed) => ({ speed, distance: distance(speed) }))
    .sort((a, b) => a.distance - b.distance)[0]!.speed;
}
