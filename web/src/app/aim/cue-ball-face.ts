/** The cue ball as the shooter sees it, with the tip position and the miscue limit. */

import { FINE } from "../document/strike-changes.ts";
import type { Context } from "../common/context.ts";
import { h, svg } from "../common/dom.ts";
import type { Store } from "../document/store.ts";
import { round } from "../common/units.ts";
import { t } from "../words/translate.ts";

/** Step of an arrow key, ball radii. */
const STEP = 0.02;

/** Decimals of an offset in ball radii: 0.001 is 0.03 mm. */
const DIGITS = 3;
const SCALE = 10 ** DIGITS;
/** The most by which rounding moves an offset outwards. */
const ROUNDING = 1 / SCALE;

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};

/**
 * The picture of the face.
 *
 * @returns The picture, and a function that shows the miscue limit and the tip's offset, in ball radii.
 */
export function drawFace(): {
  readonly drawing: SVGSVGElement;
  readonly show: (limit: number, offset: readonly [side: number, height: number]) => void;
} {
  const limit = svg("circle", { class: "face-limit" });
  const dot = svg("circle", { class: "face-tip", r: 0.1 });
  const drawing = svg(
    "svg",
    { viewBox: "-1.08 -1.08 2.16 2.16", "aria-hidden": "true" },
    svg("circle", { class: "face-ball", r: 1 }),
    svg("path", { class: "face-cross", d: "M-1 0H1M0 -1V1" }),
    limit,
    dot,
  );
  const show = (radius: number, [side, height]: readonly [number, number]): void => {
    limit.setAttribute("r", String(radius));
    at(dot, side, height);
  };
  return { drawing, show };
}

/** The nearest offset within the miscue limit, ball radii, rounded towards the centre. */
export function withinLimit(
  [side, height]: readonly [number, number],
  limit: number,
): readonly [number, number] {
  const out = Math.hypot(side, height);
  if (out <= limit - ROUNDING) return [round(side, DIGITS), round(height, DIGITS)];
  const inward = (value: number) =>
    round(Math.trunc((value / out) * limit * SCALE) / SCALE, DIGITS);
  return [inward(side), inward(height)];
}

export function mountFace(root: HTMLElement, store: Store, context: Context): void {
  const face = new Face(root, store, context);
  store.subscribe(() => face.show());
  face.show();
}

class Face {
  readonly #store: Store;
  readonly #context: Context;
  readonly #picture = drawFace();
  readonly #tried = svg("circle", { class: "face-tried", r: 0.1 });
  readonly #face: HTMLElement;
  /** The last place of the pointer, CSS pixels; null: it is not pressed. */
  #last: { readonly x: number; readonly y: number } | null = null;
  /** The offset at the pointer, which may be beyond the miscue limit. */
  #wanted = { side: 0, height: 0 };

  constructor(root: HTMLElement, store: Store, context: Context) {
    this.#store = store;
    this.#context = context;
    const { drawing } = this.#picture;
    drawing.append(this.#tried);
    this.#face = h(
      "div",
      {
        class: "face",
        tabindex: 0,
        role: "application",
        "aria-roledescription": t("face.role"),
        "aria-describedby": "face-hint",
        onblur: () => store.settle(),
      },
      drawing,
    );
    root.append(this.#face);
    this.#face.addEventListener("pointerdown", (event) => this.#press(event));
    this.#face.addEventListener("pointermove", (event) => {
      if (this.#last) context.loop.input(this.#face, () => this.#follow(event));
    });
    for (const type of ["pointerup", "pointercancel"] as const)
      this.#face.addEventListener(type, () => this.#release());
    this.#face.addEventListener("keydown", (event) => this.#key(event));
  }

  get #offset(): { side: number; height: number } {
    const { side = 0, height = 0 } = this.#store.document.shot.strike;
    return { side, height };
  }

  show(): void {
    const { side, height } = this.#offset;
    this.#picture.show(this.#store.shot.miscueLimit, [side, height]);
    const refused = this.#store.session.refusal?.shot?.strike;
    const off = refused && (refused.side !== side || refused.height !== height);
    this.#tried.style.display = off ? "" : "none";
    if (off) at(this.#tried, refused.side ?? 0, refused.height ?? 0);
    const offset = spokenOffset(side, height);
    this.#face.setAttribute("aria-label", t("face.position", { offset }));
  }

  #share(event: { shiftKey: boolean }): number {
    return this.#store.session.fine || event.shiftKey ? FINE : 1;
  }

  #put(side: number, height: number, group: string): void {
    const offset = withinLimit([side, height], this.#store.shot.miscueLimit);
    this.#store.strike({ side: offset[0], height: offset[1] }, t("change.tip"), group);
  }

  #press(event: PointerEvent): void {
    if (event.button !== 0) return;
    this.#face.setPointerCapture(event.pointerId);
    this.#wanted = this.#offset;
    this.#last = { x: event.clientX, y: event.clientY };
    if (this.#share(event) === 1) this.#follow(event);
  }

  #follow(event: PointerEvent): void {
    if (!this.#last) return;
    const box = this.#picture.drawing.getBoundingClientRect();
    const scale = 2.16 / box.width;
    if (this.#share(event) === 1) {
      this.#wanted = {
        side: (event.clientX - box.left - box.width / 2) * scale,
        height: -(event.clientY - box.top - box.height / 2) * scale,
      };
    } else {
      this.#wanted = {
        side: this.#wanted.side + (event.clientX - this.#last.x) * scale * FINE,
        height: this.#wanted.height - (event.clientY - this.#last.y) * scale * FINE,
      };
    }
    this.#last = { x: event.clientX, y: event.clientY };
    this.#put(this.#wanted.side, this.#wanted.height, "face");
  }

  #release(): void {
    this.#context.loop.flush();
    this.#last = null;
    this.#store.settle();
  }

  #key(event: KeyboardEvent): void {
    const by = ARROWS[event.key];
    if (by) {
      const { side, height } = this.#offset;
      const step = STEP * this.#share(event);
      this.#put(side + by[0] * step, height + by[1] * step, "face-keys");
    } else if (event.key === "Home") {
      this.#put(0, 0, "face-keys");
    } else return;
    event.preventDefault();
    event.stopPropagation();
  }
}

function at(circle: SVGCircleElement, side: number, height: number): void {
  circle.setAttribute("cx", String(side));
  circle.setAttribute("cy", String(-height));
}

/** An offset in words, in percent of the ball's radius. */
export function spokenOffset(side: number, height: number): string {
  const part = (value: number, plus: OffsetKey, minus: OffsetKey) => {
    const percent = round(Math.abs(value) * 100, 1);
    return value === 0 ? "" : t(value > 0 ? plus : minus, { percent });
  };
  const [across, up] = [
    part(side, "face.right", "face.left"),
    part(height, "face.follow", "face.draw"),
  ];
  if (across !== "" && up !== "") return t("face.both", { side: across, height: up });
  return across || up || t("face.centre");
}

type OffsetKey = "face.right" | "face.left" | "face.follow" | "face.draw";
