/** The drills on a snooker table. */

import type { Drill } from "./drill.ts";

const SNOOKER = { table: "snooker-12ft", cue: "cue", order: "same" } as const;

export const SNOOKER_DRILLS: readonly Drill[] = [
  {
    id: "long",
    ...SNOOKER,
    attempts: 10,
    speed: 2.4,
    steps: [
      {
        balls: { cue: [1.7, 1.4], red: [3.1, 6.1] },
        hand: { marking: "d" },
        goal: { kind: "shot", needs: [{ kind: "pot", ball: "red", pocket: "top-right" }] },
      },
    ],
  },
  {
    id: "colours",
    ...SNOOKER,
    attempts: 3,
    speed: 1.4,
    steps: [
      {
        balls: {
          cue: [2.2, 2.6],
          yellow: { spot: "yellow" },
          green: { spot: "green" },
          brown: { spot: "brown" },
          blue: { spot: "blue" },
          pink: { spot: "pink" },
          black: { spot: "black" },
        },
        hand: { from: [0, 0], to: [4, 8] },
        goal: {
          kind: "run",
          balls: ["yellow", "green", "brown", "blue", "pink", "black"],
          order: "sequence",
        },
      },
    ],
  },
];
