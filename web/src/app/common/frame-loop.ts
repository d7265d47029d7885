/**
 * The one place that asks for animation frames. Pointer events of a frame become one change, a
 * change becomes one picture, and nothing is drawn while nothing changes.
 */

/**
 * Called every frame while it wants to be.
 *
 * @param elapsed Wall time since the last frame, s; 0 in the first after a pause.
 * @returns Whether it wants another frame.
 */
export type Tick = (elapsed: number) => boolean;

export class FrameLoop {
  readonly #draw: () => boolean;
  readonly #request: (callback: FrameRequestCallback) => number;
  readonly #inputs = new Map<unknown, () => void>();
  readonly #ticks = new Set<Tick>();
  #pending = false;
  #last: number | null = null;

  /**
   * @param draw Draws the picture; returns whether it wants another frame (a camera on its way).
   * @param request `requestAnimationFrame`, or a test's.
   */
  constructor(
    draw: () => boolean,
    request: (callback: FrameRequestCallback) => number = (callback) =>
      requestAnimationFrame(callback),
  ) {
    this.#draw = draw;
    this.#request = request;
  }

  /** Draws in the next frame. */
  invalidate(): void {
    if (this.#pending) return;
    this.#pending = true;
    this.#request((now) => {
      this.#frame(now);
    });
  }

  /** Runs `handle` in the next frame, before drawing; of those with one key only the last. */
  input(key: unknown, handle: () => void): void {
    this.#inputs.set(key, handle);
    this.invalidate();
  }

  /**
   * Runs what waits for the next frame now, and what that asks for: a gesture that ends must not
   * lose its last move.
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

  #frame(now: number): void {
    const elapsed = this.#last === null ? 0 : (now - this.#last) / 1000;
    // Still pending: what this frame's changes ask for is in this frame's picture.
    this.flush();
    for (const tick of [...this.#ticks]) if (!tick(elapsed)) this.#ticks.delete(tick);
    this.flush();
    const more = this.#draw() || this.#ticks.size > 0;
    this.#pending = false;
    this.#last = more ? now : null;
    if (more) this.invalidate();
  }
}
