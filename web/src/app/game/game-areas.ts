/** The areas that a game marks on the cloth. */

import type { Call, Geometry, Point } from "../../engine/index.ts";
import type { Area } from "../../viewer/index.ts";
import { arc } from "../common/arc.ts";
import type { Progress } from "./game-progress.ts";
import { handOf } from "./referee.ts";

const HAND = "#ffe9a8";
const CALLED = "#ffd23f";
const ON = "#ffffff";

/** Radius of the ring around a ball that is on or called, in ball radii. */
const RING = 1.5;

/** Up to this many balls on are marked; more rings would only distract. */
const MARKED_BALLS = 7;

/** The region for a cue ball in hand, the balls on, and the called ball and pocket. */
export function areasOf(
  call: Call | null,
  progress: Progress,
  geometry: Geometry,
  radius: number,
): Area[] {
  const { frame } = progress;
  const { request, balls } = frame.state;
  if (request.kind !== "shot") return [];
  const areas: Area[] = [];
  if (handOf(progress) !== null && frame.handBounds) {
    const outline = region(frame.handBounds, request.in_hand === "the-d");
    areas.push({ outline, color: HAND });
  }
  if (request.on.length <= MARKED_BALLS) {
    for (const id of request.on) {
      const at = balls[id];
      if (at && id !== call?.ball) areas.push({ outline: arc(at, RING * radius), color: ON });
    }
  }
  const called = call?.ball === undefined ? undefined : balls[call.ball];
  if (called) areas.push({ outline: arc(called, RING * radius), color: CALLED });
  const pocket = geometry.pockets.find(({ name }) => name === call?.into);
  if (pocket) areas.push({ outline: arc(pocket.center, pocket.radius), color: CALLED });
  return areas;
}

function region([[left, bottom], [right, top]]: readonly [Point, Point], isD: boolean): Point[] {
  if (!isD) {
    return [
      [left, bottom],
      [right, bottom],
      [right, top],
      [left, top],
    ];
  }
  const center: Point = [(left + right) / 2, top];
  return arc(center, (right - left) / 2, Math.PI);
}
