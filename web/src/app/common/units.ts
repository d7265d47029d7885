/** Numbers as people read them. Inside, everything is SI. */

export type SpeedUnit = "m/s" | "km/h" | "mph";

/** m/s in one unit. */
export const SPEED_UNITS: Readonly<Record<SpeedUnit, number>> = {
  "m/s": 1,
  "km/h": 1 / 3.6,
  // The international mile of 1609.344 m, in an hour.
  mph: 1609.344 / 3600,
};

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

/** A length (m) in words, in the unit in which one thinks of it. */
export function lengthText(metres: number): string {
  return metres < 1 ? `${Math.round(metres * 1000)} mm` : `${metres.toFixed(2)} m`;
}
