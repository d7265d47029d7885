/** The angles of a strike: a shot file has each in degrees or in radians. */

import type { StrikeEntry } from "../../engine/index.ts";

const RADIANS_PER_DEGREE = Math.PI / 180;

/** Direction of the cue, degrees; a file may have it in radians. */
export function azimuthOf({ azimuth, azimuth_deg = 0 }: StrikeEntry): number {
  return azimuth === undefined ? azimuth_deg : azimuth / RADIANS_PER_DEGREE;
}

/** Elevation of the cue, degrees; a file may have it in radians. */
export function elevationOf({ elevation, elevation_deg = 0 }: StrikeEntry): number {
  return elevation === undefined ? elevation_deg : elevation / RADIANS_PER_DEGREE;
}

/** The angles of a strike in radians, as the engine reads them from a file. */
export function anglesOf(strike: StrikeEntry): { azimuth: number; elevation: number } {
  const { azimuth_deg = 0, elevation_deg = 0 } = strike;
  const { azimuth = azimuth_deg * RADIANS_PER_DEGREE } = strike;
  const { elevation = elevation_deg * RADIANS_PER_DEGREE } = strike;
  return { azimuth, elevation };
}

/** A strike with other values. An angle in degrees replaces the same angle in radians. */
export function changed(strike: StrikeEntry, patch: Partial<StrikeEntry>): StrikeEntry {
  const next: { -readonly [K in keyof StrikeEntry]: StrikeEntry[K] } = { ...strike, ...patch };
  if (patch.azimuth_deg !== undefined) delete next.azimuth;
  if (patch.elevation_deg !== undefined) delete next.elevation;
  return next;
}
