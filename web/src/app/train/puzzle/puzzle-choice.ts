/** Which puzzle comes next. */

import type { ListedPuzzle } from "../../../engine/index.ts";
import { randomOf } from "./seeded-random.ts";

/** "rating": near the player's rating. */
export type Difficulty = "rating" | "easy" | "medium" | "hard";
export const DIFFICULTIES: readonly Difficulty[] = ["rating", "easy", "medium", "hard"];

/** How far a puzzle by rating may be from the player. */
const NEAR = 150;

/** Ratings of medium puzzles: about a third of all. */
const MEDIUM = [1350, 1750] as const;

export function themeOf(id: string): string {
  return id.slice(0, id.lastIndexOf("-"));
}

/** The puzzle of a day, the same on every machine. */
export function puzzleOfDay(puzzles: readonly ListedPuzzle[], date: string): ListedPuzzle {
  const random = randomOf(Number(date.replaceAll("-", "")));
  return puzzles[Math.floor(random() * puzzles.length)]!;
}

/**
 * A puzzle at random: of the theme if one is given, of the difficulty, and not played yet. If there is none,
 * the one nearest to it.
 *
 * @param random Gives numbers in [0, 1).
 */
export function nextPuzzle(
  puzzles: readonly ListedPuzzle[],
  {
    theme,
    difficulty,
    rating,
    played,
  }: {
    readonly theme: string | null;
    readonly difficulty: Difficulty;
    readonly rating: number;
    readonly played: ReadonlySet<string>;
  },
  random: () => number,
): ListedPuzzle {
  const ofTheme = puzzles.filter(([id]) => theme === null || themeOf(id) === theme);
  const open = ofTheme.filter(([id]) => !played.has(id));
  // Someone who has played all of a theme plays them again.
  const list = open.length > 0 ? open : ofTheme;
  const off = (one: ListedPuzzle) => outside(one[1], difficulty, rating);
  const least = Math.min(...list.map(off));
  const nearest = list.filter((one) => off(one) === least);
  return nearest[Math.floor(random() * nearest.length)]!;
}

/** How far a rating is outside a difficulty. */
function outside(rating: number, difficulty: Difficulty, player: number): number {
  switch (difficulty) {
    case "rating":
      return Math.max(0, Math.abs(rating - player) - NEAR);
    case "easy":
      return Math.max(0, rating - MEDIUM[0]);
    case "medium":
      return Math.max(0, MEDIUM[0] - rating, rating - MEDIUM[1]);
    case "hard":
      return Math.max(0, MEDIUM[1] - rating);
  }
}
