/** The numbers of a strike. A shot file has its angles in degrees or in radians. */

import type { StrikeEntry } from "../../engine/index.ts";
import { toDegrees, toRadians } from "../common/angles.ts";

/** The keys that have a number, in the order in which a tree is written; `Shot.withStrike` can change them. */
export const STRIKE_NUMBERS = [
  "speed",
  "azimuth_deg",
  "azimuth",
  "elevation_deg",
  "elevation",
  "side",
  "height",
] as const;

/** Direction of the cue, degrees; a file may have it in radians. */
export function azimuthOf({ azimuth, azimuth_deg = 0 }: StrikeEntry): number {
  return azimuth === undefined ? azimuth_deg : toDegrees(azimuth);
}

/** Whether the strike omits its elevation, so that the engine chooses it. */
export function isAutomatic({ elevation, elevation_deg }: StrikeEntry): boolean {
  return elevation === undefined && elevation_deg === undefined;
}

/**
 * Elevation of the cue, degrees; a file may have it in radians.
 *
 * @param used The elevation that the engine uses, rad; it is shown if the strike omits one.
 */
export function elevationOf({ elevation, elevation_deg }: StrikeEntry, used: number): number {
  return elevation_deg ?? toDegrees(elevation ?? used);
}

/**
 * The angles of a strike in radians, as the engine reads them from a file. The elevation is undefined
 * if it is automatic.
 */
export function anglesOf(strike: StrikeEntry): { azimuth: number; elevation: number | undefined } {
  const { azimuth_deg = 0, elevation_deg } = strike;
  const { azimuth = toRadians(azimuth_deg) } = strike;
  const inRadians = elevation_deg === undefined ? undefined : toRadians(elevation_deg);
  const { elevation = inRadians } = strike;
  return { azimuth, elevation };
}

/** The strike with an automatic elevation. */
export function automatic(strike: StrikeEntry): StrikeEntry {
  const next: { -readonly [K in keyof StrikeEntry]: StrikeEntry[K] } = { ...strike };
  delete next.elevation;
  delete next.elevation_deg;
  return next;
}

/** A strike with other values. An angle in degrees replaces the same angle in radians. */
export function changed(strike: StrikeEntry, patch: Partial<StrikeEntry>): StrikeEntry {
  const next: { -readonly [K in keyof StrikeEntry]: StrikeEntry[K] } = { ...strike, ...patch };
  if (patch.azimuth_deg !== undefined) delete next.azimuth;
  if (patch.elevation_deg !== undefined) delete next.elevation;
  return next;
}
