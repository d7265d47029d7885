/** What the present shot would do. */

import { CaromError, type Shot, type Trace } from "../../engine/index.ts";
import { errorText } from "../common/refusals.ts";

/** The simulation of the present shot, or the reason why it cannot be simulated. */
export interface Ghost {
  readonly trace: Trace | null;
  readonly error: string | null;
  /** How long the engine took, ms. */
  readonly milliseconds: number;
}

export function simulate(shot: Shot): Ghost {
  const start = performance.now();
  const took = () => performance.now() - start;
  try {
    return { trace: shot.simulate(), error: null, milliseconds: took() };
  } catch (error) {
    if (!(error instanceof CaromError)) throw error;
    return { trace: null, error: errorText(error, shot.balls), milliseconds: took() };
  }
}
