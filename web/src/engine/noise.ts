/** Execution noise as the engine's list of numbers, and back. */

import { numbers, object } from "./arguments.ts";
import { refuse } from "./error.ts";
import type { Noise } from "./types.ts";
import { warnOnce } from "./warn.ts";

const NUMBERS = [
  "speed",
  "azimuth",
  "elevation",
  "side_m",
  "height_m",
  "cling_probability",
  "cling_friction",
] as const;

/** What a noise without these keys has: those of the engine's presets. */
export const CLING = { cling_probability: 0, cling_friction: 0.22 } as const;

/** Keys of older versions, whose names did not say that they are in metres. */
const OLD_KEYS = { side: "side_m", height: "height_m" } as const;

/** The noise from σ of speed, azimuth, elevation, side and height, and its cling. */
export function namedSigmas(values: ArrayLike<number>): Noise {
  return {
    speed: values[0]!,
    azimuth: values[1]!,
    elevation: values[2]!,
    side_m: values[3]!,
    height_m: values[4]!,
    cling_probability: values[5]!,
    cling_friction: values[6]!,
  };
}

/**
 * The numbers of a noise, in the engine's order.
 *
 * @param place What the argument is called.
 * @throws CaromError if one is missing or not a number.
 */
export function sigmasOf(noise: Noise, place = "noise"): Float64Array {
  const { value, old } = withNewKeys(object(place, noise) as Readonly<Record<string, unknown>>);
  for (const key of old) warnOnce(`Noise.${key} is called Noise.${OLD_KEYS[key]} now`);
  const plain = numbers(place, { ...CLING, ...value }, NUMBERS);
  if (!FURTHER.some((key) => value[key] !== undefined)) return Float64Array.from(plain);
  const { speed_relative = 0, bias = [0, 0, 0, 0, 0] } = value;
  const covariance =
    value.covariance === undefined ? [] : rows(`${place}.covariance`, value.covariance);
  if (covariance.length !== 0 && covariance.length !== 5) {
    const inner = `${place}.covariance`;
    refuse("wrong-count", inner, `found ${covariance.length} rows`, "write five rows");
  }
  const samples = value.samples === undefined ? [] : rows(`${place}.samples`, value.samples);
  return Float64Array.from([
    ...plain,
    ...numbers(place, { speed_relative }, ["speed_relative"]),
    ...five(`${place}.bias`, bias),
    covariance.length === 0 ? 0 : 1,
    ...covariance.flat(),
    ...samples.flat(),
  ]);
}

/** The keys of a noise that is more than independent Gaussian errors. */
const FURTHER = ["speed_relative", "covariance", "bias", "samples"] as const;

/** @throws CaromError if `row` is not five numbers. */
function five(place: string, row: unknown): number[] {
  if (Array.isArray(row) && row.length === 5) return numbers(place, row, ["0", "1", "2", "3", "4"]);
  return refuse("wrong-count", place, "found no list of five numbers", "write one");
}

/** @throws CaromError if `list` is not a list of rows of five numbers. */
function rows(place: string, list: unknown): number[][] {
  if (!Array.isArray(list)) refuse("wrong-type", place, "found no list", "write rows of five");
  return list.map((row, i) => five(`${place}[${i}]`, row));
}

/**
 * Replaces the keys of older versions by their present names.
 *
 * @returns The noise, and the old keys that were found.
 * @throws CaromError if a σ has both of its names.
 */
export function withNewKeys(noise: Readonly<Record<string, unknown>>): {
  readonly value: Readonly<Record<string, unknown>>;
  readonly old: readonly (keyof typeof OLD_KEYS)[];
} {
  const value = { ...noise };
  const old = (Object.keys(OLD_KEYS) as (keyof typeof OLD_KEYS)[]).filter((key) => key in noise);
  for (const key of old) {
    const present = OLD_KEYS[key];
    if (present in noise) {
      const place = `noise.${key}`;
      refuse("duplicate", place, `this is the old name of ${present}`, "remove one of them");
    }
    value[present] = value[key];
    Reflect.deleteProperty(value, key);
  }
  return { value, old };
}
