/** Which impacts of a replay sound when. */

import type { Impact } from "./impacts.ts";

/** Seconds of wall time that are scheduled ahead: some pictures, also on a slow machine. */
const AHEAD = 0.25;

/** A moment of a running replay. */
export interface Moment {
  /** Of the shot, s. */
  readonly time: number;
  /** Seconds of the shot per second of wall time. */
  readonly rate: number;
}

/** Hands out every impact of a replay once, shortly before it is due. */
export class Schedule {
  readonly #impacts: readonly Impact[];
  #next: number;
  #last: number;

  /** @param from Time of the shot (s) from which it is heard. */
  constructor(impacts: readonly Impact[], from: number) {
    this.#impacts = impacts;
    const next = impacts.findIndex(({ time }) => time >= from);
    this.#next = next < 0 ? impacts.length : next;
    this.#last = from;
  }

  /** Whether a replay at this time (s) goes on from the last call, or has jumped. */
  follows(time: number): boolean {
    return time >= this.#last && time - this.#last < 2 * AHEAD;
  }

  /** The impacts that became due, each with its delay in s of wall time. */
  due({ time, rate }: Moment): { readonly impact: Impact; readonly delay: number }[] {
    this.#last = time;
    const found = [];
    while (this.#next < this.#impacts.length) {
      const impact = this.#impacts[this.#next]!;
      const delay = (impact.time - time) / rate;
      if (delay > AHEAD) break;
      found.push({ impact, delay: Math.max(0, delay) });
      this.#next += 1;
    }
    return found;
  }
}
