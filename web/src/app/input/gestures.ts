/**
 * Mouse, pen and touch on the table. A drag on the cloth turns the cue, which clicks into pots; a drag of
 * a ball moves it, and a drag of the place where the cue ball stops changes the stroke. A tap on the cloth
 * aims there, a tap on a ball aims at it, and a tap on a pocket then aims the ball at it. A press on the cue
 * and a pull shoot. A finger that rests has a loupe. With the free camera a drag on the cloth turns the
 * camera; the viewer handles that, several fingers, and the other buttons.
 */

import type { PocketName, Point } from "../../engine/index.ts";
import { dragStop, dropStop, stopOf } from "../analyse/stop-handle.ts";
import { aimAtPocket } from "../analyse/aim-at-pocket.ts";
import { hidePreview } from "../analyse/result-preview.ts";
import { removeBall } from "../document/layout-changes.ts";
import { aimAt, FINE } from "../document/strike-changes.ts";
import { type Target, targetOf } from "../document/target.ts";
import { azimuthOf } from "../document/strike-angles.ts";
import { azimuthTo, sweep } from "../common/angles.ts";
import type { Context } from "../common/context.ts";
import { announceCall, tapBall, tapPocket } from "../game/calling.ts";
import { canAim } from "../game/awaited-turn.ts";
import { ballName } from "../common/shot-words.ts";
import { isObjectBall, turnTo } from "../pot/turn-to-pot.ts";
import { dragBall, isBeside } from "../layout/ball-drag.ts";
import type { Store } from "../document/store.ts";
import { Loupe } from "./finger-loupe.ts";
import { Stroke } from "./stroke.ts";
import { t } from "../words/translate.ts";

/**
 * Movement (CSS pixels) below which a gesture is a tap. On the cloth it is small, because a tap there aims
 * at the pointer and a drag turns the cue by as much as the pointer turns; on a ball or on a pocket that is
 * meant a finger may slip further.
 */
const TAP_REACH = { cloth: 3, mouse: 4, finger: 10 };

/** Degrees that the cue turns per pixel of a drag, with the camera behind the cue. */
const DEGREES_PER_PIXEL = 0.1;

/** Pixels on either side of a pot from which the cue clicks into it, and the most degrees. */
const SNAP_PIXELS = 7;
const WIDEST_SNAP = 2.5;
/** Distance (m) from the middle of the cue ball's stopping place from which it is dragged. */
const STOP_REACH = { mouse: 0.05, other: 0.09 };
/** Pixels between the two points that measure the scale of the picture. */
const BESIDE = 8;

interface Drag {
  readonly pointer: number;
  readonly type: string;
  readonly group: string;
  readonly start: { readonly x: number; readonly y: number };
  /** Index of the ball at the pointer when the gesture began: a tap means it. */
  readonly ball: number | null;
  /** Index of the ball that a drag moves: the pointer was on it, and not only near it. */
  readonly held: number | null;
  /** At what the held ball was aimed, if it is the struck one. */
  readonly target: Target | null;
  /** Movement below which the gesture is a tap, CSS pixels. */
  readonly reach: number;
  /** From the pointer to the dragged ball's centre, m. */
  readonly grip: Point;
  /** Where the cue would point without snapping, degrees; null before it turns. */
  azimuth: number | null;
  /** Position of the pointer when it last turned the cue. */
  last: { readonly x: number; readonly y: number; readonly point: Point | null };
  /** Whether it moves the place where the cue ball stops. */
  readonly stop: boolean;
  moved: boolean;
}

let gestures = 0;

