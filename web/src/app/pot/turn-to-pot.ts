/** Aiming by turning the cue until it clicks into a pot. */

import { wrap } from "../common/angles.ts";
import { lockOf } from "../document/pot-lock.ts";
import type { Store } from "../document/store.ts";
import { magnet } from "./magnet.ts";
import { t } from "../words/translate.ts";

/** Whether a ball of the table may be potted: not the struck one. */
export function isObjectBall(store: Store, id: string | null): id is string {
  const { balls, strike } = store.document.shot;
  return id !== null && id !== strike.ball && balls.some((ball) => ball.id === id);
}

/** Turns the cue to `azimuth`, or into a pot within `zone` degrees of it. */
export function turnTo(store: Store, azimuth: number, zone: number, group: string): void {
  const pocketed = store.shot.geometry.pockets.length > 0;
  const snap = zone > 0 && pocketed ? magnet(store.shot, store.document.shot, azimuth, zone) : null;
  store.strike({ azimuth_deg: snap ? snap.azimuth : wrap(azimuth) }, t("change.aim"), group);
  if (snap) store.setSession({ lock: lockOf(snap.ball, snap.pocket, snap.aim) });
}
