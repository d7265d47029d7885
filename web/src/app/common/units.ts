/** Conversion of SI numbers to the units and the text that users read. */

export type SpeedUnit = "m/s" | "km/h" | "mph";

/** m/s per unit. */
export const SPEED_UNITS: Readonly<Record<SpeedUnit, number>> = {
  "m/s": 1,
  "km/h": 1 / 3.6,
  // The international mile is 1609.344 m.
  mph: 1609.344 / 3600,
};

/** One tip, in ball radii: the engine's `tip`, for what is shown before the engine is there. */
export const TIP = 1 / 6;

/** `v` (m/s) as a number in `unit`. */
export function speedIn(unit: SpeedUnit, v: number): number {
  return v / SPEED_UNITS[unit];
}

/** m/s from a number in `unit`. */
export function speedFrom(unit: SpeedUnit, value: number): number {
  return value * SPEED_UNITS[unit];
}

/** `value` with at most `digits` decimals, without trailing zeros. */
export function round(value: number, digits: number): number {
  const scale = 10 ** digits;
  const rounded = Math.round(value * scale) / scale;
  return rounded === 0 ? 0 : rounded;
}

/** An estimated chance in whole per cent: 99 at most, because a simulation proves no certainty. */
export function estimatedPercent(share: number): number {
  return Math.min(99, Math.round(100 * share));
}
