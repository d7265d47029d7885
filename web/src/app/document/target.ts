/** At what the cue is aimed: it stays the target while the struck ball is moved. */

import type { Point } from "../../engine/index.ts";
import { toDegrees, toRadians, wrap } from "../common/angles.ts";
import { azimuthOf } from "./strike-angles.ts";
import type { Store } from "./store.ts";

export interface Target {
  /** Id of the ball that is hit first. */
  readonly ball: string;
  /** By how much the aim line passes the ball's centre, m; positive if the centre is left of the line. */
  readonly offset: number;
}

/** The target of the present aim; null if the struck ball meets no ball, or a rail before it. */
export function targetOf(store: Store): Target | null {
  const { struck, balls } = store.shot;
  const outcome = store.ghost.trace?.outcome;
  if (struck === null || !outcome || outcome.rails_before_first_contact.length > 0) return null;
  const to = balls.find(({ id }) => id === outcome.first_contact)?.position;
  if (!to) return null;
  const [x, y] = balls[struck]!.position;
  const azimuth = toRadians(azimuthOf(store.document.shot.strike));
  const offset = Math.cos(azimuth) * (to[1] - y) - Math.sin(azimuth) * (to[0] - x);
  return { ball: outcome.first_contact!, offset };
}

/** The azimuth (degrees) from a place at the same offset of the target's centre; null if it is too near. */
export function azimuthAt([x, y]: Point, [u, v]: Point, offset: number): number | null {
  const away = Math.hypot(u - x, v - y);
  if (away <= Math.abs(offset)) return null;
  return wrap(toDegrees(Math.atan2(v - y, u - x) - Math.asin(offset / away)));
}
