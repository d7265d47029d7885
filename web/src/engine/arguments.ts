/** Checks of arguments: WebAssembly would convert a wrong type silently, or fail without a message. */

import { refuse } from "./error.ts";

/** `JSON.stringify` with its complete type: it returns undefined for functions and symbols. */
function stringify(value: unknown): string | undefined {
  return JSON.stringify(value);
}

/** A value in a message. */
function shown(value: unknown): string {
  if (typeof value === "number" || value === undefined) return String(value);
  try {
    return stringify(value) ?? typeof value;
  } catch {
    return typeof value;
  }
}

/**
 * JSON of a file that is text or a value. The engine refuses `null`, which stands for no value.
 *
 * @param place What the argument is called.
 * @throws CaromError for a number that is not finite: JSON would have `null` there, and the engine would take
 * it for a missing value.
 */
export function json(file: unknown, place = ""): string {
  if (typeof file === "string") return file;
  const written = stringify(file) ?? "null";
  if (written.includes("null")) refuseInfinite(place, file);
  return written;
}

function refuseInfinite(place: string, value: unknown): void {
  if (typeof value === "number" && !Number.isFinite(value)) {
    refuse("out-of-range", place, `${value} is not finite`, "write a finite number");
  }
  if (typeof value !== "object" || value === null) return;
  for (const [key, inner] of Object.entries(value)) {
    refuseInfinite(inside(place, key, Array.isArray(value)), inner);
  }
}

/** The place of an entry. */
function inside(place: string, key: string, isIndex: boolean): string {
  if (isIndex) return `${place}[${key}]`;
  return place === "" ? key : `${place}.${key}`;
}

/** The kind of the error for a value of a wrong type. */
function wrong(value: unknown): "missing" | "wrong-type" {
  return value === undefined || value === null ? "missing" : "wrong-type";
}

/** @throws CaromError if `value` is not a string. */
export function text<T extends string>(place: string, value: T): T {
  if (typeof value === "string") return value;
  refuse(wrong(value), place, `found ${shown(value)}`, "write a string");
}

/** @throws CaromError if `value` is not a boolean. */
export function boolean(place: string, value: boolean): boolean {
  if (typeof value === "boolean") return value;
  refuse(wrong(value), place, `found ${shown(value)}`, "write true or false");
}

/** @throws CaromError if `value` is not an object. */
export function object(place: string, value: unknown): object {
  if (typeof value === "object" && value !== null) return value;
  refuse(wrong(value), place, `found ${shown(value)}`, "write an object");
}

/**
 * An object without unknown keys.
 *
 * @param keys An object with every key that it may have.
 * @throws CaromError if `given` is not an object, or has another key.
 */
export function known<T extends object>(
  place: string,
  given: T,
  keys: Readonly<Record<keyof T, unknown>>,
): T {
  for (const key of Object.keys(object(place, given))) {
    if (Object.hasOwn(keys, key)) continue;
    refuse(
      "unknown-key",
      `${place}.${key}`,
      "unknown key",
      `the keys known here are ${Object.keys(keys).join(", ")}`,
    );
  }
  return given;
}

/**
 * The numbers under some keys of an object, in the order of the keys. The engine checks their ranges.
 *
 * @throws CaromError if `of` is not an object, or a value is not a number.
 */
export function numbers(place: string, of: unknown, keys: readonly string[]): number[] {
  const values = object(place, of) as Readonly<Record<string, unknown>>;
  return keys.map((key) => {
    const value = values[key];
    if (typeof value === "number") return value;
    const at = inside(place, key, /^\d/.test(key));
    return refuse(wrong(value), at, `found ${shown(value)}`, "write a number");
  });
}

/**
 * A whole number from 0 to `most`.
 *
 * @param remedy What to do for larger numbers, if anything can be done.
 * @throws CaromError if `value` is not one.
 */
export function whole(
  place: string,
  value: number,
  most = Number.MAX_SAFE_INTEGER,
  remedy = "",
): bigint {
  if (Number.isSafeInteger(value) && value >= 0 && value <= most) return BigInt(value);
  const more = remedy === "" ? "" : `; ${remedy}`;
  refuse(
    "out-of-range",
    place,
    `${shown(value)} is out of range`,
    `write a whole number from 0 to ${most}${more}`,
  );
}

/**
 * 64 bits from 16 hexadecimal digits.
 *
 * @throws CaromError for another text.
 */
export function bits(place: string, digits: string): bigint {
  if (/^[0-9a-f]{16}$/.test(digits)) return BigInt(`0x${digits}`);
  refuse("syntax", place, `found ${shown(digits)}`, "write 16 hexadecimal digits or a number");
}

/**
 * The index of a name.
 *
 * @throws CaromError if it is not among `names`.
 */
export function named(place: string, name: string, names: readonly string[]): number {
  const index = names.indexOf(text(place, name));
  if (index >= 0) return index;
  const known = names.length === 0 ? "there is none" : `write one of ${names.join(", ")}`;
  refuse("unknown-name", place, `there is no ${place} ${shown(name)}`, known);
}
