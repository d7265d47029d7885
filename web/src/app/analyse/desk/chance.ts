/** How often a strike with the errors of a player does what it is meant to do. */

import type { Engine } from "../../../engine/index.ts";
import { ON_TABLE } from "../../../engine/types.ts";
import type { ChanceJob, ChancePart } from "./desk-protocol.ts";

/** Variants of a step: some milliseconds. */
const STEP = 50;

export function* chance(engine: Engine, job: ChanceJob): Generator<ChancePart> {
  const { count } = job;
  const part = counter(engine, job);
  try {
    let met = 0;
    for (let first = 0; first < count; first += STEP) {
      const n = Math.min(STEP, count - first);
      met += part.count(n, first);
      yield { met, count: first + n };
    }
  } finally {
    part.free();
  }
}

interface Counter {
  /** The variants `first … first + n − 1` that do it. */
  count(n: number, first: number): number;
  free(): void;
}

function counter(engine: Engine, { of, noise }: ChanceJob): Counter {
  if ("record" in of) {
    const frame = engine.replay(of.record);
    const { request } = frame.state;
    const seat = request.kind === "over" ? -1 : request.player;
    return {
      count: (n, first) => {
        const { player, winner } = frame.successors(of.play, noise, n, { first });
        return player.filter((next, k) => next === seat || winner[k] === seat).length;
      },
      free: () => frame.free(),
    };
  }
  const shot = engine.shot(of.shot);
  const ball = shot.balls.findIndex(({ id }) => id === of.ball);
  const pocket = shot.geometry.pockets.findIndex(({ name }) => name === of.pocket);
  const struck = shot.struck!;
  return {
    count: (n, first) => {
      const { balls, pocket: ends } = shot.vary(noise, n, { first });
      let met = 0;
      for (let k = 0; k < n; k++) {
        if (ends[k * balls + ball] === pocket && ends[k * balls + struck] === ON_TABLE) met++;
      }
      return met;
    },
    free: () => shot.free(),
  };
}
