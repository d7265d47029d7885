import { expect, test } from "vitest";
import { olympiad, PRESETS, presetOf, SIGMAS } from "../../../src/app/whatif/noise.ts";

test("the Olympiad's noise is that of its rules, in SI units", () => {
  const { speed, azimuth, elevation, side, height } = olympiad(1);
  expect([speed, side, height]).toStrictEqual([0.075, 0.0005, 0.0005]);
  expect((azimuth * 180) / Math.PI).toBeCloseTo(0.125, 14);
  expect((elevation * 180) / Math.PI).toBeCloseTo(0.1, 14);
});

test("a preset is known again, and a noise of one's own is none", () => {
  for (const preset of PRESETS) expect(presetOf({ ...preset.noise })).toBe(preset);
  expect(presetOf({ ...olympiad(1), side: 0 })).toBeUndefined();
});

test("every preset fits on the sliders, and every σ has one", () => {
  expect(SIGMAS.map(({ key }) => key).sort()).toStrictEqual(Object.keys(olympiad(1)).sort());
  for (const { noise } of PRESETS) {
    for (const { key, scale, max } of SIGMAS) expect(noise[key] / scale).toBeLessThanOrEqual(max);
  }
});
