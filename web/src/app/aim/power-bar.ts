/** The power bar beside Shoot: the cue speed on a scale on which soft strokes have room. */

import type { Context } from "../common/context.ts";
import { h, setText } from "../common/dom.ts";
import { round, speedIn } from "../common/units.ts";
import type { Store } from "../document/store.ts";
import { t } from "../words/translate.ts";

/** Ends of the bar, m/s. The number field under Aim takes more. */
const SOFTEST = 0.3;
const HARDEST = 12;

/** Positions of the bar: a step changes the speed by 1 %. */
const STEPS = 370;

/** Upper ends (m/s) of the words for speeds. */
const WORDS = [
  [1.2, "power.soft"],
  [2.2, "power.lag"],
  [5, "power.firm"],
  [7.5, "power.hard"],
  [Infinity, "power.break"],
] as const;

export type PowerWord = (typeof WORDS)[number][1];

/** The cue speed (m/s) at a position of the bar, 0 to `STEPS`: equal steps are equal ratios. */
export function speedAt(position: number): number {
  return round(SOFTEST * (HARDEST / SOFTEST) ** (position / STEPS), 3);
}

/** The cue speed (m/s) of a share of the bar, 0 to 1. */
export function speedOfShare(share: number): number {
  return speedAt(STEPS * Math.min(Math.max(share, 0), 1));
}

/** The position of the bar for a cue speed (m/s); speeds beyond its ends are at its ends. */
export function positionOf(speed: number): number {
  const share = Math.log(speed / SOFTEST) / Math.log(HARDEST / SOFTEST);
  return Math.round(STEPS * Math.min(Math.max(share, 0), 1));
}

/** The players' word for a cue speed (m/s), a key of the catalogue. */
export function powerWord(speed: number): PowerWord {
  return WORDS.find(([end]) => speed < end)![1];
}

export function mountPower(root: HTMLElement, store: Store, context: Context): void {
  const bar = h("input", {
    type: "range",
    class: "power-bar",
    min: 0,
    max: STEPS,
    step: 1,
    "aria-label": t("power.label"),
  });
  const said = h("output", { class: "power-speed" });
  root.append(said, bar);
  bar.addEventListener("input", () => {
    context.loop.input(bar, () => {
      store.strike({ speed: speedAt(Number(bar.value)) }, t("change.speed"), "power");
    });
  });
  bar.addEventListener("change", () => {
    context.loop.flush();
    store.settle();
  });
  const show = (): void => {
    const { speed } = store.document.shot.strike;
    const { units } = store.view;
    bar.value = String(positionOf(speed));
    const word = t(powerWord(speed));
    const text = t("power.speed", { speed: round(speedIn(units, speed), 1), unit: units, word });
    bar.setAttribute("aria-valuetext", text);
    setText(said, text);
  };
  store.subscribe((now, before) => {
    if (now.document !== before.document || now.view !== before.view) show();
  });
  show();
}
