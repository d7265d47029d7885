/**
 * The rating of a player of puzzles: Glicko, with each puzzle as a period of its own (M. E. Glickman,
 * "Parameter estimation in large dynamic paired comparison experiments", Applied Statistics 48, 1999,
 * section 3.3, equations 9–12). The difficulty of a puzzle is its opponent's rating.
 */

import type { PuzzleAttempt } from "../progress/practice-progress.ts";

export interface Rating {
  readonly rating: number;
  /** Its standard deviation. */
  readonly deviation: number;
}

/** Of a player without puzzles, as Glickman proposes. */
export const NEW_PLAYER: Rating = { rating: 1500, deviation: 350 };

/** Of a puzzle: about what 240 variants of five levels leave open. */
const PUZZLE_DEVIATION = 60;

/** A player's deviation does not fall below this, so that the rating still follows a player who improves. */
const LEAST_DEVIATION = 60;

const Q = Math.LN10 / 400;

/** The rating after a puzzle of a difficulty that was solved or not. */
export function rated(
  { rating, deviation }: Rating,
  difficulty: number,
  isSolved: boolean,
): Rating {
  const g = 1 / Math.sqrt(1 + (3 * (Q * PUZZLE_DEVIATION) ** 2) / Math.PI ** 2);
  const expected = 1 / (1 + 10 ** ((-g * (rating - difficulty)) / 400));
  const information = Q ** 2 * g ** 2 * expected * (1 - expected);
  const variance = 1 / (1 / deviation ** 2 + information);
  return {
    rating: rating + Q * variance * g * (Number(isSolved) - expected),
    deviation: Math.max(Math.sqrt(variance), LEAST_DEVIATION),
  };
}

/** The rating after these attempts, in the order of time. Only the first one at each puzzle counts. */
export function ratingOf(attempts: readonly PuzzleAttempt[]): Rating {
  return firstAttempts(attempts).reduce(
    (player, { rating, made }) => rated(player, rating, made),
    NEW_PLAYER,
  );
}

/** The first attempt at each puzzle, in the order of time. */
export function firstAttempts(attempts: readonly PuzzleAttempt[]): readonly PuzzleAttempt[] {
  const known = new Set<string>();
  return attempts.filter(({ puzzle }) => !known.has(puzzle) && known.add(puzzle));
}

/** How many of the last puzzles in a row were solved at the first attempt. */
export function solvedInARow(attempts: readonly PuzzleAttempt[]): number {
  const missed = firstAttempts(attempts).findLastIndex(({ made }) => !made);
  return firstAttempts(attempts).length - 1 - missed;
}
