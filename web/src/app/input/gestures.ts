/**
 * Mouse, pen and touch on the table. A drag on the cloth turns the cue, which clicks into pots; a drag of
 * a ball moves it, and a drag of the place where the cue ball stops changes the stroke. A tap on the cloth
 * aims there, a tap on a ball aims at it, and a tap on a pocket then aims the ball at it. A press on the cue
 * and a pull shoot. A finger that rests on a ball has a loupe, and one that turns the cue a
 * close-up of the contact. With the free camera a drag on the cloth turns the
 * camera; the viewer handles that, several fingers, and the other buttons.
 */

import type { Context } from "../common/context.ts";
import type { Store } from "../document/store.ts";
import type { AimCloseUp } from "./aim-close-up.ts";
import { cancel, end, hover, move, start } from "./gesture.ts";
import { GestureState } from "./gesture-state.ts";

export function mountGestures(
  canvas: HTMLCanvasElement,
  store: Store,
  context: Context,
  closeUp: AimCloseUp,
): void {
  const { loop } = context;
  const surface = {
    dataset: canvas.dataset,
    setPointerCapture: (pointer: number) => {
      canvas.setPointerCapture(pointer);
    },
    isOpen: (x: number, y: number) => document.elementFromPoint(x, y) === canvas,
  };
  const state = new GestureState(store, context, surface, closeUp);
  // In the capture phase, so that it switches the viewer's controls off before their own listener runs.
  const early = { capture: true };
  canvas.addEventListener("pointerdown", (event) => start(state, event), early);
  canvas.addEventListener("pointermove", (event) => {
    if (state.present?.pointer === event.pointerId) loop.input(canvas, () => move(state, event));
    else if (event.pointerType === "mouse" && event.buttons === 0) {
      loop.input("hover", () => hover(state, event));
    }
  });
  canvas.addEventListener("pointerup", (event) => end(state, event));
  canvas.addEventListener("pointercancel", (event) => {
    state.down.delete(event.pointerId);
    if (state.present?.pointer === event.pointerId) cancel(state);
  });
  // A long press of a finger would open a menu over the loupe.
  canvas.addEventListener("contextmenu", (event) => {
    if (state.present?.type === "touch") event.preventDefault();
  });
  // Before the keys of the page, which would only clear the selection.
  const leave = (event: KeyboardEvent) => {
    if (event.key !== "Escape" || state.present?.kind !== "stroke") return;
    event.stopPropagation();
    loop.flush();
    cancel(state);
  };
  addEventListener("keydown", leave, early);
}
