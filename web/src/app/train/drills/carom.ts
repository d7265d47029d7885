/** The drills on a carom table. */

import type { Drill } from "./drill.ts";

export const CAROM_DRILLS: readonly Drill[] = [
  {
    id: "cushions",
    table: "carom-10ft",
    cue: "white",
    attempts: 10,
    order: "same",
    speed: 3.5,
    steps: [
      {
        balls: { white: [1, 2], red: [2.6, 6.2], yellow: [0.5, 0.6] },
        goal: { kind: "shot", needs: [{ kind: "carom", cushions: 3 }] },
      },
    ],
  },
];
