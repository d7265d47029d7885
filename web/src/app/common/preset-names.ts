/** The presets of tables, physics and players, and games, with names as players say them. */

import { month, named, t } from "../words/translate.ts";
import { h } from "./dom.ts";

/** A name with the year and month of its values. */
const DATED = /^(.+)-(\d{4}-\d{2})$/;

/** The text for a preset: "Pool, new cloth" for `pool-new-cloth`, with the month if the name has a date. */
export function presetLabel(name: string): string {
  const [, undated, date] = DATED.exec(name) ?? [];
  const own = named("preset", name);
  if (undated === undefined || date === undefined) return own ?? name;
  // Where the older values are not those of the text without the date, the catalogue has the dated name.
  return t("preset.dated", {
    name: own ?? presetLabel(undated),
    month: month(new Date(`${date}-01T00:00:00Z`)),
  });
}

/** A level of play, or its name in files if it has no text. */
export function levelName(name: string): string {
  return named("level", name) ?? name;
}

/** A game as a heading. */
export function gameName(rules: string): string {
  return named("game", rules) ?? rules;
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
  const group = h("optgroup", { label: t("preset.earlier") }, ...older.map(option));
  return [...newest.map(option), ...(older.length > 0 ? [group] : [])];
}
