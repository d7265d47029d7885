/** The fine wheel at the thumb's side of the table: it turns the cue by hundredths of a degree. */

import "./fine-wheel.css";
import type { Context } from "../common/context.ts";
import { h, uniqueId } from "../common/dom.ts";
import { hasFlag, setFlag } from "../common/flag.ts";
import { round } from "../common/units.ts";
import { azimuthOf } from "../document/strike-angles.ts";
import { turn } from "../document/strike-changes.ts";
import type { Store } from "../document/store.ts";
import { canAim } from "../game/awaited-turn.ts";
import { t } from "../words/translate.ts";
import type { AimCloseUp } from "./aim-close-up.ts";

/** Degrees per pixel of a drag, and per arrow key: three pixels are 0.05°. */
const PER_PIXEL = 0.015;
const PER_KEY = 0.05;
const PER_PAGE = 0.5;

/** Pixels by which the ridges move when the cue turns by a degree. */
const RIDGES = 1 / PER_PIXEL;

/** Name in the browser's storage of the choice that the wheel is on the left. */
const LEFT = "carom-wheel-left";

const KEYS: Readonly<Record<string, number>> = {
  ArrowUp: PER_KEY,
  ArrowLeft: PER_KEY,
  ArrowDown: -PER_KEY,
  ArrowRight: -PER_KEY,
  PageUp: PER_PAGE,
  PageDown: -PER_PAGE,
};

/** @param settings Gets the choice of the side. */
export function mountFineWheel(
  stage: HTMLElement,
  settings: HTMLElement,
  store: Store,
  context: Context,
  closeUp: AimCloseUp,
): void {
  const wheel = h("div", {
    class: "fine-wheel",
    tabindex: 0,
    role: "slider",
    "aria-label": t("aim.wheel"),
    "aria-orientation": "vertical",
    "aria-valuemin": 0,
    "aria-valuemax": 360,
  });
  stage.append(wheel);
  mountSide(settings, wheel);
  followDrags(wheel, store, context, closeUp);
  wheel.addEventListener("keydown", (event) => {
    const degrees = KEYS[event.key];
    if (degrees === undefined) return;
    event.preventDefault();
    event.stopPropagation();
    turn(store, degrees, "wheel-keys");
  });
  wheel.addEventListener("blur", () => store.settle());
  const show = (): void => {
    wheel.hidden = store.session.mode !== "aim" || !canAim(store, context.engine);
    const azimuth = azimuthOf(store.document.shot.strike);
    wheel.style.setProperty("--turned", `${round((-azimuth * RIDGES) % 9, 2)}px`);
    wheel.setAttribute("aria-valuenow", String(azimuth));
    wheel.setAttribute("aria-valuetext", t("aim.wheel-degrees", { degrees: round(azimuth, 2) }));
  };
  store.subscribe((now, before) => {
    const isSame = now.document === before.document && now.session.mode === before.session.mode;
    if (!isSame) context.loop.input(wheel, show);
  });
  show();
}

/** Turns the cue while a pointer drags the wheel; upwards is to the left, as seen from the cue. */
function followDrags(
  wheel: HTMLElement,
  store: Store,
  context: Context,
  closeUp: AimCloseUp,
): void {
  let last: { readonly pointer: number; readonly y: number } | null = null;
  let drags = 0;
  wheel.addEventListener("pointerdown", (event) => {
    if (event.button !== 0 || last) return;
    wheel.setPointerCapture(event.pointerId);
    drags += 1;
    last = { pointer: event.pointerId, y: event.clientY };
  });
  wheel.addEventListener("pointermove", (event) => {
    if (last?.pointer !== event.pointerId) return;
    context.loop.input(followDrags, () => {
      if (!last || event.clientY === last.y) return;
      turn(store, (last.y - event.clientY) * PER_PIXEL, `wheel ${drags}`);
      last = { ...last, y: event.clientY };
      closeUp.show({ x: event.clientX, y: event.clientY });
    });
  });
  const end = (event: PointerEvent): void => {
    if (last?.pointer !== event.pointerId) return;
    context.loop.flush();
    last = null;
    closeUp.hide();
    store.settle();
  };
  wheel.addEventListener("pointerup", end);
  wheel.addEventListener("pointercancel", end);
}

/** The switch for left-handed players. The browser keeps the choice. */
function mountSide(root: HTMLElement, wheel: HTMLElement): void {
  const box = h("input", { type: "checkbox", id: uniqueId("wheel"), role: "switch" });
  const show = () => (wheel.dataset.side = box.checked ? "left" : "right");
  box.checked = hasFlag("localStorage", LEFT, false);
  box.addEventListener("change", () => {
    setFlag("localStorage", LEFT, box.checked);
    show();
  });
  show();
  const label = h("label", { for: box.id }, t("aim.wheel-left"));
  root.append(h("div", { class: "switch row wheel-side" }, box, label));
}
