/**
 * Mouse, pen and touch on the table. A drag on the cloth turns the cue, which clicks into pots; a drag of
 * a ball moves it. A tap on the cloth aims there, a tap on a ball selects it, and a tap on a pocket then
 * aims the ball at it. With the free camera a drag on the cloth turns the
 * camera; the viewer handles that, several fingers, and the other buttons.
 */

import type { Point } from "../../engine/index.ts";
import { placeBall } from "../document/layout.ts";
import { FINE } from "../document/strike.ts";
import { azimuthOf } from "../document/strike-angles.ts";
import { azimuthTo, sweep } from "../common/angles.ts";
import type { Context } from "../common/context.ts";
import { tapBall, tapPocket } from "../game/play.ts";
import { aimAtPocket, isObjectBall, turnTo } from "../pot/aim.ts";
import { pocketAt } from "../pot/pockets.ts";
import type { Store } from "../document/store.ts";
import { t } from "../words/translate.ts";

/** Movement (CSS pixels) below which a gesture is a tap; a finger moves more than a mouse. */
const TAP_REACH = { mouse: 4, other: 10 };

/** Degrees that the cue turns per pixel of a drag, with the camera behind the cue. */
const DEGREES_PER_PIXEL = 0.1;

/** Pixels on either side of a pot from which the cue clicks into it, and the most degrees. */
const SNAP_PIXELS = 7;
const WIDEST_SNAP = 2.5;
/** Pixels between the two points that measure the scale of the picture. */
const BESIDE = 8;

interface Drag {
  readonly pointer: number;
  readonly type: string;
  readonly group: string;
  readonly start: { readonly x: number; readonly y: number };
  /** Index of the ball under the pointer when the gesture began. */
  readonly ball: number | null;
  /** From the pointer to the dragged ball's centre, m. */
  readonly grip: Point;
  /** Where the cue would point without snapping, degrees; null before it turns. */
  azimuth: number | null;
  /** Position of the pointer when it last turned the cue. */
  last: { readonly x: number; readonly y: number; readonly point: Point | null };
  moved: boolean;
}

let gestures = 0;

export function mountGestures(canvas: HTMLCanvasElement, store: Store, context: Context): void {
  const { viewer, loop } = context;
  const down = new Set<number>();
  let drag: Drag | null = null;

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
    const center = ball === null || store.session.mode === "replay" ? null : ballAt(ball).position;
    gestures += 1;
    drag = {
      pointer: event.pointerId,
      type: event.pointerType,
      group: `gesture ${gestures}`,
      start: { x: event.clientX, y: event.clientY },
      ball,
      grip: center && point ? [center[0] - point[0], center[1] - point[1]] : [0, 0],
      azimuth: null,
      last: { x: event.clientX, y: event.clientY, point },
      moved: false,
    };
    canvas.setPointerCapture(event.pointerId);
    viewer.controls = ball === null || store.session.mode === "replay";
  };
  canvas.addEventListener("pointerdown", press, { capture: true });

  canvas.addEventListener("pointermove", (event) => {
    if (drag?.pointer === event.pointerId) {
      const held = drag;
      loop.input(canvas, () => {
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
    if (drag?.pointer !== event.pointerId) return;
    loop.flush();
    if (!drag.moved) tap(drag, event);
    end();
  });

  canvas.addEventListener("pointercancel", (event) => {
    down.delete(event.pointerId);
    if (drag?.pointer === event.pointerId) end();
  });

  function end(): void {
    if (!drag) return;
    drag = null;
    viewer.controls = true;
    delete canvas.dataset.drag;
    store.settle();
  }

  function hover(event: PointerEvent): void {
    canvas.dataset.over = pointOf(event).ball === null ? "cloth" : "ball";
  }

  function move(held: Drag, event: PointerEvent): void {
    const { x, y } = held.start;
    const reach = held.type === "mouse" ? TAP_REACH.mouse : TAP_REACH.other;
    if (!held.moved && Math.hypot(event.clientX - x, event.clientY - y) < reach) return;
    if (store.session.mode === "replay") return;
    held.moved = true;
    if (held.ball === null) {
      if (store.view.camera !== "orbit") aim(held, event);
    } else moveBall(held, held.ball, event);
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
    const position: Point = [point[0] + held.grip[0], point[1] + held.grip[1]];
    store.setSession({ selected: id });
    placeBall(store, id, position, held.group);
  }

  /** Aims the selected ball at the tapped pocket; in a game, calls them too. */
  function aimAtTapped(point: Point): boolean {
    const pocket = pocketAt(store.shot, point);
    const { selected } = store.session;
    if (pocket === null || !isObjectBall(store, selected)) return false;
    aimAtPocket(store, context, selected, pocket);
    tapPocket(store, context.engine, point);
    return true;
  }

  function tap(held: Drag, event: PointerEvent): void {
    const balls = store.session.trace?.shot.balls ?? store.shot.balls;
    if (held.ball !== null) {
      const { id } = balls[held.ball]!;
      store.setSession({ selected: id });
      if (store.session.mode === "aim") tapBall(store, context.engine, id);
      return;
    }
    const { point } = pointOf(event);
    const struck = store.shot.struck;
    if (!point || struck === null || store.session.mode === "replay") return;
    if (aimAtTapped(point) || tapPocket(store, context.engine, point)) return;
    const [x, y] = ballAt(struck).position;
    store.strike({ azimuth_deg: azimuthTo([x, y], point) }, t("change.aim"), held.group);
  }
}
