/** Presets of execution noise, and its standard deviations in the page's units. */

import type { Engine, Noise } from "../../engine/index.ts";
import { toRadians } from "../common/angles.ts";
import { levelName } from "../common/preset-names.ts";
import { type PlainKey, t } from "../words/translate.ts";

export interface Preset {
  readonly name: string;
  readonly noise: Noise;
}

/** Presets of one origin. */
export interface PresetGroup {
  readonly origin: string;
  readonly presets: readonly Preset[];
}

/** The engine's presets: levels of play, and the Olympiad with the multipliers of its tournaments. */
export function presetsOf(
  engine: Pick<Engine, "noisePresets" | "olympiad">,
): readonly PresetGroup[] {
  const levels = Object.entries(engine.noisePresets).filter(([name]) => name !== "olympiad");
  return [
    {
      origin: t("whatif.players"),
      presets: levels.map(([name, noise]) => ({ name: levelName(name), noise })),
    },
    {
      origin: t("whatif.olympiad"),
      presets: [
        { name: t("whatif.olympiad-half"), noise: engine.olympiad(0.5) },
        { name: levelName("olympiad"), noise: engine.olympiad(1) },
        { name: t("whatif.olympiad-double"), noise: engine.olympiad(2) },
      ],
    },
  ];
}

/** The preset that equals a noise, if there is one. */
export function presetOf(noise: Noise, known: readonly PresetGroup[]): Preset | undefined {
  return known
    .flatMap(({ presets }) => presets)
    .find((preset) => ALL.every(({ key }) => preset.noise[key] === noise[key]));
}

/** How the page shows a number of a noise. */
export interface Sigma {
  readonly key: Exclude<keyof Noise, "speed_relative" | "covariance" | "bias" | "samples">;
  readonly unit: string;
  /** The unit for screen readers; null if the number has none. */
  readonly spoken: PlainKey | null;
  /** The shown unit in the engine's unit. */
  readonly scale: number;
  /** Upper end and step of the slider, in the shown unit. */
  readonly max: number;
  readonly step: number;
}

export const SIGMAS: readonly Sigma[] = [
  {
    key: "speed",
    unit: "m/s",
    spoken: "unit.metres-per-second",
    scale: 1,
    max: 0.5,
    step: 0.005,
  },
  {
    key: "azimuth",
    unit: "°",
    spoken: "unit.degrees",
    scale: toRadians(1),
    max: 2,
    step: 0.005,
  },
  {
    key: "elevation",
    unit: "°",
    spoken: "unit.degrees",
    scale: toRadians(1),
    max: 5,
    step: 0.01,
  },
  {
    key: "side_m",
    unit: "mm",
    spoken: "unit.millimetres",
    scale: 1e-3,
    max: 5,
    step: 0.05,
  },
  {
    key: "height_m",
    unit: "mm",
    spoken: "unit.millimetres",
    scale: 1e-3,
    max: 5,
    step: 0.05,
  },
];

/** Cling between balls: chalk or dirt that raises the friction of single contacts. */
export const CLING: readonly Sigma[] = [
  {
    key: "cling_probability",
    unit: "%",
    spoken: "unit.per-cent",
    scale: 0.01,
    max: 100,
    step: 0.5,
  },
  {
    key: "cling_friction",
    unit: "",
    spoken: null,
    scale: 1,
    max: 0.5,
    step: 0.01,
  },
];

const ALL: readonly Sigma[] = [...SIGMAS, ...CLING];
