/** Changes of the strike that several controls share. */

import { azimuthTo, wrap } from "../common/angles.ts";
import { obstruction, playedName, raised } from "../common/shot-words.ts";
import { automatic, azimuthOf } from "./strike-angles.ts";
import type { Store } from "./store.ts";
import { t } from "../words/translate.ts";

/** Factor by which fine adjustment reduces every drag and key. */
export const FINE = 0.1;

/** Turns the cue by `degrees`. */
export function turn(store: Store, degrees: number, group: string): void {
  const azimuth = azimuthOf(store.document.shot.strike);
  store.strike({ azimuth_deg: wrap(azimuth + degrees) }, t("change.aim"), group);
}

/** The azimuth from the struck ball to the centre of a ball, degrees; null if it is the struck one. */
export function azimuthToBall({ shot: { balls, struck } }: Store, id: string): number | null {
  const to = balls.find((ball) => ball.id === id)?.position;
  const from = struck === null ? undefined : balls[struck]?.position;
  if (!to || !from || to === from) return null;
  return azimuthTo([from[0], from[1]], [to[0], to[1]]);
}

/** Turns the cue to the centre of a ball. */
export function aimAt(store: Store, id: string): void {
  const azimuth = azimuthToBall(store, id);
  if (azimuth === null) return;
  store.strike({ azimuth_deg: azimuth }, t("change.aim-at", { ball: playedName(id) }));
}

/** Lets the engine choose the elevation: the least angle of a real stroke that clears the rails. */
export function makeElevationAutomatic(store: Store): boolean {
  const { shot } = store.document;
  const strike = automatic(shot.strike);
  return store.apply({ shot: { ...shot, strike } }, t("change.automatic"));
}

/** Raises the butt until the cue passes over the obstacle, if there is one. */
export function raiseTheCue(store: Store): void {
  const outcome = store.ghost.trace?.outcome;
  if (!outcome || obstruction(outcome) === null || outcome.least_elevation_deg === null) return;
  store.strike({ elevation_deg: raised(outcome.least_elevation_deg) }, t("change.elevation"));
}
