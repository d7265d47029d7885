/** Drags on the table: the cue turns, a ball moves, or the place where the cue ball stops. */

import type { Point } from "../../engine/index.ts";
import { dragStop } from "../analyse/stop-handle.ts";
import { sweep, toDegrees, wrap } from "../common/angles.ts";
import { ballName } from "../common/shot-words.ts";
import type { Store } from "../document/store.ts";
import { azimuthOf } from "../document/strike-angles.ts";
import { FINE } from "../document/strike-changes.ts";
import { dragBall, isBeside } from "../layout/ball-drag.ts";
import { aimWithSnap, isInPot } from "../pot/aim-with-snap.ts";
import { apart } from "../pot/magnet.ts";
import { t } from "../words/translate.ts";
import type { BallDrag, CueDrag, GestureState, Pointer } from "./gesture-state.ts";

/** Degrees that the cue turns per pixel of a drag, with the camera behind the cue. */
const DEGREES_PER_PIXEL = 0.1;

/** Pixels on either side of a pot from which the cue clicks into it, and the most degrees. */
const SNAP_PIXELS = 7;
const WIDEST_SNAP = 2.5;

/** The most degrees that the cue turns per pixel of fine adjustment: a finger aims to a pixel or two. */
const FINEST = 0.04;

/** Pixels of fine adjustment after which the cue leaves a pot. */
const HOLD_PIXELS = 7;

/** Pixels between the two points that measure the scale of the picture. */
const BESIDE = 8;

/**
 * Turns the cue by as much as the pointer turns around the struck ball. Fine adjustment and a slow finger turn it
 * by a tenth, and never by a jump: for them the cue does not click into pots.
 */
export function turnCue(state: GestureState, drag: CueDrag, event: Pointer): void {
  const { store } = state;
  const { point } = state.pick(event);
  const { last } = drag;
  drag.last = { x: event.clientX, y: event.clientY, point };
  const isSlow = drag.pace?.follow(event) === true;
  const { struck, balls } = store.shot;
  if (struck === null) return;
  const [x, y] = balls[struck]!.position;
  const swept =
    store.view.camera === "cue"
      ? (last.x - event.clientX) * DEGREES_PER_PIXEL
      : last.point && point
        ? sweep([x, y], last.point, point)
        : 0;
  if (swept === 0) return;
  const perPixel = degreesPerPixel(state, event, [x, y], point);
  if (isSlow || store.session.fine || event.shiftKey) {
    const share = perPixel > 0 ? Math.min(FINE, FINEST / perPixel) : FINE;
    turnFinely(store, drag, swept * share, HOLD_PIXELS * perPixel * share);
    return;
  }
  drag.azimuth = (drag.azimuth ?? azimuthOf(store.document.shot.strike)) + swept;
  aimWithSnap(store, drag.azimuth, Math.min(SNAP_PIXELS * perPixel, WIDEST_SNAP), drag.group);
}

/** Turns the cue by `degrees` from where it is. A pot is left after more than `hold` degrees. */
function turnFinely(store: Store, drag: CueDrag, degrees: number, hold: number): void {
  const now = azimuthOf(store.document.shot.strike);
  // Where a wide turn has clicked into a pot, the pointer may be degrees beside it.
  const from = drag.azimuth === null || apart(drag.azimuth, now) > hold ? now : drag.azimuth;
  drag.azimuth = from + degrees;
  if (isInPot(store)) {
    if (apart(drag.azimuth, now) <= hold) return;
    drag.azimuth = now + degrees;
  }
  store.strike({ azimuth_deg: wrap(drag.azimuth) }, t("change.aim"), drag.group);
}

/** Degrees by which a drag of one pixel turns the cue. */
function degreesPerPixel(
  { store, context }: GestureState,
  event: Pointer,
  center: Point,
  point: Point | null,
): number {
  if (store.view.camera === "cue") return DEGREES_PER_PIXEL;
  const beside = context.viewer.pick(event.clientX + BESIDE, event.clientY).point;
  if (!point || !beside) return 0;
  const perPixel = Math.hypot(beside[0] - point[0], beside[1] - point[1]) / BESIDE;
  const radius = Math.hypot(point[0] - center[0], point[1] - center[1]);
  return radius > 0 ? toDegrees(perPixel / radius) : 0;
}

/** Moves the held ball, or marks that a release would put it away. */
export function moveBall(state: GestureState, drag: BallDrag, event: Pointer): void {
  const { store, surface } = state;
  const { point } = state.pick(event);
  if (!point) return;
  surface.dataset.drag = "ball";
  const { id } = store.shot.balls[drag.held]!;
  if (isAway(state, event)) {
    if (surface.dataset.away === undefined) {
      state.context.announce(t("layout.let-go", { ball: ballName(id) }));
    }
    surface.dataset.away = "";
    return;
  }
  delete surface.dataset.away;
  const position: Point = [point[0] + drag.grip[0], point[1] + drag.grip[1]];
  store.setSession({ selected: id });
  const free = store.session.fine || event.shiftKey;
  dragBall(store, id, position, drag.group, { free, target: drag.target });
}

/** Whether the pointer is beside the table, where a ball goes back to the tray. */
export function isAway(state: GestureState, event: Pointer): boolean {
  if (state.store.document.game) return false;
  const { point } = state.pick(event);
  const isOpen = state.surface.isOpen(event.clientX, event.clientY);
  return !isOpen || (point !== null && isBeside(state.store, point));
}

/** Moves the place where the cue ball stops. */
export function moveStop(state: GestureState, event: Pointer): void {
  const { point } = state.pick(event);
  if (point) dragStop(state.store, point);
}
