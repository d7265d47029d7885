/** Counts of the variants received so far. */

import type { Refusal } from "../../engine/index.ts";
import { OFF_TABLE } from "../../engine/types.ts";
import type { Chunk } from "./variants-protocol.ts";
import { type Chance, chance } from "./chance-statistics.ts";

/** Counts over the variants of one request, and the final position of the struck ball in each. */
export class Tally {
  /** Balls of the shot. */
  readonly balls: number;
  /** Requested variants. */
  readonly total: number;
  /** Received variants. */
  count = 0;
  /** Variants that could not be played, for instance because of a miscue. */
  failed = 0;
  /** Final x and y, m, of the struck ball in the variants that could be played. */
  readonly ends: Float64Array;
  /** The engine's refusal of the first failed variant. */
  reason: Refusal | null = null;
  readonly #pocketed: Uint32Array;
  readonly #off: Uint32Array;
  #played = 0;

  constructor(balls: number, total: number) {
    this.balls = balls;
    this.total = total;
    this.ends = new Float64Array(2 * total);
    this.#pocketed = new Uint32Array(balls);
    this.#off = new Uint32Array(balls);
  }

  /** Counts a chunk. */
  add(chunk: Chunk): void {
    this.count += chunk.count;
    this.failed += chunk.refusals.size;
    for (const reason of chunk.refusals.values()) this.reason ??= reason;
    for (let i = 0; i < chunk.pockets.length; i++) {
      const pocket = chunk.pockets[i]!;
      if (pocket >= 0) this.#pocketed[i % this.balls]!++;
      else if (pocket === OFF_TABLE) this.#off[i % this.balls]!++;
    }
    for (let i = 0; i < chunk.count; i++) {
      const x = chunk.ends[2 * i]!;
      if (Number.isNaN(x)) continue;
      this.ends.set([x, chunk.ends[2 * i + 1]!], 2 * this.#played++);
    }
  }

  /** The final positions received so far. */
  played(): Float64Array {
    return this.ends.subarray(0, 2 * this.#played);
  }

  /** The chance that a ball is pocketed. In a failed variant it is not. */
  pocketed(ball: number): Chance {
    return chance(this.#pocketed[ball]!, this.count);
  }

  /** The chance that a ball leaves the table. */
  off(ball: number): Chance {
    return chance(this.#off[ball]!, this.count);
  }
}
