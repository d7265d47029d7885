/** A gesture on the table: it starts, moves, and ends or is cancelled. */

import type { Point } from "../../engine/index.ts";
import { dropStop, stopOf } from "../analyse/stop-handle.ts";
import { hidePreview } from "../analyse/result-preview.ts";
import { removeBall } from "../document/layout-changes.ts";
import { marksOf } from "../document/marks.ts";
import { targetOf } from "../document/target.ts";
import { beginDraw, moveDraw, tapDraw } from "../draw/draw-gesture.ts";
import { isAway, moveBall, moveStop, turnCue } from "./drags.ts";
import { FingerPace } from "./finger-pace.ts";
import type { Gesture, GestureState, Pointer } from "./gesture-state.ts";
import { meansPocket, tap } from "./taps.ts";

/**
 * Movement (CSS pixels) below which a gesture is a tap. On the cloth it is small, because a tap there aims
 * at the pointer and a drag turns the cue by as much as the pointer turns; on a ball or on a pocket that is
 * meant a finger may slip further.
 */
const TAP_REACH = { cloth: 3, mouse: 4, finger: 10 };

/** Distance (m) from the middle of the cue ball's stopping place from which it is dragged. */
const STOP_REACH = { mouse: 0.05, other: 0.09 };

/** A pointer goes down. A second one cancels the gesture: the viewer moves the camera. */
export function start(state: GestureState, event: Pointer): void {
  state.down.add(event.pointerId);
  if (state.down.size > 1) {
    cancel(state);
    return;
  }
  if (event.button !== 0) return;
  const { surface, context } = state;
  const gesture = begun(state, event);
  state.present = gesture;
  surface.setPointerCapture(event.pointerId);
  if (gesture.kind === "stroke") surface.dataset.drag = "cue";
  else if (gesture.kind !== "camera" && gesture.kind !== "cue") state.loupe.press(event);
  context.viewer.controls = gesture.kind === "cue" || gesture.kind === "camera";
}

/** The gesture that a press begins, by what is at the pointer. */
function begun(state: GestureState, event: Pointer): Gesture {
  const { store, context } = state;
  const { ball, point } = state.pick(event);
  state.count += 1;
  const [x, y] = [event.clientX, event.clientY];
  const press = {
    pointer: event.pointerId,
    type: event.pointerType,
    group: `gesture ${state.count}`,
    start: { x, y },
    ball,
    reach: TAP_REACH[event.pointerType === "mouse" ? "mouse" : "finger"],
    moved: false,
  };
  if (store.session.drawing) {
    const drag = beginDraw(store, context, event);
    return drag ? { ...press, ...drag, kind: "draw" } : { ...press, kind: "camera" };
  }
  if (ball === null && state.stroke.press(event, press.group)) return { ...press, kind: "stroke" };
  if (ball === null && point && isAtStop(state, event, point)) return { ...press, kind: "stop" };
  // A finger taps the ball near it, but moves only one that it is on: beside it, a drag turns the cue.
  const held = ball === null ? null : context.viewer.pick(x, y).ball;
  const isAiming = store.session.mode === "aim";
  if (held !== null && isAiming) {
    const [u, v] = store.shot.balls[held]!.position;
    const target = held === store.shot.struck ? targetOf(store) : null;
    const grip: Point = point ? [u - point[0], v - point[1]] : [0, 0];
    return { ...press, kind: "ball", held, target, grip };
  }
  const reach = held !== null || meansPocket(state, event) ? press.reach : TAP_REACH.cloth;
  if (!isAiming || store.view.camera === "orbit") return { ...press, reach, kind: "camera" };
  const pace = event.pointerType === "mouse" ? null : new FingerPace(event);
  return { ...press, reach, kind: "cue", azimuth: null, last: { x, y, point }, pace };
}

/** Whether a point is at the place where the cue ball stops, which can be dragged. */
function isAtStop({ store }: GestureState, event: Pointer, [x, y]: Point): boolean {
  const place = stopOf(store);
  if (!place) return false;
  const reach = event.pointerType === "mouse" ? STOP_REACH.mouse : STOP_REACH.other;
  return Math.hypot(x - place[0], y - place[1]) < reach;
}

/** A pointer that is down moves. */
export function move(state: GestureState, event: Pointer): void {
  const gesture = state.present;
  if (gesture?.pointer !== event.pointerId) return;
  if (gesture.kind === "stroke") {
    state.stroke.move(event.clientX, event.clientY);
    return;
  }
  state.loupe.move(event);
  const { x, y } = gesture.start;
  if (!gesture.moved && Math.hypot(event.clientX - x, event.clientY - y) < gesture.reach) return;
  if (state.store.session.mode === "replay") return;
  gesture.moved = true;
  state.surface.dataset.drag ??= gesture.kind === "cue" ? "turn" : gesture.kind;
  if (gesture.kind === "stop") moveStop(state, event);
  else if (gesture.kind === "draw") {
    moveDraw(state.store, state.context, gesture, event, gesture.group);
  } else if (gesture.kind === "ball") moveBall(state, gesture, event);
  else if (gesture.kind === "cue") {
    turnCue(state, gesture, event);
    if (event.pointerType !== "mouse") state.closeUp.show({ x: event.clientX, y: event.clientY });
  }
}

/** A pointer is released. */
export function end(state: GestureState, event: Pointer): void {
  state.down.delete(event.pointerId);
  const gesture = state.present;
  if (gesture?.pointer !== event.pointerId) return;
  const { store, context } = state;
  // The last move counts.
  context.loop.flush();
  if (gesture.kind === "stroke") state.stroke.release();
  else if (!gesture.moved && store.session.drawing) tapDraw(store, context, event);
  else if (!gesture.moved) tap(state, gesture, event);
  else if (gesture.kind === "ball" && isAway(state, event)) {
    removeBall(store, store.shot.balls[gesture.held]!.id, gesture.group);
  } else if (gesture.kind === "stop") {
    const { point } = state.pick(event);
    if (point) dropStop(store, context, point);
    else hidePreview(store);
  }
  settle(state);
}

/** Ends the present gesture without its effect at a release. */
export function cancel(state: GestureState): void {
  const gesture = state.present;
  if (gesture?.kind === "stop") hidePreview(state.store);
  if (gesture?.kind === "draw" && marksOf(state.store.document.shot) !== gesture.before) {
    state.store.undo();
  }
  settle(state);
}

function settle(state: GestureState): void {
  state.loupe.release();
  state.closeUp.hide();
  if (!state.present) return;
  state.stroke.cancel();
  state.present = null;
  state.context.viewer.controls = true;
  delete state.surface.dataset.drag;
  delete state.surface.dataset.away;
  state.store.settle();
}

/** A mouse moves without a button: the pointer's shape tells what a press would take. */
export function hover(state: GestureState, event: Pointer): void {
  const { clientX, clientY, pointerType } = event;
  const on = state.stroke.over(clientX, clientY, pointerType) ? "cue" : "cloth";
  state.surface.dataset.over = state.pick(event).ball === null ? on : "ball";
}
