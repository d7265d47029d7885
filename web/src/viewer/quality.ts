/** Lowers and raises the viewer's quality by how long its frames take. */

/** What the renderer spends. */
export interface Level {
  /** Pixels drawn per pixel of the page, at most; never more than the screen has. */
  pixelRatio: number;
  shadows: boolean;
  /** Detail of balls. */
  detail: "high" | "low";
}

/** From the most beautiful to the fastest that is still pleasant. */
export const LEVELS: readonly Level[] = [
  { pixelRatio: 2, shadows: true, detail: "high" },
  { pixelRatio: 1.5, shadows: true, detail: "high" },
  { pixelRatio: 1, shadows: false, detail: "high" },
  { pixelRatio: 0.8, shadows: false, detail: "low" },
  { pixelRatio: 0.66, shadows: false, detail: "low" },
];
/** What a picture costs that will stand: full quality, whatever motion can afford. */
export const STILL: Level = { pixelRatio: 2, shadows: true, detail: "high" };
/** Where low quality begins: software rendering starts here. */
export const LOW = 2;

/** Frames whose median is judged. */
const WINDOW = 16;
/** Median time between frames, ms, above which quality falls, and below which it may rise. */
const SLOW = 42;
const FAST = 19;
/** Windows that must be fast before quality rises; doubled each time that it had to fall again. */
const PATIENCE = 4;

/** Judges frames and decides on a level; has no clock of its own. */
export class Governor {
  #level: number;
  readonly #times: number[] = [];
  #last = NaN;
  #fast = 0;
  #patience = PATIENCE;
  #raised = false;
  #median = 0;

  constructor(level: number) {
    this.#level = level;
  }

  /** Index into `LEVELS`. */
  get level(): number {
    return this.#level;
  }

  /** Median time between the frames of the last window, ms; 0 before there was one. */
  get frameMs(): number {
    return this.#median;
  }

  /**
   * A frame begins.
   *
   * @param now - Time, ms.
   * @param follows - Whether it is the screen's next frame after the last one that was drawn: else
   * the time between tells nothing about the renderer.
   * @returns Whether the level has changed.
   */
  frame(now: number, follows: boolean): boolean {
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
      // It was better before: be slower to try again.
      if (this.#raised) this.#patience *= 2;
      this.#raised = false;
      this.#level += 1;
      return true;
    }
    this.#fast = this.#median < FAST ? this.#fast + 1 : 0;
    if (this.#fast < this.#patience || this.#level === 0) return false;
    this.#fast = 0;
    this.#raised = true;
    this.#level -= 1;
    return true;
  }
}

/** Whether WebGL is drawn by the processor, as in virtual machines and in tests. */
export function isSoftware(): boolean {
  const context = document.createElement("canvas").getContext("webgl2");
  if (!context) return false;
  const names = context.getExtension("WEBGL_debug_renderer_info");
  const name = String(
    context.getParameter(names ? names.UNMASKED_RENDERER_WEBGL : context.RENDERER),
  );
  context.getExtension("WEBGL_lose_context")?.loseContext();
  return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}
