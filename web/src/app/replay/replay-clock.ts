/** The time of the replay, independent of the frame rate. */

/** Speeds of the replay: seconds of the shot per second of wall time. */
export const RATES = [4, 2, 1, 0.5, 0.25, 0.1] as const;

/**
 * The longest wall time (s) that one frame may advance. After the page was paused (another tab in front,
 * a computer that slept) the replay continues where it was instead of jumping to its end.
 */
export const LONGEST_FRAME = 0.25;

/** How long the stroke of the cue is shown before it strikes the ball, s of wall time. */
export const STROKE = 0.45;
/** Share of the stroke in which the cue is drawn back, and by how much (m). */
const BACKWARDS = 0.5;
const BACKSWING = 0.05;

/**
 * Distance of the tip from the ball (m) during the stroke: first back, then forwards ever faster.
 *
 * @param left Time until the strike, s.
 * @param start Distance at which the stroke begins, m.
 */
export function strokePull(left: number, start: number): number {
  const gone = 1 - left / STROKE;
  if (gone < BACKWARDS) {
    return start + (BACKSWING * (1 - Math.cos((Math.PI * gone) / BACKWARDS))) / 2;
  }
  const share = (gone - BACKWARDS) / (1 - BACKWARDS);
  return (start + BACKSWING) * (1 - share ** 2);
}

/**
 * The time of the shot (s) when `elapsed` seconds of wall time have passed since `time`, at `rate`; at
 * most `duration`.
 */
export function advance(time: number, elapsed: number, rate: number, duration: number): number {
  return Math.min(time + Math.min(Math.max(elapsed, 0), LONGEST_FRAME) * rate, duration);
}

/**
 * Pictures per update of the text and numbers beside a replay. Sixty updates a second cannot be read,
 * and slow machines save the time.
 */
export const PICTURES_PER_READING = 6;

/** Decides when the text is updated. */
export class Pace {
  #pictures = 0;

  /** Call once per picture of a running replay. */
  due(): boolean {
    this.#pictures = (this.#pictures + 1) % PICTURES_PER_READING;
    return this.#pictures === 0;
  }
}
