/** The chances of the first player to win in a frame of a match, split into decisions and luck. */

import type { MatchNotes } from "../../document/stored-game.ts";
import { ofFirst } from "./match-game.ts";

/** Width and height of the curve, and the free edge around it, its own units. */
export const WIDTH = 280;
export const HEIGHT = 110;
export const EDGE = 8;

/** A change of the chance between two places of the curve. */
export interface ChanceStep {
  /** Index of the move in the game. */
  readonly index: number;
  /** What changed the chance: the choice of the shot, its luck, or both where they are not measured. */
  readonly by: "decision" | "luck" | "both";
  readonly from: number;
  readonly to: number;
}

/** The steps of the curve in order; none if the record has no chances. */
export function chanceSteps({ moves }: MatchNotes): readonly ChanceStep[] {
  const measured = moves.flatMap(({ seat, index, luck }): ChanceStep[] => {
    if (index === undefined || !luck) return [];
    const [before, expected, after] = luck.map((chance) => ofFirst(seat, chance));
    return [
      { index, by: "decision", from: before!, to: expected! },
      { index, by: "luck", from: expected!, to: after! },
    ];
  });
  if (measured.length > 0) return measured;
  const expected = moves.flatMap(({ seat, index, chance }) =>
    index === undefined || chance === undefined ? [] : [{ index, to: ofFirst(seat, chance) }],
  );
  return expected.map(({ index, to }, k) => ({
    index,
    by: "both",
    from: expected[k - 1]?.to ?? to,
    to,
  }));
}

/** A step as a line of the picture. */
export interface StepLine extends ChanceStep {
  readonly x1: number;
  readonly y1: number;
  readonly x2: number;
  readonly y2: number;
}

/** The steps from left to right, each as wide as the others. */
export function stepLines(steps: readonly ChanceStep[]): readonly StepLine[] {
  const wide = (WIDTH - 2 * EDGE) / Math.max(steps.length, 1);
  const y = (chance: number) => EDGE + (1 - chance) * (HEIGHT - 2 * EDGE);
  return steps.map((step, k) => ({
    ...step,
    x1: EDGE + k * wide,
    y1: y(step.from),
    x2: EDGE + (k + 1) * wide,
    y2: y(step.to),
  }));
}
