/** Shows a photo that can be enlarged, and reports where it is touched. */

import type { Point } from "../../engine/index.ts";
import { element } from "./element.ts";

/** What happens to a pointer on the photo. Places are pixels of the photo. */
export interface PointerActions {
  /** @param isFinger - Whether a finger covers the place. */
  start(pixel: Point, isFinger: boolean): void;
  move(pixel: Point): void;
  end(): void;
  /** A second finger came, or the system took the pointer: nothing was meant. */
  cancel(): void;
}

/** The photo is enlarged at most this many times beyond the whole. */
const LARGEST = 12;
/** Enlargement per unit of a wheel's turn. */
const WHEEL = 0.0015;

export class Stage {
  readonly root: HTMLElement;
  readonly canvas: HTMLCanvasElement;
  readonly #actions: PointerActions;
  readonly #changed: () => void;
  readonly #pointers = new Map<number, Point>();
  #photo: HTMLCanvasElement | null = null;
  /** CSS pixels per pixel of the photo, as a multiple of the whole photo's. */
  #zoom = 1;
  /** The pixel in the middle of the stage. */
  #middle: Point = [0, 0];
  #pointing: number | null = null;

  /** @param changed - Called when the shown part changes. */
  constructor(label: string, actions: PointerActions, changed: () => void) {
    this.canvas = element("canvas", { tabindex: 0, role: "application", "aria-label": label });
    this.root = element("div", { class: "photo-stage" }, this.canvas);
    this.#actions = actions;
    this.#changed = changed;
    this.#listen();
  }

  show(photo: HTMLCanvasElement): void {
    this.#photo = photo;
    this.#zoom = 1;
    this.#middle = [photo.width / 2, photo.height / 2];
    this.#changed();
  }

  /** CSS pixels per pixel of the photo. */
  get scale(): number {
    const { clientWidth, clientHeight } = this.root;
    if (!this.#photo) return 1;
    const { width, height } = this.#photo;
    return this.#zoom * Math.min(clientWidth / width, clientHeight / height);
  }

  /** The place of a pixel of the photo on the stage, CSS pixels. */
  place([x, y]: Point): Point {
    const { clientWidth, clientHeight } = this.root;
    const [u, v] = this.#middle;
    return [clientWidth / 2 + this.scale * (x - u), clientHeight / 2 + this.scale * (y - v)];
  }

  /** Draws the photo; the context is then in CSS pixels. */
  draw(): CanvasRenderingContext2D | null {
    const context = this.canvas.getContext("2d");
    const { clientWidth: width, clientHeight: height } = this.root;
    if (!context || !this.#photo || width === 0 || height === 0) return null;
    const ratio = devicePixelRatio;
    this.canvas.width = Math.round(width * ratio);
    this.canvas.height = Math.round(height * ratio);
    const [left, top] = this.place([0, 0]);
    context.setTransform(ratio, 0, 0, ratio, 0, 0);
    context.imageSmoothingQuality = "high";
    const size = [this.scale * this.#photo.width, this.scale * this.#photo.height] as const;
    context.drawImage(this.#photo, left, top, ...size);
    return context;
  }

  /** Multiplies the enlargement; the pixel at a place of the stage (CSS pixels) stays there. */
  enlarge(by: number, at: Point): void {
    if (!this.#photo) return;
    const pixel = this.#pixel(at);
    this.#zoom = Math.max(1, Math.min(LARGEST, this.#zoom * by));
    const { clientWidth, clientHeight } = this.root;
    this.#look([
      pixel[0] - (at[0] - clientWidth / 2) / this.scale,
      pixel[1] - (at[1] - clientHeight / 2) / this.scale,
    ]);
  }

  /** Shows a pixel in the middle, as far as the photo reaches. */
  #look(middle: Point): void {
    const { clientWidth, clientHeight } = this.root;
    const sides = [this.#photo!.width, this.#photo!.height] as const;
    const half = [clientWidth / 2 / this.scale, clientHeight / 2 / this.scale] as const;
    const clamp = (axis: 0 | 1) =>
      2 * half[axis] >= sides[axis]
        ? sides[axis] / 2
        : Math.max(half[axis], Math.min(sides[axis] - half[axis], middle[axis]));
    this.#middle = [clamp(0), clamp(1)];
    this.#changed();
  }

  #pixel([x, y]: Point): Point {
    const { clientWidth, clientHeight } = this.root;
    const [u, v] = this.#middle;
    return [u + (x - clientWidth / 2) / this.scale, v + (y - clientHeight / 2) / this.scale];
  }

  #at(event: MouseEvent): Point {
    const { left, top } = this.root.getBoundingClientRect();
    return [event.clientX - left, event.clientY - top];
  }

  #listen(): void {
    const { canvas } = this;
    canvas.addEventListener("pointerdown", (event) => {
      if (!this.#photo || event.button !== 0) return;
      canvas.setPointerCapture(event.pointerId);
      this.#pointers.set(event.pointerId, this.#at(event));
      if (this.#pointers.size === 1) {
        this.#pointing = event.pointerId;
        this.#actions.start(this.#pixel(this.#at(event)), event.pointerType === "touch");
      } else if (this.#pointing !== null) {
        this.#pointing = null;
        this.#actions.cancel();
      }
    });
    canvas.addEventListener("pointermove", (event) => {
      if (!this.#pointers.has(event.pointerId)) return;
      const before = [...this.#pointers.values()];
      this.#pointers.set(event.pointerId, this.#at(event));
      if (event.pointerId === this.#pointing) {
        this.#actions.move(this.#pixel(this.#at(event)));
      } else this.#pinch(before, [...this.#pointers.values()]);
    });
    const end = (event: PointerEvent, act: () => void) => {
      if (!this.#pointers.delete(event.pointerId)) return;
      if (event.pointerId !== this.#pointing) return;
      this.#pointing = null;
      act();
    };
    canvas.addEventListener("pointerup", (event) => {
      end(event, () => this.#actions.end());
    });
    canvas.addEventListener("pointercancel", (event) => {
      end(event, () => this.#actions.cancel());
    });
    canvas.addEventListener(
      "wheel",
      (event) => {
        event.preventDefault();
        this.enlarge(Math.exp(-WHEEL * event.deltaY), this.#at(event));
      },
      { passive: false },
    );
  }

  /** Two fingers enlarge and move the photo. */
  #pinch(before: readonly Point[], now: readonly Point[]): void {
    const [a, b, c, d] = [before[0], before[1], now[0], now[1]];
    if (!a || !b || !c || !d) return;
    const apart = Math.hypot(a[0] - b[0], a[1] - b[1]);
    const middle = [(c[0] + d[0]) / 2, (c[1] + d[1]) / 2] as const;
    const [x, y] = [middle[0] - (a[0] + b[0]) / 2, middle[1] - (a[1] + b[1]) / 2];
    const [u, v] = this.#middle;
    this.#look([u - x / this.scale, v - y / this.scale]);
    if (apart > 0) this.enlarge(Math.hypot(c[0] - d[0], c[1] - d[1]) / apart, middle);
  }
}
