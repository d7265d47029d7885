/** The presets of tables and of physics in a list, with names as players say them. */

import { h } from "./dom.ts";

/** Texts by name without a date. A preset that is missing here is listed by its name. */
const LABELS: Readonly<Record<string, string>> = {
  pool: "Pool",
  "pool-new-cloth": "Pool, new cloth",
  "pool-worn-cloth": "Pool, worn cloth",
  "pool-clean-balls": "Pool, clean balls",
  "pool-dirty-balls": "Pool, dirty balls",
  "pool-gold-crown": "Pool, Gold Crown rails",
  "pool-valley": "Pool, Valley rails",
  snooker: "Snooker",
  english: "English pool",
  carom: "Carom, heated",
  poolfiz: "Poolfiz",
  ideal: "Ideal collisions",
  "wpa-9ft": "WPA, 9 ft",
  "wpa-8ft": "WPA, 8 ft",
  "bar-7ft": "Bar table, 7 ft",
  "showood-7ft": "Showood, 7 ft",
  "snooker-12ft": "Snooker, 12 ft",
  "english-7ft": "English pool, 7 ft",
  "carom-10ft": "Carom, 10 ft",
  "carom-9ft": "Carom, 9 ft",
};

/** Texts of dated names where the older values are not those of the text without the date. */
const OLDER: Readonly<Record<string, string>> = { "carom-2026-11": "Carom" };

/** A name with the year and month of its values. */
const DATED = /^(.+)-(\d{4}-\d{2})$/;

/** The text for a preset: "Pool, new cloth" for `pool-new-cloth`, with the month if the name has a date. */
export function presetLabel(name: string): string {
  const [, undated, date] = DATED.exec(name) ?? [];
  if (undated === undefined || date === undefined) return LABELS[name] ?? name;
  return `${OLDER[name] ?? presetLabel(undated)}, ${month(date)}`;
}

/** "Nov 2026" for `2026-11`. */
function month(date: string): string {
  return new Date(`${date}-01T00:00:00Z`).toLocaleDateString("en", {
    month: "short",
    year: "numeric",
    timeZone: "UTC",
  });
}

/** The names of a list: the newest values first, the older ones in a group of their own. */
export function byAge(names: readonly string[]): {
  readonly newest: readonly string[];
  readonly older: readonly string[];
} {
  return {
    newest: names.filter((name) => !DATED.test(name)),
    older: names.filter((name) => DATED.test(name)),
  };
}

/** The entries of a list of presets. The engine dates the names of older values only. */
export function presetOptions(names: readonly string[]): HTMLElement[] {
  const option = (name: string) => h("option", { value: name }, presetLabel(name));
  const { newest, older } = byAge(names);
  const group = h("optgroup", { label: "Earlier values" }, ...older.map(option));
  return [...newest.map(option), ...(older.length > 0 ? [group] : [])];
}
