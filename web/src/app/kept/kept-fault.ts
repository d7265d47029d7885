/** Strict reading of what the page has kept: of the browser's storage, which may be damaged, and of files. */

/** Something kept that cannot be read. */
export class KeptFault extends Error {
  override name = "KeptFault";
  /** Where the fault is, such as `works[2].steps[7].shot`. */
  readonly place: string;

  constructor(place: string) {
    super(place);
    this.place = place;
  }
}

export type Entries = Readonly<Record<string, unknown>>;

/** An object with these keys and no others. */
export function entriesAt(
  data: unknown,
  place: string,
  keys: readonly string[],
  optional: readonly string[] = [],
): Entries {
  check(typeof data === "object" && data !== null && !Array.isArray(data), place);
  for (const key of keys) check(Object.hasOwn(data, key), `${place}.${key}`);
  for (const key of Object.keys(data)) {
    check(keys.includes(key) || optional.includes(key), `${place}.${key}`);
  }
  return data as Entries;
}

/** A list with a bounded number of items, each read by `read`. */
export function listAt<T>(
  data: unknown,
  place: string,
  most: number,
  read: (item: unknown, place: string) => T,
): T[] {
  check(Array.isArray(data) && data.length <= most, place);
  return data.map((item, k) => read(item, `${place}[${k}]`));
}

export function textAt(data: unknown, place: string, longest: number): string {
  check(typeof data === "string" && data.length <= longest, place);
  return data;
}

export function wholeAt(data: unknown, place: string, least: number, most: number): number {
  check(Number.isInteger(data), place);
  const number = data as number;
  check(number >= least && number <= most, place);
  return number;
}

/** A time as `Date.toISOString` writes it. */
export function timeAt(data: unknown, place: string): string {
  const time = typeof data === "string" ? Date.parse(data) : NaN;
  check(!Number.isNaN(time) && new Date(time).toISOString() === data, place);
  return data;
}

export function check(isRight: boolean, place: string): asserts isRight {
  if (!isRight) throw new KeptFault(place);
}

/** Whether two plain values are equal, whatever the order of their keys. */
export function isEqual(a: unknown, b: unknown): boolean {
  return JSON.stringify(a, sorted) === JSON.stringify(b, sorted);
}

function sorted(_: string, value: unknown): unknown {
  if (typeof value !== "object" || value === null || Array.isArray(value)) return value;
  return Object.fromEntries(Object.entries(value).sort(([a], [b]) => (a < b ? -1 : 1)));
}
