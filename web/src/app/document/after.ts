/** The balls at the end of a shot, as a new layout. */

import {
  CaromError,
  type BallEntry,
  type Engine,
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

/** Ends of shots; a tree asks for the same ones again and again. */
const ends = new WeakMap<AimedShot, readonly BallEntry[] | null>();

/** What the engine does for trees. */
export function treeEngine(engine: Engine): TreeEngine {
  return {
    check: (shot) => engine.shot(shot).free(),
    endOf: (shot) => {
      let end = ends.get(shot);
      if (end === undefined) ends.set(shot, (end = endOf(engine, shot)));
      return end;
    },
  };
}

function endOf(engine: Engine, file: AimedShot): readonly BallEntry[] | null {
  try {
    const shot = engine.shot(file);
    const trace = shot.simulate();
    const balls = ballsAfter(trace, file);
    trace.free();
    shot.free();
    return balls.length > 0 ? balls : null;
  } catch (error) {
    if (error instanceof CaromError) return null;
    throw error;
  }
}
