/** The strike that keeps a pot and stops the cue ball at a place. */

import type { Engine } from "../../../engine/index.ts";
import type { LeaveJob, Parts } from "./desk-protocol.ts";

export function* leave(engine: Engine, job: LeaveJob): Generator<Parts["leave"]> {
  const shot = engine.shot(job.shot);
  try {
    yield { aim: shot.leaveAim(job.ball, job.pocket, job.place, { noise: job.noise }) };
  } finally {
    shot.free();
  }
}
