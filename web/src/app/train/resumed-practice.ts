/** What a reload or the browser's storage has kept of a drill, with the drill that its names stand for. */

import { CaromError, type Engine } from "../../engine/index.ts";
import { drillOfFile } from "./drill-file.ts";
import { drillOf } from "./drills/index.ts";
import type { KeptPractice, Running } from "./practice-state.ts";
import { taskOf } from "./puzzle/puzzle-task.ts";

/** Null if this version of the page does not have the drill or the puzzle. */
export function resumed(engine: Engine, kept: KeptPractice["running"]): Running | null {
  const { own, puzzle: named, ...running } = kept;
  try {
    // Older versions kept another kind of puzzle.
    if (named && typeof named.id !== "string") return null;
    const puzzle = named && taskOf(engine, engine.puzzle(named.id), named.date);
    const drill =
      puzzle?.drill ?? (own ? drillOfFile(engine, engine.drill(own)) : drillOf(kept.drill));
    return drill
      ? { ...running, hints: running.hints ?? 0, seen: running.seen ?? false, puzzle, drill }
      : null;
  } catch (error) {
    if (error instanceof CaromError) return null;
    throw error;
  }
}
