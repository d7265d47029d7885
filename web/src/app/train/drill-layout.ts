/** The shot file of a drill's step. */

import type { BallEntry, Engine, Point } from "../../engine/index.ts";
import { azimuthTo, round4 } from "../common/angles.ts";
import type { AimedShot } from "../document/document.ts";
import { aimed } from "../document/shot-file.ts";
import type { Drill, Step } from "./drills/index.ts";
import { areaInMetres, clothOf, pointOf } from "./drill-places.ts";

/** A step with its drill, ready to be set up. */
export interface Setting {
  readonly drill: Drill;
  readonly step: Step;
  /** Number of the attempt, from 0 on: it is the seed of a rack. */
  readonly attempt: number;
}

/** The balls of a step at their places, and a cue that points at the first object ball. */
export function layoutOf(engine: Engine, { drill, step, attempt }: Setting): AimedShot {
  const { table, cue, speed } = drill;
  if (step.rack) {
    const shot = engine.breakShot(step.rack, { table, seed: attempt });
    const { source } = shot;
    shot.free();
    return aimed(source);
  }
  const cloth = clothOf(engine, table);
  const balls = Object.entries(step.balls).map(([id, place]): BallEntry => {
    const [x, y] = pointOf(cloth, place, step.balls);
    // A ball that touches the right rail is rounded away from it.
    const atRight = "rail" in place && place.rail === "right";
    return { id, position: [atRight ? Math.floor(x * 1e4) / 1e4 : round4(x), round4(y)] };
  });
  const [x, y] = balls.find(({ id }) => id === cue)!.position;
  const [toX, toY] = balls.find(({ id }) => id !== cue)?.position ?? [x, y + 1];
  return {
    format: "carom-shot/1",
    table,
    balls,
    strike: { ball: cue, speed, azimuth_deg: azimuthTo([x, y], [toX, toY]) },
  };
}

/** Why a shot does not count as an attempt: another table, other balls, or the cue ball elsewhere. */
export type Deviation = "table" | "balls" | "cue" | "struck";

/**
 * How the balls on the table differ from the layout that was set; null if they do not.
 *
 * @param hand Whether the cue ball may be placed within the step's area now.
 */
export function deviation(
  engine: Engine,
  { drill, step }: Setting,
  set: AimedShot,
  now: AimedShot,
  hand: boolean,
): Deviation | null {
  if (now.table !== set.table || now.physics !== set.physics) return "table";
  if (now.strike.ball !== drill.cue) return "struck";
  if (now.balls.length !== set.balls.length) return "balls";
  for (const ball of set.balls) {
    const found = now.balls.find(({ id }) => id === ball.id);
    if (!found || found.mass !== ball.mass || found.radius !== ball.radius) return "balls";
    if (found.velocity ?? found.angular_velocity) return "balls";
    const [x, y] = found.position;
    if (x === ball.position[0] && y === ball.position[1]) continue;
    if (ball.id !== drill.cue) return "balls";
    if (!hand || !step.hand || !inHand(engine, drill, step, [x, y])) return "cue";
  }
  return null;
}

function inHand(engine: Engine, { table }: Drill, { hand, balls }: Step, at: Point): boolean {
  return engine.areaDistance(areaInMetres(clothOf(engine, table), hand!, balls), table, at) === 0;
}
