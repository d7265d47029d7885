/** Whether a finger that turns the cue aims finely: until it moves fast, and again after it was slow for a while. */

/** Speed (CSS pixels per second) from which a finger means a wide turn: a slow drag has 20 to 80. */
const FAST = 120;

/** Time (ms) over which the speed is averaged: a single event may be a pixel and a few milliseconds. */
const AVERAGE = 80;

/** Time (ms) that a finger has to be slow, or to rest, before it aims finely again. */
const SLOW = 350;

type Moved = Pick<PointerEvent, "clientX" | "clientY" | "timeStamp">;

export class FingerPace {
  #last: Moved;
  /** Averaged speed, CSS pixels per second. */
  #speed = 0;
  /** Since when the finger is slow, ms; null: it is fast. */
  #slowSince: number | null;
  #isFine = true;

  constructor(press: Moved) {
    this.#last = press;
    this.#slowSince = press.timeStamp;
  }

  /** Takes a move of the finger. @returns Whether it turns the cue finely. */
  follow(event: Moved): boolean {
    const before = this.#last;
    const elapsed = Math.max(1, event.timeStamp - before.timeStamp);
    const way = Math.hypot(event.clientX - before.clientX, event.clientY - before.clientY);
    this.#speed += ((1000 * way) / elapsed - this.#speed) * (1 - Math.exp(-elapsed / AVERAGE));
    this.#last = event;
    if (this.#speed > FAST) {
      this.#slowSince = null;
      this.#isFine = false;
    } else {
      this.#slowSince ??= before.timeStamp;
      if (event.timeStamp - this.#slowSince > SLOW) this.#isFine = true;
    }
    return this.#isFine;
  }
}
