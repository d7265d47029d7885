/** The chances of banks, kicks and pots that the page shows, against further simulated shots. */

import { expect, test } from "vitest";
import { load, type Point, type ShotFile } from "../../../src/engine/index.ts";
import { BUDGETS } from "../../../src/app/analyse/recommendation-search.ts";

const engine = await load();
const noise = engine.noisePresets.club!;

/** Two positions of nine-ball: one with banks, and one whose lowest ball is hidden. */
type Places = Readonly<Record<string, Point>>;
const OPEN: Places = { cue: [0.42, 0.72], 1: [0.35, 1.62], 3: [0.9, 0.9], 9: [0.86, 1.74] };
const HIDDEN: Places = { cue: [0.3, 0.6], 1: [0.95, 1.9], 8: [0.48, 0.93], 9: [0.56, 0.86] };

/** Simulated shots of a chance, and the standard errors within which two counts agree. */
const COUNT = 1000;
const WITHIN = 4;

// Seen: players doubted "Bank 72 %" and "Kick 48 %" at the level of a club.
test.each([
  ["open", OPEN],
  ["hidden", HIDDEN],
] as const)(
  "a chance is the share of simulated shots with the player's errors that keep the turn: %s",
  (_, places) => {
    const file: ShotFile = {
      format: "carom-shot/1",
      table: "wpa-9ft",
      balls: Object.entries(places).map(([id, position]) => ({ id, position })),
      strike: { ball: "cue", speed: 2, azimuth: 1 },
    };
    const frame = engine.frameOf("nine-ball", engine.shot(file));
    const player = engine.player({ noise, simulations: BUDGETS.at(-1)! });
    const { plays } = player.explain(frame, { count: 5 });
    for (const { kind, kept, samples, play, ball } of plays) {
      if (ball === null) continue;
      const { speed, azimuth, elevation, side, height } = play.strike;
      const strike = { ball: "cue", speed, azimuth, elevation, side, height };
      const aimed: ShotFile = { ...file, strike };
      const shot = engine.shot(aimed);
      let met = 0;
      for (let k = 0; k < COUNT; k += 1) {
        const trace = shot.variant(noise, k, { seed: 99 }).simulate();
        const { outcome } = trace;
        const isFoul =
          outcome.first_contact !== "1" ||
          outcome.cue_ball_scratched ||
          outcome.off_table.length > 0;
        if (!isFoul && outcome.pocketed.length > 0) met += 1;
        trace.free();
      }
      shot.free();
      const p = met / COUNT;
      const error = Math.sqrt(Math.max(p * (1 - p), 0.01) * (1 / COUNT + 1 / samples));
      const said = `${kind} of ${ball}: ${kept.probability} and ${p}`;
      expect(Math.abs(kept.probability - p), said).toBeLessThan(WITHIN * error);
    }
    player.free();
    frame.free();
  },
);
