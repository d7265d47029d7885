/** The layouts that follow from an attempt. */

import type { Strike, Trace } from "../../engine/index.ts";
import { toDegrees } from "../common/angles.ts";
import type { AimedShot } from "../document/document.ts";
import type { Drill } from "./drills/index.ts";
import { restOf } from "./drill-judge.ts";

/** The balls that the attempts of a drill have to pot, if they are runs. */
export function runOf({ steps }: Drill): readonly string[] {
  const { goal } = steps[0]!;
  return goal.kind === "run" ? goal.balls : [];
}

/** The layout with the balls where a shot left them. */
export function continued(set: AimedShot, trace: Trace): AimedShot {
  const gone = new Set(trace.outcome.pocketed.map(([ball]) => ball));
  const balls = set.balls
    .filter(({ id }) => !gone.has(id))
    .map((ball) => ({ ...ball, position: restOf(trace, ball.id)! }));
  return { ...set, balls };
}

/** A layout with a strike of the engine. */
export function aimedAt(set: AimedShot, strike: Strike): AimedShot {
  const { speed, azimuth, elevation, side, height } = strike;
  const angles = { azimuth_deg: toDegrees(azimuth), elevation_deg: toDegrees(elevation) };
  return { ...set, strike: { ...set.strike, speed, side, height, ...angles } };
}
