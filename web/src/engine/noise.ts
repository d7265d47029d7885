/** Execution noise as JSON for the engine, and back. */

import { json, numbers, object } from "./arguments.ts";
import { refuse } from "./error.ts";
import type { Noise } from "./types.ts";
import { warnOnce } from "./warn.ts";

/** The standard deviations that a noise must have. The engine knows the other keys and their ranges. */
const SIGMAS = ["speed", "azimuth", "elevation", "side_m", "height_m"] as const;

/** Keys of older versions, whose names did not say that they are in metres. */
const OLD_KEYS = { side: "side_m", height: "height_m" } as const;

/** A noise that the engine wrote. */
export function noiseOf(written: string): Noise {
  return JSON.parse(written) as Noise;
}

/**
 * A noise as JSON for the engine, which checks it.
 *
 * @param place What the argument is called.
 * @throws CaromError if a standard deviation is missing or not a number, and for a number that is not finite.
 */
export function noiseJson(noise: Noise, place = "noise"): string {
  const given = object(place, noise) as Readonly<Record<string, unknown>>;
  const { value, old } = withNewKeys(given, place);
  for (const key of old) warnOnce(`Noise.${key} is called Noise.${OLD_KEYS[key]} now`);
  numbers(place, value, SIGMAS);
  return json(value, place);
}

/**
 * Replaces the keys of older versions by their present names.
 *
 * @returns The noise, and the old keys that were found.
 * @throws CaromError if a σ has both of its names.
 */
export function withNewKeys(
  noise: Readonly<Record<string, unknown>>,
  place = "noise",
): {
  readonly value: Readonly<Record<string, unknown>>;
  readonly old: readonly (keyof typeof OLD_KEYS)[];
} {
  const value = { ...noise };
  const old = (Object.keys(OLD_KEYS) as (keyof typeof OLD_KEYS)[]).filter((key) => key in noise);
  for (const key of old) {
    const present = OLD_KEYS[key];
    if (present in noise) {
      refuse(
        "duplicate",
        `${place}.${key}`,
        `this is the old name of ${present}`,
        "remove one of them",
      );
    }
    value[present] = value[key];
    Reflect.deleteProperty(value, key);
  }
  return { value, old };
}
