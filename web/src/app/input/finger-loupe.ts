/** The loupe above a finger that rests: it shows what the finger covers, and goes with it. */

import type { Viewer } from "../../viewer/index.ts";

/** Time (ms) that a finger rests before the loupe appears. */
const REST = 350;

/** Movement (CSS pixels) of a finger that rests. */
const STILL = 6;

/** A pointer on the page. */
type Pointed = Pick<PointerEvent, "clientX" | "clientY" | "pointerType">;

interface Place {
  readonly x: number;
  readonly y: number;
}

export class Loupe {
  readonly #viewer: Pick<Viewer, "loupe">;
  /** Where the finger rests; null if no finger is down. */
  #at: Place | null = null;
  #shown = false;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(viewer: Pick<Viewer, "loupe">) {
    this.#viewer = viewer;
  }

  /** A pointer that goes down; only a finger covers what it points at. */
  press({ clientX: x, clientY: y, pointerType }: Pointed): void {
    if (pointerType === "touch") this.#rest({ x, y });
  }

  move({ clientX: x, clientY: y }: Pointed): void {
    if (!this.#at) return;
    if (this.#shown) this.#viewer.loupe({ x, y });
    else if (Math.hypot(x - this.#at.x, y - this.#at.y) > STILL) this.#rest({ x, y });
  }

  release(): void {
    clearTimeout(this.#timer);
    this.#at = null;
    if (!this.#shown) return;
    this.#shown = false;
    this.#viewer.loupe(null);
  }

  #rest(at: Place): void {
    this.#at = at;
    clearTimeout(this.#timer);
    this.#timer = setTimeout(() => {
      this.#shown = true;
      this.#viewer.loupe(at);
    }, REST);
  }
}
