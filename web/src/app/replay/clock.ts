// The time of the replay, independent of how often the page is drawn.

/** Seconds of the shot per second of the wall, as the page offers them. */
export const RATES = [1, 0.5, 0.25, 0.1] as const;

/**
 * The longest wall time (s) that one frame may stand for: after a pause of the page (another tab
 * in front, a laptop that slept) the replay goes on where it was, and does not jump to its end.
 */
export const LONGEST_FRAME = 0.25;

/**
 * The time of the shot (s) after `elapsed` seconds of the wall, from `time`, at `rate`; not past
 * `duration`.
 */
export function advance(time: number, elapsed: number, rate: number, duration: number): number {
  return Math.min(time + Math.min(Math.max(elapsed, 0), LONGEST_FRAME) * rate, duration);
}

/**
 * Pictures for each new set of words and numbers beside a replay: at sixty pictures a second nobody
 * reads faster, and where pictures are slow, words are the first to wait.
 */
export const PICTURES_PER_READING = 6;

/** Says when it is time for new words. */
export class Pace {
  #pictures = 0;

  /** Called once for every picture of a replay that plays on. */
  due(): boolean {
    this.#pictures = (this.#pictures + 1) % PICTURES_PER_READING;
    return this.#pictures === 0;
  }
}