export function mountGestures(canvas: HTMLCanvasElement, store: Store, context: Context): void {
  const { viewer, loop } = context;
  const down = new Set<number>();
  let drag: Drag | null = null;
  const stroke = new Stroke(store, context);
  const loupe = new Loupe(viewer);
  /** The pointer that holds the cue. */
  let striking: number | null = null;

  const ballAt = (index: number) => store.shot.balls[index]!;
  const pointOf = (event: PointerEvent) =>
    viewer.pick(event.clientX, event.clientY, event.pointerType);

  // In the capture phase, so that it switches the viewer's controls off before their own listener runs.
  const press = (event: PointerEvent) => {
    down.add(event.pointerId);
    if (down.size > 1) {
      end();
      return;
    }
    if (event.button !== 0) return;
    const { ball, point } = pointOf(event);
    if (ball === null && stroke.press(event, `gesture ${(gestures += 1)}`)) {
      striking = event.pointerId;
      canvas.setPointerCapture(event.pointerId);
      canvas.dataset.drag = "cue";
      viewer.controls = false;
      return;
    }
    // A finger taps the ball near it, but moves only one that it is on: beside it, a drag turns the cue.
    const held = ball === null ? null : viewer.pick(event.clientX, event.clientY).ball;
    const isAiming = store.session.mode === "aim";
    const center = held === null || !isAiming ? null : ballAt(held).position;
    const stop = ball === null && point !== null && isAtStop(event, point);
    const means = held !== null || stop || meansPocket(event);
    gestures += 1;
    drag = {
      pointer: event.pointerId,
      type: event.pointerType,
      group: `gesture ${gestures}`,
      start: { x: event.clientX, y: event.clientY },
      ball,
      held,
      target: isAiming && held !== null && held === store.shot.struck ? targetOf(store) : null,
      reach: means
        ? TAP_REACH[event.pointerType === "mouse" ? "mouse" : "finger"]
        : TAP_REACH.cloth,
      grip: center && point ? [center[0] - point[0], center[1] - point[1]] : [0, 0],
      azimuth: null,
      last: { x: event.clientX, y: event.clientY, point },
      stop,
      moved: false,
    };
    canvas.setPointerCapture(event.pointerId);
    const turnsCamera = held === null && store.view.camera === "orbit";
    if (isAiming && !turnsCamera) loupe.press(event);
    viewer.controls = !stop && (held === null || !isAiming);
  };
  canvas.addEventListener("pointerdown", press, { capture: true });

  canvas.addEventListener("pointermove", (event) => {
    if (striking === event.pointerId) {
      loop.input(canvas, () => {
        stroke.move(event.clientX, event.clientY);
      });
    } else if (drag?.pointer === event.pointerId) {
      const held = drag;
      loop.input(canvas, () => {
        loupe.move(event);
        move(held, event);
      });
    } else if (event.pointerType === "mouse" && event.buttons === 0) {
      loop.input("hover", () => {
        hover(event);
      });
    }
  });

  canvas.addEventListener("pointerup", (event) => {
    down.delete(event.pointerId);
    if (striking === event.pointerId) {
      loop.flush();
      stroke.release();
      end();
    }
    if (drag?.pointer !== event.pointerId) return;
    loop.flush();
    if (!drag.moved) tap(drag, event);
    else if (drag.held !== null && isAway(event)) putAway(drag, drag.held);
    else if (drag.stop) {
      const { point } = pointOf(event);
      if (point) dropStop(store, context, point);
      else hidePreview(store);
    }
    end();
  });

  // A long press of a finger would open a menu over the loupe.
  canvas.addEventListener("contextmenu", (event) => {
    if (drag?.type === "touch") event.preventDefault();
  });

  canvas.addEventListener("pointercancel", (event) => {
    down.delete(event.pointerId);
    if (drag?.pointer !== event.pointerId && striking !== event.pointerId) return;
    if (drag?.stop) hidePreview(store);
    end();
  });

  // Before the keys of the page, which would only clear the selection.
  addEventListener(
    "keydown",
    (event) => {
      if (event.key !== "Escape" || striking === null) return;
      event.stopPropagation();
      loop.flush();
      end();
    },
    { capture: true },
  );

  function end(): void {
    loupe.release();
    if (!drag && striking === null) return;
    stroke.cancel();
    drag = null;
    striking = null;
    viewer.controls = true;
    delete canvas.dataset.drag;
    delete canvas.dataset.away;
    store.settle();
  }

  function hover(event: PointerEvent): void {
    const on = stroke.over(event.clientX, event.clientY, event.pointerType) ? "cue" : "cloth";
    canvas.dataset.over = pointOf(event).ball === null ? on : "ball";
  }

  function move(held: Drag, event: PointerEvent): void {
    const { x, y } = held.start;
    if (!held.moved && Math.hypot(event.clientX - x, event.clientY - y) < held.reach) return;
    if (store.session.mode === "replay") return;
    held.moved = true;
    if (held.stop) {
      const { point } = pointOf(event);
      if (point) dragStop(store, point);
    } else if (held.held === null) {
      if (store.view.camera !== "orbit") aim(held, event);
    } else moveBall(held, held.held, event);
  }

  /** Whether a point is at the place where the cue ball stops, which can be dragged. */
  function isAtStop(event: PointerEvent, [x, y]: Point): boolean {
    const place = stopOf(store);
    if (!place) return false;
    const reach = event.pointerType === "mouse" ? STOP_REACH.mouse : STOP_REACH.other;
    return Math.hypot(x - place[0], y - place[1]) < reach;
  }

  function aim(held: Drag, event: PointerEvent): void {
    const { point } = pointOf(event);
    const { last } = held;
    held.last = { x: event.clientX, y: event.clientY, point };
    const struck = store.shot.struck;
    if (struck === null) return;
    const [x, y] = ballAt(struck).position;
    const swept =
      store.view.camera === "cue"
        ? (last.x - event.clientX) * DEGREES_PER_PIXEL
        : last.point && point
          ? sweep([x, y], last.point, point)
          : 0;
    if (swept === 0) return;
    const fine = store.session.fine || event.shiftKey;
    held.azimuth =
      (held.azimuth ?? azimuthOf(store.document.shot.strike)) + swept * (fine ? FINE : 1);
    // Fine adjustment is for places beside the middle of a pocket.
    const zone = fine ? 0 : SNAP_PIXELS * degreesPerPixel(event, [x, y], point);
    turnTo(store, held.azimuth, Math.min(zone, WIDEST_SNAP), held.group);
  }

  /** Degrees by which a drag of one pixel turns the cue. */
  function degreesPerPixel(event: PointerEvent, center: Point, point: Point | null): number {
    if (store.view.camera === "cue") return DEGREES_PER_PIXEL;
    const beside = viewer.pick(event.clientX + BESIDE, event.clientY).point;
    if (!point || !beside) return 0;
    const perPixel = Math.hypot(beside[0] - point[0], beside[1] - point[1]) / BESIDE;
    const radius = Math.hypot(point[0] - center[0], point[1] - center[1]);
    return radius > 0 ? ((perPixel / radius) * 180) / Math.PI : 0;
  }

  function moveBall(held: Drag, index: number, event: PointerEvent): void {
    const { point } = pointOf(event);
    if (!point) return;
    canvas.dataset.drag = "ball";
    const { id } = ballAt(index);
    if (isAway(event)) {
      if (canvas.dataset.away === undefined) {
        context.announce(t("layout.let-go", { ball: ballName(id) }));
      }
      canvas.dataset.away = "";
      return;
    }
    delete canvas.dataset.away;
    const position: Point = [point[0] + held.grip[0], point[1] + held.grip[1]];
    store.setSession({ selected: id });
    const free = store.session.fine || event.shiftKey;
    dragBall(store, id, position, held.group, { free, target: held.target });
  }

  /** Whether the pointer is beside the table, where a ball goes back to the tray. */
  function isAway(event: PointerEvent): boolean {
    if (store.document.game) return false;
    const { point } = pointOf(event);
    const over = document.elementFromPoint(event.clientX, event.clientY);
    return over !== canvas || (point !== null && isBeside(store, point));
  }

  function putAway(held: Drag, index: number): void {
    removeBall(store, ballAt(index).id, held.group);
  }

  /** Whether a tap here would aim the selected ball at a pocket, or call one. */
  function meansPocket(event: PointerEvent): boolean {
    if (!isObjectBall(store, store.session.selected)) return false;
    return viewer.hit(event.clientX, event.clientY, event.pointerType).pocket !== null;
  }

  /** Aims the selected ball at the tapped pocket; in a game, calls them too. */
  function aimAtTapped(pocket: PocketName | null): boolean {
    const { selected } = store.session;
    if (pocket === null || !isObjectBall(store, selected)) return false;
    // Where a line is found, the call follows the aim.
    aimAtPocket(store, context, selected, pocket, (isFound) => {
      if (isFound) announceCall(store, null);
      else tapPocket(store, context.engine, pocket);
    });
    return true;
  }

  /** Aims at a tapped ball, and calls it where the game wants that; a pot that is solved stays. */
  function aimAtTappedBall(id: string): void {
    tapBall(store, context.engine, id);
    const isSolved = store.session.lock?.ball === id;
    if (!isSolved && isObjectBall(store, id) && canAim(store, context.engine)) aimAt(store, id);
  }

  function tap(held: Drag, event: PointerEvent): void {
    const balls = store.session.trace?.shot.balls ?? store.shot.balls;
    if (held.ball !== null) {
      const { id } = balls[held.ball]!;
      store.setSession({ selected: id });
      if (store.session.mode === "aim") aimAtTappedBall(id);
      return;
    }
    const { point, pocket } = viewer.hit(event.clientX, event.clientY, event.pointerType);
    const struck = store.shot.struck;
    if (!point || struck === null || store.session.mode === "replay") return;
    const tapped = pocket as PocketName | null;
    if (aimAtTapped(tapped) || tapPocket(store, context.engine, tapped)) return;
    const [x, y] = ballAt(struck).position;
    store.strike({ azimuth_deg: azimuthTo([x, y], point) }, t("change.aim"), held.group);
  }
}
