// Execution noise as the page offers and shows it.

import type { Noise } from "../../engine/types.ts";

const RADIANS = Math.PI / 180;

/** The Computational Olympiad's σ (Archibald, Altman & Shoham 2009), times `multiplier`. */
export function olympiad(multiplier: number): Noise {
  return {
    speed: 0.075 * multiplier,
    azimuth: 0.125 * RADIANS * multiplier,
    elevation: 0.1 * RADIANS * multiplier,
    side: 0.0005 * multiplier,
    height: 0.0005 * multiplier,
  };
}

export interface Preset {
  readonly name: string;
  readonly noise: Noise;
}

/** The Olympiad's tournaments were played at half, once and twice its noise. */
export const PRESETS: readonly Preset[] = [
  { name: "Olympiad × ½", noise: olympiad(0.5) },
  { name: "Olympiad", noise: olympiad(1) },
  { name: "Olympiad × 2", noise: olympiad(2) },
];

/** What one is shown first. */
export const FIRST_NOISE = olympiad(1);

/** The preset that a noise is, if it is one. */
export function presetOf(noise: Noise): Preset | undefined {
  return PRESETS.find((preset) => SIGMAS.every(({ key }) => preset.noise[key] === noise[key]));
}

/** A σ as the page shows it. */
export interface Sigma {
  readonly key: keyof Noise;
  readonly label: string;
  readonly unit: string;
  readonly spoken: string;
  /** What one of the shown unit is in the engine's. */
  readonly scale: number;
  /** The most that the slider reaches, and its step, in the shown unit. */
  readonly max: number;
  readonly step: number;
}

export const SIGMAS: readonly Sigma[] = [
  {
    key: "speed",
    label: "Speed",
    unit: "m/s",
    spoken: "metres per second",
    scale: 1,
    max: 0.5,
    step: 0.005,
  },
  {
    key: "azimuth",
    label: "Direction",
    unit: "°",
    spoken: "degrees",
    scale: RADIANS,
    max: 2,
    step: 0.005,
  },
  {
    key: "elevation",
    label: "Elevation",
    unit: "°",
    spoken: "degrees",
    scale: RADIANS,
    max: 5,
    step: 0.01,
  },
  {
    key: "side",
    label: "Tip, sideways",
    unit: "mm",
    spoken: "millimetres",
    scale: 1e-3,
    max: 5,
    step: 0.05,
  },
  {
    key: "height",
    label: "Tip, height",
    unit: "mm",
    spoken: "millimetres",
    scale: 1e-3,
    max: 5,
    step: 0.05,
  },
];
