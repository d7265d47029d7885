/** The areas that a game marks on the cloth. */

import type { Geometry, Point } from "../../engine/index.ts";
import type { Area } from "../../viewer/index.ts";
import type { Game } from "../document/game.ts";
import type { Progress } from "./progress.ts";
import { handOf } from "./referee.ts";

const HAND = "#ffe9a8";
const CALLED = "#ffd23f";
const ON = "#ffffff";

/** Corners of the polygon for a circle or a half circle. */
const CORNERS = 48;

/** Radius of the ring around a ball that is on or called, in ball radii. */
const RING = 1.5;

/** Up to this many balls on are marked; more rings would only distract. */
const MARKED_BALLS = 7;

/** The region for a cue ball in hand, the balls on, and the called ball and pocket. */
export function areasOf(
  game: Game,
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
  const { call } = game;
  if (request.on.length <= MARKED_BALLS) {
    for (const id of request.on) {
      const at = balls[id];
      if (at && id !== call?.ball) areas.push({ outline: circle(at, RING * radius), color: ON });
    }
  }
  const called = call?.ball === undefined ? undefined : balls[call.ball];
  if (called) areas.push({ outline: circle(called, RING * radius), color: CALLED });
  const pocket = geometry.pockets.find(({ name }) => name === call?.into);
  if (pocket) areas.push({ outline: circle(pocket.center, pocket.radius), color: CALLED });
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
  return arc(center, (right - left) / 2, Math.PI, 2 * Math.PI);
}

function circle(center: Point, radius: number): Point[] {
  return arc(center, radius, 0, 2 * Math.PI);
}

function arc([x, y]: Point, radius: number, from: number, to: number): Point[] {
  return Array.from({ length: CORNERS + 1 }, (_, k) => {
    const angle = from + ((to - from) * k) / CORNERS;
    return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)] as const;
  });
}
