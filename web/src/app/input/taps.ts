/** Taps on the table: they select a ball, aim the cue, and call balls and pockets. */

import type { PocketName } from "../../engine/index.ts";
import { aimAtPocket } from "../analyse/aim-at-pocket.ts";
import { azimuthTo } from "../common/angles.ts";
import { aimAt } from "../document/strike-changes.ts";
import { canAim } from "../game/awaited-turn.ts";
import { announceCall, tapBall, tapPocket } from "../game/calling.ts";
import { isObjectBall } from "../pot/aim-with-snap.ts";
import { t } from "../words/translate.ts";
import type { Gesture, GestureState, Pointer } from "./gesture-state.ts";

/** Whether a tap here would aim the selected ball at a pocket, or call one. */
export function meansPocket({ store, context }: GestureState, event: Pointer): boolean {
  if (!isObjectBall(store, store.session.selected)) return false;
  return context.viewer.hit(event.clientX, event.clientY, event.pointerType).pocket !== null;
}

export function tap(state: GestureState, { ball, group }: Gesture, event: Pointer): void {
  const { store, context } = state;
  if (ball !== null) {
    tapOnBall(state, ball);
    return;
  }
  const { clientX, clientY, pointerType } = event;
  const { point, pocket } = context.viewer.hit(clientX, clientY, pointerType);
  const { struck, balls } = store.shot;
  if (!point || struck === null || store.session.mode === "replay") return;
  const tapped = pocket as PocketName | null;
  if (aimAtTapped(state, tapped) || tapPocket(store, context.engine, tapped)) return;
  const [x, y] = balls[struck]!.position;
  store.strike({ azimuth_deg: azimuthTo([x, y], point) }, t("change.aim"), group);
}

/** Selects a ball, aims at it, and calls it where the game wants that; a pot that is solved stays. */
function tapOnBall({ store, context: { engine } }: GestureState, ball: number): void {
  const balls = store.session.replay.trace?.shot.balls ?? store.shot.balls;
  const { id } = balls[ball]!;
  store.setSession({ selected: id });
  if (store.session.mode !== "aim") return;
  tapBall(store, engine, id);
  const isSolved = store.session.lock?.ball === id;
  if (!isSolved && isObjectBall(store, id) && canAim(store, engine)) aimAt(store, id);
}

/** Aims the selected ball at the tapped pocket; in a game, calls them too. */
function aimAtTapped({ store, context }: GestureState, pocket: PocketName | null): boolean {
  const { selected } = store.session;
  if (pocket === null || !isObjectBall(store, selected)) return false;
  // Where a line is found, the call follows the aim.
  aimAtPocket(store, context, selected, pocket, (isFound) => {
    if (isFound) announceCall(store, null);
    else tapPocket(store, context.engine, pocket);
  });
  return true;
}
