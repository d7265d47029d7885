/** The balls at the end of a shot, as a new layout. */

import {
  CaromError,
  type BallEntry,
  type Engine,
  type Outcome,
  type ShotFile,
  type Trace,
} from "../../engine/index.ts";
import { STRIDE } from "../../engine/types.ts";
import type { AimedShot } from "./aimed-shot.ts";
import type { TreeEngine } from "./tree-text.ts";

/** The balls that are left on the table at the end of a trace, with the masses and radii of their file. */
export function ballsAfter(trace: Trace, file: Pick<ShotFile, "balls">): readonly BallEntry[] {
  const { pocketed, off_table: off } = trace.outcome;
  const gone = new Set([...off, ...pocketed.map(([ball]) => ball)]);
  const entries = new Map(file.balls.map((ball) => [ball.id, ball]));
  const ends = trace.statesAt(trace.duration);
  return trace.shot.balls.flatMap(({ id }, index): BallEntry[] => {
    if (gone.has(id)) return [];
    const { mass, radius } = entries.get(id) ?? {};
    const position = [ends[index * STRIDE]!, ends[index * STRIDE + 1]!] as const;
    return [{ id, position, ...(mass && { mass }), ...(radius && { radius }) }];
  });
}

/** What a shot does. */
interface Result {
  readonly outcome: Outcome;
  /** The balls at the end; null if none is left. */
  readonly end: readonly BallEntry[] | null;
}

/** Results of shots, null for those that cannot be simulated; a tree asks for them again and again. */
const results = new WeakMap<AimedShot, Result | null>();

/** What the engine does for trees. */
export function treeEngine(engine: Engine): TreeEngine {
  return {
    check: (shot) => engine.shot(shot).free(),
    endOf: (shot) => resultOf(engine, shot)?.end ?? null,
  };
}

/** The outcome of a shot; null if it cannot be simulated. */
export function outcomeOf(engine: Engine, shot: AimedShot): Outcome | null {
  return resultOf(engine, shot)?.outcome ?? null;
}

function resultOf(engine: Engine, shot: AimedShot): Result | null {
  let result = results.get(shot);
  if (result === undefined) results.set(shot, (result = simulated(engine, shot)));
  return result;
}

function simulated(engine: Engine, file: AimedShot): Result | null {
  try {
    const shot = engine.shot(file);
    const trace = shot.simulate();
    const { outcome } = trace;
    const balls = ballsAfter(trace, file);
    trace.free();
    shot.free();
    return { outcome, end: balls.length > 0 ? balls : null };
  } catch (error) {
    if (error instanceof CaromError) return null;
    throw error;
  }
}
