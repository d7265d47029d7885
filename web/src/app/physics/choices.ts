/** Cloth, balls and rails as players name them, and the physics that a choice of them gives. */

import { type Values, valueAt, withValue } from "../form/parameters.ts";

/** What a player can choose. */
export const TABLE_PARTS = ["cloth", "balls", "rails"] as const;
export type TablePart = (typeof TABLE_PARTS)[number];

/** The choice of what the preset without a condition has. */
export const USUAL = "usual";

/** What a part has if no choice gives its numbers. */
export const NUMBERS = "numbers";

/** The conditions of a part are ends of names of presets: `pool-new-cloth` is `pool` with another cloth. */
interface Conditions {
  /** The only key of the physics in which these presets differ from the one without a condition. */
  readonly key: "cloth" | "ball_ball" | "cushion";
  /** In the order of the list; balls are cleaner or dirtier than the usual ones, which are used. */
  readonly conditions: readonly string[];
}

const PARTS: Readonly<Record<TablePart, Conditions>> = {
  cloth: { key: "cloth", conditions: [USUAL, "new-cloth", "worn-cloth"] },
  balls: { key: "ball_ball", conditions: ["clean-balls", USUAL, "dirty-balls"] },
  rails: { key: "cushion", conditions: [USUAL, "gold-crown", "valley"] },
};

/** The conditions that have the numbers of a named surface of the balls. */
const SURFACES: Readonly<Record<string, string>> = {
  clean: "clean-balls",
  used: USUAL,
  dirty: "dirty-balls",
};
const SURFACE = ["ball_ball", "friction"];

/** All presets by name. */
type Presets = Readonly<Record<string, Values>>;

/** Where a physics comes from. */
export interface Origin {
  readonly presets: Presets;
  /** The preset whose values the changes replace. */
  readonly base: string;
}

/** The preset without a condition: `pool` for `pool-new-cloth`, and for itself. */
export function familyOf(name: string, presets: Presets): string {
  for (const { conditions } of Object.values(PARTS)) {
    for (const condition of conditions) {
      if (condition === USUAL) continue;
      const family = name.slice(0, -condition.length - 1);
      if (name === `${family}-${condition}` && family in presets) return family;
    }
  }
  return name;
}

/** The conditions of a part that a family has, `USUAL` among them; empty if there is no choice. */
export function offered(part: TablePart, family: string, presets: Presets): readonly string[] {
  const found = PARTS[part].conditions.filter((name) => presetOf(family, name) in presets);
  return found.length > 1 ? found : [];
}

/** The condition of a part, `USUAL`, or `NUMBERS`, by the present values of the physics. */
export function chosen(part: TablePart, now: Values, { presets, base }: Origin): string {
  const { key } = PARTS[part];
  const family = familyOf(base, presets);
  const present = withNumbers(now, family, presets)[key];
  const found = offered(part, family, presets).find((condition) =>
    isSame(present, presets[presetOf(family, condition)]?.[key]),
  );
  return found ?? NUMBERS;
}

/**
 * The physics of a shot file after a choice. Everything but the part stays as it is.
 *
 * @param now The present values of the physics.
 * @param own The preset of the table.
 * @returns Undefined for the table's own physics; the name of a preset that has all the values; or the
 * values that differ from the nearest preset of the family.
 */
export function withChoice(
  now: Values,
  [part, condition]: readonly [TablePart, string],
  { presets, base, own }: Origin & { readonly own: string },
): string | Values | undefined {
  const { key } = PARTS[part];
  const family = familyOf(base, presets);
  const next = { ...now, [key]: presets[presetOf(family, condition)]?.[key] };
  const near = TABLE_PARTS.flatMap((one) => offered(one, family, presets))
    .map((one) => presetOf(family, one))
    .reduce(
      (best, name) => (distance(presets[name], next) < distance(presets[best], next) ? name : best),
      family,
    );
  const rest = difference(presets[near] ?? {}, next);
  if (Object.keys(rest).length === 0) return near === own ? undefined : near;
  return near === own ? rest : { base: near, ...rest };
}

function presetOf(family: string, condition: string): string {
  return condition === USUAL ? family : `${family}-${condition}`;
}

/** The values with the numbers of the balls' surface, if it has a name. */
function withNumbers(values: Values, family: string, presets: Presets): Values {
  const name = valueAt(values, SURFACE);
  const condition = typeof name === "string" ? SURFACES[name] : undefined;
  const preset = condition === undefined ? undefined : presets[presetOf(family, condition)];
  return preset ? withValue(values, SURFACE, valueAt(preset, SURFACE)) : values;
}

/** The values of `to` that `from` does not have, so that they over `from` are `to`. */
function difference(from: Values, to: Values): Values {
  return Object.fromEntries(
    Object.entries(to).flatMap(([key, value]) => {
      const usual = from[key];
      if (!isObject(value) || !isObject(usual)) {
        return JSON.stringify(value) === JSON.stringify(usual) ? [] : [[key, value]];
      }
      const inner = difference(usual, value);
      return Object.keys(inner).length > 0 ? [[key, inner]] : [];
    }),
  );
}

function isSame(a: unknown, b: unknown): boolean {
  const count = distance({ value: a }, { value: b }) + distance({ value: b }, { value: a });
  return count === 0;
}

/** How many values differ. */
function distance(from: Values | undefined, to: Values): number {
  return leaves(difference(from ?? {}, to));
}

function leaves(value: unknown): number {
  if (!isObject(value)) return 1;
  return Object.values(value).reduce<number>((sum, inner) => sum + leaves(inner), 0);
}

function isObject(value: unknown): value is Values {
  return typeof value === "object" && value !== null && !Array.isArray(value);
}
