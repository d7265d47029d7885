/** A progress with something of every kind. */

import type { DrillFile } from "../../../src/engine/index.ts";
import type { Progress, Result } from "../../../src/app/train/progress/practice-progress.ts";

/** The engine of a file. */
export const ENGINE = "carom 0.0.1";

export const result = (day: number, points: readonly number[], drill = "stop"): Result => ({
  drill,
  ended: `2026-11-${String(day).padStart(2, "0")}T10:00:00.000Z`,
  place: "table",
  points,
  errors: null,
});
export const solved = (date: string, tries = 1) => ({ date, tries, solved: true });
export const drill = (name: string, attempts = 10): DrillFile => ({
  format: "carom-drill/1",
  name,
  table: "wpa-9ft",
  attempts,
  steps: [],
});
export const SOME: Progress = {
  results: [result(3, [1, 0, 2]), result(5, [1, 2, 3])],
  puzzles: [solved("2026-11-03", 2), { date: "2026-11-04", tries: 3, solved: false }],
  attempts: [{ puzzle: "cut-17", time: "2026-11-03T10:00:00.000Z", made: true, rating: 1480 }],
  drills: [drill("Long straight")],
};
