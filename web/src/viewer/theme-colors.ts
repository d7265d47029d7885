/** The colours of the light and the dark theme. */

import type { Theme } from "./viewer-types.ts";

export interface Palette {
  background: string;
  /** Colours of the rails and of the frame below. */
  wood: string;
  apron: string;
  /** Intensity of the ambient light and of the lamp. */
  ambient: number;
  lamp: number;
  /** Darkness of the table's shadow on the floor, 0 to 1. */
  floorShadow: number;
}

const PALETTES: Readonly<Record<Theme, Palette>> = {
  light: {
    background: "#e8e5de",
    wood: "#7a4d2f",
    apron: "#4b3222",
    ambient: 1.65,
    lamp: 2.45,
    floorShadow: 0.4,
  },
  dark: {
    background: "#15181b",
    wood: "#5d3a25",
    apron: "#33231a",
    ambient: 1.15,
    lamp: 2.2,
    floorShadow: 0.75,
  },
};

/** The colours of a theme. */
export function palette(theme: Theme): Palette {
  return PALETTES[theme];
}

/** Colour of the cloth by the physics preset of the table. */
const CLOTHS: Readonly<Record<string, string>> = {
  pool: "#1c6f60",
  snooker: "#2c7447",
  english: "#2c7447",
  carom: "#2b62a0",
};

/**
 * The colour of the cloth.
 *
 * @param physics - The table's own physics preset, if it has one.
 */
export function clothColor(physics: string | undefined): string {
  return CLOTHS[kindOf(physics)] ?? CLOTHS.pool!;
}

/** The kind of game of a physics preset, whose name may go on with conditions and a date. */
export function kindOf(physics = "pool"): string {
  return physics.split("-", 1)[0]!;
}
