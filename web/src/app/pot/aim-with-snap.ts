/** Aiming by turning the cue until it clicks into a pot. */

import { wrap } from "../common/angles.ts";
import { azimuthOf } from "../document/strike-angles.ts";
import type { Store } from "../document/store.ts";
import { apart, magnet } from "./magnet.ts";
import { t } from "../words/translate.ts";

/** Whether a ball of the table may be potted: not the struck one. */
export function isObjectBall(store: Store, id: string | null): id is string {
  const { balls, strike } = store.document.shot;
  return id !== null && id !== strike.ball && balls.some((ball) => ball.id === id);
}

/** Whether the cue is in a pot into which it clicks. */
export function isInPot({ session: { lock } }: Store): boolean {
  return lock?.solved === true && lock.kind === "direct";
}

/**
 * Turns the cue to `azimuth`, or into a pot within `zone` degrees of it. The shot that is then shown is the
 * only one that is simulated, except when the cue clicks into another pot.
 */
export function aimWithSnap(store: Store, azimuth: number, zone: number, group: string): void {
  if (isInPot(store) && apart(azimuthOf(store.document.shot.strike), azimuth) <= zone) return;
  if (!store.strike({ azimuth_deg: wrap(azimuth) }, t("change.aim"), group)) return;
  const { trace } =
    zone > 0 && store.shot.geometry.pockets.length > 0 ? store.ghost : { trace: null };
  const snap = trace && magnet(trace, azimuth, zone);
  if (snap) store.takeAim(snap.ball, snap.pocket, snap.aim, t("change.aim"), group);
}
