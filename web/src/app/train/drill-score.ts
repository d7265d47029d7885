/** The score of a drill: points of its attempts, the step of the next one, and the distribution by level. */

import type { Drill } from "./drills/index.ts";
import { mostPoints } from "./drill-judge.ts";

/** Index of the step that the next attempt has, after attempts with these points. */
export function stepAfter(drill: Drill, points: readonly number[]): number {
  if (drill.order === "turns") return points.length % drill.steps.length;
  if (drill.order === "same") return 0;
  return points.reduce((step, gained) => stepOf(drill, step, gained > 0), 0);
}

/** The step of a ladder after an attempt at `step`. */
function stepOf({ steps }: Drill, step: number, made: boolean): number {
  return made ? Math.min(step + 1, steps.length - 1) : Math.max(step - 1, 0);
}

/** Points that the score counts for an attempt at a step: a ladder without points counts the step's number. */
export function counted({ order, steps }: Drill, step: number, points: number): number {
  const { goal } = steps[step]!;
  const counts = order === "ladder" && goal.kind === "shot" && goal.points === undefined;
  return counts && !goal.zones && points > 0 ? step + 1 : points;
}

/** Whether a drill ends after attempts with these points. */
export function isOver({ attempts, misses }: Drill, points: readonly number[]): boolean {
  const missed = points.filter((gained) => gained === 0).length;
  return points.length >= attempts || (misses !== undefined && missed >= misses);
}

export function total(points: readonly number[]): number {
  return points.reduce((sum, one) => sum + one, 0);
}

/** The greatest score. */
export function greatest(drill: Drill): number {
  const points: number[] = [];
  for (let k = 0; k < drill.attempts; k += 1) {
    const step = stepAfter(drill, points);
    points.push(counted(drill, step, mostPoints(drill.steps[step]!)));
  }
  return total(points);
}

/** For every step the chances of 0, 1, 2 … points in an attempt. */
export type Chances = readonly (readonly number[])[];

/** The chance of every score from 0 to the greatest, for a player with these chances in an attempt. */
export function distribution(drill: Drill, chances: Chances): number[] {
  const most = greatest(drill);
  // By step and score so far.
  let states = drill.steps.map(() => new Float64Array(most + 1));
  states[0]![0] = 1;
  for (let attempt = 0; attempt < drill.attempts; attempt += 1) {
    const next = drill.steps.map(() => new Float64Array(most + 1));
    states.forEach((scores, step) => {
      scores.forEach((share, score) => {
        if (share === 0) return;
        chances[step]!.forEach((chance, points) => {
          if (chance === 0) return;
          const to =
            drill.order === "turns"
              ? (step + 1) % drill.steps.length
              : drill.order === "ladder"
                ? stepOf(drill, step, points > 0)
                : 0;
          next[to]![score + counted(drill, step, points)]! += share * chance;
        });
      });
    });
    states = next;
  }
  return Array.from({ length: most + 1 }, (_, score) =>
    states.reduce((sum, scores) => sum + scores[score]!, 0),
  );
}

export function mean(distribution: readonly number[]): number {
  return distribution.reduce((sum, chance, score) => sum + chance * score, 0);
}
