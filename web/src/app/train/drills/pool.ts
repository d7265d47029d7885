/** The drills on a nine-foot pool table. */

import type { Condition, Diamonds, Drill, Place, Step } from "./drill.ts";

const POOL = { table: "wpa-9ft", cue: "cue", attempts: 10 } as const;

/** The pot of most drills. */
const CORNER = { ball: "1", pocket: "top-right" } as const;
const POT: Condition = { kind: "pot", ...CORNER };

/** The whole cloth, where a cue ball in hand may lie. */
const ANYWHERE = { from: [0, 0], to: [4, 8] } as const;

/** A pot into the corner, after which the cue ball stops near a place. */
function potAndStop(ball: Diamonds, cue: Place, center: Place, radius: number): Step {
  return {
    balls: { cue, "1": ball },
    goal: { kind: "shot", needs: [POT, { kind: "stop", area: { center, radius } }] },
  };
}

const pot = (ball: Place, cue: Place): Step => ({
  balls: { cue, "1": ball },
  goal: { kind: "shot", needs: [POT] },
});

export const POOL_DRILLS: readonly Drill[] = [
  {
    id: "stop",
    ...POOL,
    order: "ladder",
    speed: 1.8,
    steps: [1, 1.5, 2, 2.5, 3, 3.5].map((back) =>
      potAndStop([3, 7], { ...CORNER, back }, { ...CORNER, back: 0 }, 0.16),
    ),
  },
  {
    id: "stun",
    ...POOL,
    order: "same",
    speed: 2,
    steps: [
      {
        balls: { cue: { ...CORNER, back: 1.6, cut_deg: 35 }, "1": [3, 6.5] },
        goal: {
          kind: "shot",
          needs: [POT],
          zones: [
            { area: { center: [1.7, 7.1], radius: 0.4 }, points: 3 },
            { area: { center: [1.7, 7.1], radius: 0.8 }, points: 2 },
            { area: { center: [1.7, 7.1], radius: 1.2 }, points: 1 },
          ],
        },
      },
    ],
  },
  {
    id: "follow",
    ...POOL,
    order: "ladder",
    speed: 1.6,
    steps: [0.6, 1, 1.4, 1.8, 2.2].map((ahead) =>
      potAndStop([2, 5.1], { ...CORNER, back: 1.2 }, { ...CORNER, back: -ahead }, 0.4),
    ),
  },
  {
    id: "draw",
    ...POOL,
    order: "ladder",
    speed: 2.2,
    steps: [0.8, 1.4, 2, 2.6, 3.2].map((back) =>
      potAndStop([3, 6.5], { ...CORNER, back: 1.2 }, { ...CORNER, back }, 0.45),
    ),
  },
  {
    id: "straight",
    ...POOL,
    order: "ladder",
    speed: 2,
    steps: [1, 1.5, 2, 2.5, 3, 3.5, 4].map((far) =>
      // On the diagonal of the table, as far from the pocket as the cue ball from the ball.
      pot([4.1 - 0.452 * far, 8.1 - 0.892 * far], { ...CORNER, back: far }),
    ),
  },
  {
    id: "cuts",
    ...POOL,
    order: "ladder",
    speed: 1.8,
    steps: [15, 25, 35, 45, 55, 65].map((cut) =>
      pot([3, 6.5], { ...CORNER, back: 2, cut_deg: -cut }),
    ),
  },
  {
    id: "thin",
    ...POOL,
    order: "same",
    speed: 2,
    steps: [pot([2.3, 7.1], { ...CORNER, back: 2.4, cut_deg: 72 })],
  },
  {
    id: "spot",
    ...POOL,
    order: "same",
    speed: 2.2,
    steps: [
      {
        balls: { cue: [1.2, 1.8], "1": { spot: "foot" } },
        hand: { from: [0, 0], to: [4, 2] },
        goal: { kind: "shot", needs: [POT] },
      },
    ],
  },
  {
    id: "wheel",
    ...POOL,
    order: "turns",
    speed: 1.8,
    steps: (
      [
        [3.4, 3.1],
        [3.4, 1.6],
        [2.5, 0.7],
        [1.4, 1.6],
        [0.7, 3],
      ] as const
    ).map((center) => ({
      balls: { cue: [1.9, 4.75], "1": [3.2, 4.15] },
      goal: {
        kind: "shot",
        needs: [
          { kind: "pot", ball: "1", pocket: "right" },
          { kind: "stop", area: { center, radius: 0.6 } },
        ],
      },
    })),
  },
  {
    id: "rail",
    ...POOL,
    order: "ladder",
    speed: 1.8,
    steps: (
      [
        [3, 3.6],
        [2.6, 4],
        [2.2, 4.6],
        [1.8, 5.2],
        [1.4, 5.6],
      ] as const
    ).map((cue) => pot({ rail: "right", y: 6 }, cue)),
  },
  {
    id: "lag",
    ...POOL,
    order: "same",
    speed: 1.9,
    steps: [
      {
        balls: { cue: [1, 2] },
        goal: {
          kind: "shot",
          needs: [{ kind: "cushions", ball: "cue", cushions: 1 }],
          zones: [
            { area: { from: [0, 0], to: [4, 0.35] }, points: 3 },
            { area: { from: [0, 0], to: [4, 0.75] }, points: 2 },
            { area: { from: [0, 0], to: [4, 1.25] }, points: 1 },
          ],
        },
      },
    ],
  },
  {
    id: "kick",
    ...POOL,
    order: "same",
    speed: 1.8,
    steps: [
      {
        balls: { cue: [2.6, 0.8], "8": [2.7, 4.2], "9": [2.8, 7.3] },
        goal: {
          kind: "shot",
          needs: [
            { kind: "kick", cushions: 1 },
            { kind: "first", ball: "9" },
          ],
        },
      },
    ],
  },
  {
    id: "bank",
    ...POOL,
    order: "same",
    speed: 2,
    steps: [
      {
        balls: { cue: [1.6, 2], "1": [3, 3] },
        goal: {
          kind: "shot",
          needs: [
            { kind: "cushions", ball: "1", cushions: 1 },
            { kind: "pot", ball: "1", pocket: "left" },
          ],
        },
      },
    ],
  },
  {
    id: "safety",
    ...POOL,
    order: "same",
    speed: 1,
    steps: [
      {
        balls: { cue: [1.2, 4.8], "8": [2, 6.2], "9": [2.5, 5.7] },
        goal: {
          kind: "shot",
          needs: [
            { kind: "first", ball: "9" },
            { kind: "hidden", ball: "9" },
          ],
        },
      },
    ],
  },
  {
    id: "break",
    ...POOL,
    order: "same",
    speed: 9,
    steps: [
      {
        balls: {},
        rack: "nine-ball",
        goal: {
          kind: "shot",
          needs: [{ kind: "first", ball: "1" }, { kind: "pot-any" }],
          zones: [
            { area: { from: [1, 3], to: [3, 5] }, points: 2 },
            { area: ANYWHERE, points: 1 },
          ],
        },
      },
    ],
  },
  {
    id: "three",
    ...POOL,
    attempts: 5,
    order: "same",
    speed: 1.6,
    steps: [
      {
        balls: { cue: [2, 4.6], "1": [3, 6.2], "2": [1, 5.2], "8": [2.6, 2.4] },
        hand: ANYWHERE,
        goal: { kind: "run", balls: ["1", "2", "8"], order: "eight" },
      },
    ],
  },
  {
    id: "ghost",
    ...POOL,
    attempts: 5,
    order: "same",
    speed: 1.6,
    steps: [
      {
        balls: { cue: [1.8, 5.2], "7": [1, 6.5], "8": [3.2, 5], "9": [1.3, 2.2] },
        hand: ANYWHERE,
        goal: { kind: "run", balls: ["7", "8", "9"], order: "rotation" },
      },
    ],
  },
];
