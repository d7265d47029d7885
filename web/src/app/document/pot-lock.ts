/** The aim at a pocket: it stays solved while speed, English and elevation change. */

import { CaromError, type PocketName, type PotAim, type Shot } from "../../engine/index.ts";
import { azimuthTo, toDegrees, wrap } from "../common/angles.ts";
import type { AimedShot, PotLock } from "./document.ts";
import { azimuthOf, changed } from "./strike-angles.ts";

/** The azimuth of a solved aim, degrees as the page writes them. */
export function azimuthOfAim({ strike }: PotAim): number {
  return wrap(toDegrees(strike.azimuth));
}

/** What the page keeps of an aim. */
export function lockOf(ball: string, pocket: PocketName, aim: PotAim): PotLock {
  const { kind, losesCueBall } = aim;
  return { ball, pocket, solved: true, margin: toDegrees(aim.margin), kind, losesCueBall };
}

/**
 * The shot aimed again after a change, and its lock: null if the change turned the cue or took a ball of
 * the aim away. If no line is left, the lock is not solved, and the aim stays where it was, or on the ball if
 * the struck ball was moved.
 *
 * @param read Reads a shot; the caller frees it.
 * @param near Whether only lines near the present one are searched.
 */
export function steered(
  lock: PotLock,
  [before, after]: readonly [AimedShot, AimedShot],
  read: (shot: AimedShot) => Shot,
  near = false,
): { readonly shot: AimedShot; readonly lock: PotLock | null } {
  const turned = azimuthOf(after.strike) !== azimuthOf(before.strike);
  if (turned || after.strike.ball !== before.strike.ball) return { shot: after, lock: null };
  try {
    const shot = read(after);
    const aim = shot.potAim(lock.ball, lock.pocket, { near });
    shot.free();
    if (!aim) return { shot: towards(lock.ball, before, after), lock: { ...lock, solved: false } };
    const strike = changed(after.strike, { azimuth_deg: azimuthOfAim(aim) });
    return { shot: { ...after, strike }, lock: lockOf(lock.ball, lock.pocket, aim) };
  } catch (error) {
    if (!(error instanceof CaromError)) throw error;
    return { shot: after, lock: null };
  }
}

/** A shot whose struck ball was moved, aimed at the ball of a pot that is lost; others stay as they are. */
function towards(ball: string, before: AimedShot, after: AimedShot): AimedShot {
  const place = (shot: AimedShot, wanted: string) =>
    shot.balls.find(({ id }) => id === wanted)?.position;
  const [from, to] = [place(after, after.strike.ball), place(after, ball)];
  if (!from || !to || String(from) === String(place(before, before.strike.ball))) return after;
  const azimuth_deg = azimuthTo([from[0], from[1]], [to[0], to[1]]);
  return { ...after, strike: changed(after.strike, { azimuth_deg }) };
}
