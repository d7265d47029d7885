import { describe, expect, test } from "vitest";
import { load } from "../../../src/engine/index.ts";
import { GOLDENS, read, shotFile } from "./files.ts";

const engine = await load();

describe("every named shot has the native engine's events, to the bit", () => {
  test.each(Object.entries(GOLDENS))("%s", (name, golden) => {
    const trace = engine.shot(shotFile(name)).simulate();
    expect({ events: trace.events.length, hash: trace.hash }).toEqual(golden);
  });
});

interface NoiseGolden {
  readonly shot: string;
  readonly olympiad: number;
  readonly seed: number;
  readonly first: number;
  readonly variants: readonly {
    readonly strike: readonly number[];
    readonly events: number;
    readonly final: readonly number[];
  }[];
}

const noiseGoldens = JSON.parse(read("goldens/noise.json")) as NoiseGolden[];

test("variants have the native engine's strikes and final positions, to the bit", () => {
  expect(noiseGoldens).not.toHaveLength(0);
  for (const { shot, olympiad, seed, first, variants } of noiseGoldens) {
    const noise = engine.olympiad(olympiad);
    const batch = engine.shot(shotFile(shot)).vary(noise, variants.length, { seed, first });
    variants.forEach(({ strike, events, final }, k) => {
      expect([...batch.strikes.subarray(5 * k, 5 * k + 5)]).toEqual(strike);
      expect(batch.events[k]).toBe(events);
      const start = 3 * k * batch.balls;
      expect([...batch.final_position.subarray(start, start + 3)]).toEqual(final);
    });
  }
});
