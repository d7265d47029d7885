/** A puzzle as a drill of one step. */

import type { Engine, Puzzle } from "../../../engine/index.ts";
import type { Drill } from "../drills/index.ts";
import { stepOf } from "../drill-file.ts";
import { clothOf } from "../drill-places.ts";

export interface PuzzleTask {
  readonly puzzle: Puzzle;
  /** The day whose puzzle it is, "2026-11-23", UTC; null of another one. */
  readonly date: string | null;
  readonly drill: Drill;
}

export function taskOf(engine: Engine, puzzle: Puzzle, date: string | null): PuzzleTask {
  const { shot, goal, id } = puzzle;
  const table = shot.table as string;
  const step = stepOf(clothOf(engine, table), { balls: shot.balls, goal });
  const speed = shot.strike!.speed;
  const drill: Drill = {
    id,
    table,
    cue: "cue",
    attempts: 1,
    order: "same",
    steps: [step],
    speed,
  };
  return { puzzle, date, drill };
}
