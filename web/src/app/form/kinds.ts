/** Kinds in which a quantity may be given: as a number, or by speed or angle; and changes of the kind. */

import { type Parameter, QUANTITY, type Schema, valueAt, type Values } from "./parameters.ts";
import { t } from "../words/translate.ts";

/** A number; numbers of a formula, such as a + bV; a list of speed bands; or the name of a surface. */
export type Kind = "number" | "fit" | "bands" | "name";

/** The coefficient of a quantity of the present physics at a middle speed or angle. */
export type Coefficient = (key: string, argument: "speed" | "angle") => number;

/** End of the first of two new bands, m/s: about the middle of the speeds at which balls roll. */
const FIRST_END = 1;

const WORDS = {
  number: "kind.number",
  fit: "kind.by-speed",
  bands: "kind.by-speed",
  name: "kind.by-surface",
} as const;

/** The kind in words, for a quantity by its schema. */
export function kindLabel(schema: Schema, kind: Kind): string {
  return t(kind === "fit" && schema.argument === "angle" ? "kind.by-angle" : WORDS[kind]);
}

/** The kind of a value; null if it has none. */
export function kindOf(value: unknown): Kind | null {
  if (typeof value === "number") return "number";
  if (typeof value === "string") return "name";
  if (Array.isArray(value)) return "bands";
  return typeof value === "object" && value !== null ? "fit" : null;
}

/** The quantity that a parameter belongs to. */
export function quantityOf({ path }: Parameter): readonly string[] {
  return path.slice(0, QUANTITY);
}

/**
 * The kinds in which a quantity may be given; empty if there is only one. The names of surfaces are
 * offered only where a file has one, because a preset has its numbers.
 */
export function kinds(schema: Schema | undefined, present: unknown): readonly Kind[] {
  const choices = schema?.oneOf ?? [];
  const found = choices.flatMap(({ type, enum: names }): Kind[] => {
    if (names) return kindOf(present) === "name" ? ["name"] : [];
    if (type === "number") return ["number"];
    if (type === "object") return ["fit"];
    return type === "array" ? ["bands"] : [];
  });
  return found.length > 1 && found.includes("number") ? found : [];
}

/**
 * The value of the quantity at `path` in another kind. If the preset has this kind, it is the value of
 * the preset; otherwise the new value is the same at every speed and angle.
 *
 * @param now The present values.
 * @param base The values of the preset.
 */
export function inKind(
  [path, schema]: readonly [path: readonly string[], schema: Schema],
  kind: Kind,
  { now, base }: { readonly now: Values; readonly base: Values },
  coefficient: Coefficient,
): unknown {
  const [present, usual] = [valueAt(now, path), valueAt(base, path)];
  if (kindOf(present) === kind) return present;
  if (kindOf(usual) === kind) return usual;
  const number =
    typeof present === "number" ? present : coefficient(path.join("."), schema.argument ?? "speed");
  if (kind === "bands") return [{ up_to: FIRST_END, friction: number }, { friction: number }];
  if (kind === "fit") return { ...flat(schema), a: number };
  return number;
}

/** The numbers of a fit that does not depend on speed or angle. */
function flat({ oneOf }: Schema): Values {
  const numbers = oneOf?.find(({ type }) => type === "object")?.properties ?? {};
  return Object.fromEntries(Object.entries(numbers).map(([key, number]) => [key, number.flat]));
}
