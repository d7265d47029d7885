import { expect, test } from "vitest";
import { load } from "../../../src/engine/index.ts";
import { CLING, presetOf, presetsOf, SIGMAS } from "../../../src/app/whatif/noise-presets.ts";

const engine = await load();
const PRESETS = presetsOf(engine);
const ALL = PRESETS.flatMap(({ presets }) => presets);

test("the Olympiad's noise has the values of its rules, in SI units", () => {
  const { speed, azimuth, elevation, side_m, height_m } = engine.olympiad();
  expect([speed, side_m, height_m]).toStrictEqual([0.075, 0.0005, 0.0005]);
  expect((azimuth * 180) / Math.PI).toBeCloseTo(0.125, 14);
  expect((elevation * 180) / Math.PI).toBeCloseTo(0.1, 14);
});

test("a preset is recognised by its values, and other noise is not", () => {
  for (const preset of ALL) expect(presetOf({ ...preset.noise }, PRESETS)).toBe(preset);
  expect(presetOf({ ...engine.olympiad(), side_m: 0 }, PRESETS)).toBeUndefined();
});

test("every number has a slider, and every preset is within its range", () => {
  const sliders = [...SIGMAS, ...CLING];
  expect(sliders.map(({ key }) => key).sort()).toStrictEqual(Object.keys(engine.olympiad()).sort());
  for (const { noise } of ALL) {
    for (const { key, scale, max } of sliders) expect(noise[key]! / scale).toBeLessThanOrEqual(max);
  }
});

test("a noise with cling equals none of the presets", () => {
  expect(presetOf({ ...engine.olympiad(), cling_probability: 0.1 }, PRESETS)).toBeUndefined();
});

test("the levels of play are in order, from the widest errors to the smallest", () => {
  const [players] = PRESETS;
  expect(players!.presets.map(({ name }) => name)).toStrictEqual([
    "Beginner",
    "Casual",
    "Club",
    "Advanced",
    "Professional",
  ]);
  const azimuths = players!.presets.map(({ noise }) => noise.azimuth);
  expect(azimuths).toStrictEqual([...azimuths].sort((a, b) => b - a));
});
