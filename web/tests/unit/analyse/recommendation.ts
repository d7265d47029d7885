/** Recommendations for tests. */

import type { Recommendation } from "../../../src/engine/index.ts";

const chance = (probability: number) => ({ probability, low: probability, high: probability });

export interface Given {
  readonly kept?: number;
  readonly foul?: number;
  readonly ifKept?: number;
  readonly ifMissed?: number;
  readonly spread?: number;
  readonly error?: number;
  readonly more?: Partial<Recommendation>;
}

/** A pot of ball 9 whose chance to win follows from its parts. */
export function pot(given: Given = {}): Recommendation {
  const { kept = 0.8, foul = 0.02, ifKept = 0.7, ifMissed = 0.4, spread = 0.2 } = given;
  return {
    kind: "direct",
    ball: "9",
    pocket: "top-right",
    legs: [
      ["cue", 0],
      ["9", 0],
    ],
    route: null,
    play: { strike: { speed: 2, azimuth: 1, elevation: 0.03, side: 0, height: 0 } },
    win_chance: kept * ifKept + (1 - kept) * ifMissed,
    error: given.error ?? 0.001,
    samples: 400,
    kept: chance(kept),
    foul: chance(foul),
    win_if_kept: ifKept,
    win_if_missed: ifMissed,
    leave: {
      count: 400,
      mean: [0.6, 1.2],
      covariance: [
        [spread ** 2 / 2, 0],
        [0, spread ** 2 / 2],
      ],
      spread,
    },
    ...given.more,
  };
}
