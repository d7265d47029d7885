/** Strikes as callers write them: with angles in radians or in degrees, as in shot files. */
import { known, numbers, text } from "./arguments.ts";
import { refuse } from "./error.ts";
import type { StrikeEntry, StrikeInput } from "./types.ts";
import { warnOnce } from "./warn.ts";

/** The keys of a strike. `ball` is not used: the shot or the frame determines the struck ball. */
const KEYS = {
  ball: true,
  speed: true,
  azimuth: true,
  azimuth_deg: true,
  elevation: true,
  elevation_deg: true,
  side: true,
  height: true,
  obstruction: true,
  miscue: true,
} as const;

/** A strike in radians, with the defaults of what it omits. */
export interface ReadStrike {
  /** Speed (m/s), azimuth (rad), elevation (rad; undefined: the default), side, height (ball radii). */
  readonly numbers: readonly [
    speed: number,
    azimuth: number,
    elevation: number | undefined,
    side: number,
    height: number,
  ];
  readonly obstruction: NonNullable<StrikeEntry["obstruction"]>;
  readonly miscue: NonNullable<StrikeEntry["miscue"]>;
}

/** @throws CaromError for an unknown key, a value that is not a number, and an angle in two units. */
export function readStrike(strike: StrikeInput): ReadStrike {
  const given: Partial<StrikeEntry> = known("strike", strike as Partial<StrikeEntry>, KEYS);
  const [speed, side, height] = numbers("strike", { side: 0, height: 0, ...defined(given) }, [
    "speed",
    "side",
    "height",
  ]);
  const azimuth = angle(given, "azimuth");
  if (azimuth === undefined) {
    refuse(
      "missing",
      "strike.azimuth",
      "it is missing",
      "write the cue's direction in radians, or azimuth_deg in degrees",
    );
  }
  if (Math.abs(given.azimuth ?? 0) > 2 * Math.PI) {
    warnOnce("strike.azimuth is beyond ±2π: it is in radians; for degrees write azimuth_deg");
  }
  const { obstruction = "report", miscue = "refuse" } = given;
  return {
    numbers: [speed!, azimuth, angle(given, "elevation"), side!, height!],
    obstruction: text("strike.obstruction", obstruction),
    miscue: text("strike.miscue", miscue),
  };
}

/** An angle in radians, from one of its two keys. */
function angle(given: Partial<StrikeEntry>, key: "azimuth" | "elevation"): number | undefined {
  const inDegrees = `${key}_deg` as const;
  if (given[key] !== undefined && given[inDegrees] !== undefined) {
    refuse(
      "duplicate",
      `strike.${key}`,
      `${inDegrees} gives the same angle`,
      `keep ${key} (rad) or ${inDegrees} (degrees)`,
    );
  }
  if (given[key] !== undefined) return numbers("strike", given, [key])[0]!;
  if (given[inDegrees] === undefined) return undefined;
  return numbers("strike", given, [inDegrees])[0]! * (Math.PI / 180);
}

/** The entries of an object that are not undefined. */
function defined(given: object): object {
  return Object.fromEntries(Object.entries(given).filter(([, value]) => value !== undefined));
}
