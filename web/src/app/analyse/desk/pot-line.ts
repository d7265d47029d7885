/** The line on which a ball falls into one of some pockets. */

import type { Engine } from "../../../engine/index.ts";
import type { Parts, PotJob } from "./desk-protocol.ts";

/** A step for each pocket, up to the first with a line. */
export function* pot(engine: Engine, job: PotJob): Generator<Parts["pot"] | null> {
  const shot = engine.shot(job.shot);
  try {
    for (const pocket of job.pockets) {
      const aim = shot.potAim(job.ball, pocket);
      if (aim) {
        yield { found: { pocket, aim } };
        return;
      }
      yield null;
    }
    yield { found: null };
  } finally {
    shot.free();
  }
}
