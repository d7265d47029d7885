/** Adapts the viewer's quality to the time that its pictures take. */

/** A level of quality. */
export interface Level {
  /** Most pixels drawn per CSS pixel; never more than the screen has. */
  pixelRatio: number;
  shadows: boolean;
}

/** Levels from the best quality to the fastest. */
export const LEVELS: readonly Level[] = [
  { pixelRatio: 2, shadows: true },
  { pixelRatio: 1.5, shadows: true },
  { pixelRatio: 1, shadows: false },
  { pixelRatio: 0.8, shadows: false },
  { pixelRatio: 0.66, shadows: false },
];
/** Level of a still picture: full quality, whatever the level of moving pictures. */
export const STILL: Level = { pixelRatio: 2, shadows: true };
/** Index of the first low level; software rendering starts with it. */
export const LOW = 2;

/** Number of pictures whose median time decides. */
const WINDOW = 16;
/**
 * Median time between pictures, ms, above which the quality is lowered: 40 pictures per second. Screens with
 * 60 pictures per second show a picture every 17 or 33 ms, so most pictures must be in time.
 */
export const SLOW = 25;
/** Median time between pictures, ms, below which the quality may be raised. */
const FAST = 19;
/** Number of fast windows before the quality is raised; doubled each time it must be lowered again. */
const PATIENCE = 4;

/** Chooses a level from times of pictures that the caller measures. */
export class Governor {
  #level: number;
  readonly #best: number;
  readonly #times: number[] = [];
  #last = NaN;
  #fast = 0;
  #patience = PATIENCE;
  #raised = false;
  #median = 0;

  /**
   * @param level - Where it starts.
   * @param best - The best level that it chooses.
   */
  constructor(level: number, best = 0) {
    this.#level = level;
    this.#best = best;
  }

  /** Index into `LEVELS`. */
  get level(): number {
    return this.#level;
  }

  /** Median time between the pictures of the last window, ms; 0 before the first window. */
  get pictureMs(): number {
    return this.#median;
  }

  /**
   * Records the start of a picture.
   *
   * @param now - Time, ms.
   * @param follows - Whether it directly follows the last drawn picture. After a pause the time between
   * pictures does not measure the renderer.
   * @returns Whether the level has changed.
   */
  pictureAt(now: number, follows: boolean): boolean {
    const time = now - this.#last;
    this.#last = now;
    if (!follows) return false;
    this.#times.push(time);
    if (this.#times.length < WINDOW) return false;
    this.#median = this.#times.sort((a, b) => a - b)[WINDOW / 2]!;
    this.#times.length = 0;
    return this.#judge();
  }

  #judge(): boolean {
    if (this.#median > SLOW) {
      this.#fast = 0;
      if (this.#level === LEVELS.length - 1) return false;
      // The higher level was too slow: wait longer before the next attempt.
      if (this.#raised) this.#patience *= 2;
      this.#raised = false;
      this.#level += 1;
      return true;
    }
    this.#fast = this.#median < FAST ? this.#fast + 1 : 0;
    if (this.#fast < this.#patience || this.#level === this.#best) return false;
    this.#fast = 0;
    this.#raised = true;
    this.#level -= 1;
    return true;
  }
}

/** Whether the processor draws WebGL, as in virtual machines and tests. */
export function isSoftware(): boolean {
  // Browsers that know it refuse this context at once.
  const context = document
    .createElement("canvas")
    .getContext("webgl2", { failIfMajorPerformanceCaveat: true } as WebGLContextAttributes);
  if (!context) return true;
  const names = context.getExtension("WEBGL_debug_renderer_info");
  const name = String(
    context.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : context.RENDERER),
  );
  context.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}
