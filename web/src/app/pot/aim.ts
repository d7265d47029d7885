/** Aiming by ball and pocket, and by turning the cue until it clicks into a pot. */

import type { PocketName } from "../../engine/index.ts";
import { wrap } from "../common/angles.ts";
import type { Context } from "../common/context.ts";
import { ballName, pocketName } from "../common/words.ts";
import { lockOf } from "../document/pot-lock.ts";
import type { Store } from "../document/store.ts";
import { magnet } from "./magnet.ts";
import { t } from "../words/translate.ts";

/** Whether a ball of the table may be potted: not the struck one. */
export function isObjectBall(store: Store, id: string | null): id is string {
  const { balls, strike } = store.document.shot;
  return id !== null && id !== strike.ball && balls.some((ball) => ball.id === id);
}

/** Aims `ball` at `pocket`, or says that no line was found. @returns Whether one was. */
export function aimAtPocket(
  store: Store,
  { announce }: Pick<Context, "announce">,
  ball: string,
  pocket: PocketName,
): boolean {
  const names = { ball: ballName(ball), pocket: pocketName(pocket) };
  const found = store.aimAtPocket(ball, pocket, t("change.aim-pot", names));
  if (!found) announce(t("pot.no-line", names));
  return found;
}

/** Aims the selected ball at the next pocket, in the order of the table, that a line reaches. */
export function aimAtNextPocket(store: Store, context: Context, step: 1 | -1): void {
  const { selected, lock } = store.session;
  const pockets = store.shot.geometry.pockets.map(({ name }) => name);
  if (pockets.length === 0) {
    store.refuse(t("pot.no-pockets"));
    return;
  }
  if (!isObjectBall(store, selected)) {
    store.refuse(t("pot.no-ball"));
    return;
  }
  const at = lock?.ball === selected ? pockets.indexOf(lock.pocket) : -1;
  for (let k = 1; k <= pockets.length; k++) {
    const from = at < 0 && step < 0 ? 0 : at;
    const next = (from + step * k + pockets.length * k) % pockets.length;
    const name = pockets[next]!;
    const names = { ball: ballName(selected), pocket: pocketName(name) };
    if (store.aimAtPocket(selected, name, t("change.aim-pot", names))) return;
  }
  context.announce(t("pot.no-line-at-all", { ball: ballName(selected) }));
}

/** Turns the cue to `azimuth`, or into a pot within `zone` degrees of it. */
export function turnTo(store: Store, azimuth: number, zone: number, group: string): void {
  const pocketed = store.shot.geometry.pockets.length > 0;
  const snap = zone > 0 && pocketed ? magnet(store.shot, store.document.shot, azimuth, zone) : null;
  store.strike({ azimuth_deg: snap ? snap.azimuth : wrap(azimuth) }, t("change.aim"), group);
  if (snap) store.setSession({ lock: lockOf(snap.ball, snap.pocket, snap.aim) });
}
