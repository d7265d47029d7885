/** Magnetic aiming: a cue that turns past a pot clicks into its middle. */

import { CaromError, type PocketName, type PotAim, type Trace } from "../../engine/index.ts";
import { toDegrees } from "../common/angles.ts";
import { azimuthOfAim } from "../document/pot-lock.ts";
import { firstContactEvent } from "./first-contact.ts";

/** Degrees by which the first ball's path may pass a pocket to be drawn to it. */
const CAPTURE = 30;

export interface Snap {
  readonly ball: string;
  readonly pocket: PocketName;
  readonly aim: PotAim;
}

/** The direct pot within `zone` degrees of a simulated aim at `azimuth`, degrees; null if there is none. */
export function magnet(trace: Trace, azimuth: number, zone: number): Snap | null {
  const target = drawn(trace);
  if (!target) return null;
  try {
    const aim = trace.shot.potAim(target.ball, target.pocket, { near: true });
    const snaps = aim?.kind === "direct" && apart(azimuthOfAim(aim), azimuth) <= zone;
    return snaps ? { ...target, aim } : null;
  } catch (error) {
    if (error instanceof CaromError) return null;
    throw error;
  }
}

/** The angle between two directions, degrees. */
export function apart(a: number, b: number): number {
  return Math.abs(((((a - b) % 360) + 540) % 360) - 180);
}

/** The first ball that the cue ball meets, and the pocket nearest to its path. */
export function drawn(trace: Trace): { readonly ball: string; readonly pocket: PocketName } | null {
  const found = firstContactEvent(trace);
  if (!found) return null;
  const { event, other } = found;
  const { position, velocity } = event.after[other]!;
  const way = Math.atan2(velocity[1], velocity[0]);
  const passes = trace.shot.geometry.pockets.map(({ name, center: [x, y] }) => {
    const to = Math.atan2(y - position[1], x - position[0]);
    return { pocket: name, off: apart(toDegrees(to), toDegrees(way)) };
  });
  const [nearest] = passes.sort((a, b) => a.off - b.off);
  return nearest && nearest.off < CAPTURE
    ? { ball: event.balls[other]!, pocket: nearest.pocket }
    : null;
}
