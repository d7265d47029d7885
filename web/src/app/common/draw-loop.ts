/**
 * Requests all animation frames of the page. The pointer events of one frame become one change of the
 * state and one picture; without a change nothing is drawn.
 */

/**
 * Called in every frame until it returns false.
 *
 * @param elapsed Wall time since the previous frame, s; 0 in the first frame after a pause.
 * @returns Whether to call it again in the next frame.
 */
export type Tick = (elapsed: number) => boolean;

export class DrawLoop {
  readonly #draw: () => boolean;
  readonly #request: (callback: FrameRequestCallback) => number;
  readonly #inputs = new Map<unknown, () => void>();
  readonly #ticks = new Set<Tick>();
  #pending = false;
  #last: number | null = null;

  /**
   * @param draw Draws the picture; returns whether another frame is needed (the camera moves).
   * @param request `requestAnimationFrame`, or a replacement in tests.
   */
  constructor(
    draw: () => boolean,
    request: (callback: FrameRequestCallback) => number = (callback) =>
      requestAnimationFrame(callback),
  ) {
    this.#draw = draw;
    this.#request = request;
  }

  /** Requests a picture in the next frame. */
  invalidate(): void {
    if (this.#pending) return;
    this.#pending = true;
    this.#request((now) => {
      this.#drawNow(now);
    });
  }

  /** Runs `handle` in the next frame before drawing. A later handle with the same key replaces it. */
  input(key: unknown, handle: () => void): void {
    this.#inputs.set(key, handle);
    this.invalidate();
  }

  /**
   * Runs the waiting handles now, and those that they add. Called when a gesture ends, so that its
   * last move is not lost.
   */
  flush(): void {
    while (this.#inputs.size > 0) {
      const handles = [...this.#inputs.values()];
      this.#inputs.clear();
      for (const handle of handles) handle();
    }
  }

  /** Calls `tick` every frame until it returns false. */
  animate(tick: Tick): void {
    this.#ticks.add(tick);
    this.invalidate();
  }

  #drawNow(now: number): void {
    const elapsed = this.#last === null ? 0 : (now - this.#last) / 1000;
    // `#pending` stays true until the picture is drawn: changes requested now need no other frame.
    this.flush();
    for (const tick of [...this.#ticks]) if (!tick(elapsed)) this.#ticks.delete(tick);
    this.flush();
    const more = this.#draw() || this.#ticks.size > 0;
    this.#pending = false;
    this.#last = more ? now : null;
    if (more) this.invalidate();
  }
}
