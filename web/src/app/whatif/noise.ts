/** Presets of execution noise, and its standard deviations in the page's units. */

import type { Engine, Noise } from "../../engine/index.ts";

const RADIANS = Math.PI / 180;

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
      origin: "Players (estimated)",
      presets: levels.map(([name, noise]) => ({ name: capital(name), noise })),
    },
    {
      origin: "Computational Olympiad",
      presets: [
        { name: "Olympiad × ½", noise: engine.olympiad(0.5) },
        { name: "Olympiad", noise: engine.olympiad(1) },
        { name: "Olympiad × 2", noise: engine.olympiad(2) },
      ],
    },
  ];
}

function capital(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}

/** The preset that equals a noise, if there is one. */
export function presetOf(noise: Noise, known: readonly PresetGroup[]): Preset | undefined {
  return known
    .flatMap(({ presets }) => presets)
    .find((preset) => ALL.every(({ key }) => preset.noise[key] === noise[key]));
}

/** How the page shows a number of a noise. */
export interface Sigma {
  readonly key: keyof Noise;
  readonly label: string;
  readonly unit: string;
  readonly spoken: string;
  /** The shown unit in the engine's unit. */
  readonly scale: number;
  /** Upper end and step of the slider, in the shown unit. */
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
    key: "side_m",
    label: "Tip, sideways",
    unit: "mm",
    spoken: "millimetres",
    scale: 1e-3,
    max: 5,
    step: 0.05,
  },
  {
    key: "height_m",
    label: "Tip, height",
    unit: "mm",
    spoken: "millimetres",
    scale: 1e-3,
    max: 5,
    step: 0.05,
  },
];

/** Cling between balls: chalk or dirt that raises the friction of single contacts. */
export const CLING: readonly Sigma[] = [
  {
    key: "cling_probability",
    label: "Contacts that cling",
    unit: "%",
    spoken: "per cent",
    scale: 0.01,
    max: 100,
    step: 0.5,
  },
  {
    key: "cling_friction",
    label: "Their friction",
    unit: "",
    spoken: "",
    scale: 1,
    max: 0.5,
    step: 0.01,
  },
];

const ALL: readonly Sigma[] = [...SIGMAS, ...CLING];
