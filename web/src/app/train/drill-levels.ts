/** What each level of play makes of a drill: simulated beforehand by scripts/drill_levels.js. */

import type { Drill } from "./drills/index.ts";
import stored from "./drill-levels.json";
import { type Chances, distribution, mean } from "./drill-score.ts";

export interface DrillLevels {
  /** Of the drill and the engine that were simulated. */
  readonly fingerprint: string;
  /** By level, from beginner to professional. */
  readonly chances: Readonly<Record<string, Chances>>;
}

/** A level of play in a drill. */
export interface LevelScore {
  readonly level: string;
  /** Mean score. */
  readonly mean: number;
  /** Four of five scores are between these. */
  readonly low: number;
  readonly high: number;
}

const known = new Map<string, readonly LevelScore[]>();

/** The scores of the levels, from beginner to professional. */
export function levelScores(drill: Drill): readonly LevelScore[] {
  let scores = known.get(drill.id);
  if (!scores) {
    const levels = (stored.drills as unknown as Readonly<Record<string, DrillLevels>>)[drill.id];
    scores = Object.entries(levels?.chances ?? {}).map(([level, chances]) => {
      const shares = distribution(drill, chances);
      return { level, mean: mean(shares), low: quantile(shares, 0.1), high: quantile(shares, 0.9) };
    });
    known.set(drill.id, scores);
  }
  return scores;
}

/** The level whose mean score is nearest; null for a drill that was not simulated. */
export function nearestLevel(drill: Drill, score: number): string | null {
  let nearest: LevelScore | null = null;
  for (const one of levelScores(drill)) {
    const closer = !nearest || Math.abs(one.mean - score) < Math.abs(nearest.mean - score);
    if (closer) nearest = one;
  }
  return nearest?.level ?? null;
}

/** The least score that is reached or not exceeded with the chance `share`. */
function quantile(shares: readonly number[], share: number): number {
  let sum = 0;
  const score = shares.findIndex((chance) => (sum += chance) >= share - 1e-9);
  return score < 0 ? shares.length - 1 : score;
}
