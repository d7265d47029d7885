/** The parameters of the physics or table of a shot file, as the schema lists them for a form. */

import { title } from "../common/parameter-names.ts";
import { named, t } from "../words/translate.ts";

export type Values = Readonly<Record<string, unknown>>;

/** One parameter. */
export interface Parameter {
  /** Keys below the part, such as `ball_ball`, `friction`, `a`; in a list the item's number. */
  readonly path: readonly string[];
  readonly kind: "number" | "choice";
  readonly choices: readonly string[];
  /** A hint for users; empty if it needs none. */
  readonly description: string;
  readonly unit: string;
  /** Of a number of a fit or of a list: the hint of the quantity that they give; else empty. */
  readonly quantity: string;
}

/** A part of the shot file that may start from a preset. */
export type Part = "physics" | "table";

export interface Schema {
  readonly type?: string;
  readonly description?: string;
  readonly enum?: readonly string[];
  readonly properties?: Readonly<Record<string, Schema>>;
  readonly items?: Schema;
  readonly oneOf?: readonly Schema[];
  readonly $ref?: string;
  /** Of a number. */
  readonly unit?: string;
  /** What a coefficient may depend on. */
  readonly argument?: "speed" | "angle";
  /** Of a number of a fit: its value where the coefficient is the same at every speed or angle. */
  readonly flat?: number;
}

/** Keys of the path of a quantity: its group's and its own. */
export const QUANTITY = 2;

/** The schema of the quantity at `path`, a group's key and its own; undefined if there is none. */
export function quantitySchema(
  schema: object,
  part: Part,
  path: readonly string[],
): Schema | undefined {
  let found: Schema | undefined = partSchema(schema, part);
  for (const key of path) found = found?.properties?.[key];
  return found;
}

function partSchema(schema: object, part: Part): Schema | undefined {
  const { $defs } = schema as { $defs: Record<string, Schema> };
  return $defs[part]?.oneOf?.find(({ properties }) => properties?.base);
}

/** The parameters that both the schema and `values` have, in the schema's order. */
export function parameters(schema: object, part: Part, values: Values): Parameter[] {
  const { $defs } = schema as { $defs: Record<string, Schema> };
  return Object.entries(partSchema(schema, part)?.properties ?? {}).flatMap(([key, inner]) =>
    key === "base" ? [] : collect({ part, $defs }, [key], inner, values[key]),
  );
}

interface Source {
  readonly part: Part;
  readonly $defs: Readonly<Record<string, Schema>>;
}

function collect(
  source: Source,
  path: readonly string[],
  schema: Schema,
  value: unknown,
  above = "",
): Parameter[] {
  const description = hint(source.part, path);
  const quantity = path.length === QUANTITY ? description : above;
  // A unit in words, such as that of a slope, is in the hint.
  const unit = schema.unit?.includes(" ") ? "" : (schema.unit ?? "");
  const common = { path, description, unit, choices: [], quantity: above };
  if (schema.enum && value !== undefined) {
    return [{ ...common, kind: "choice", choices: schema.enum }];
  }
  if (typeof value === "number") return [{ ...common, kind: "number" }];
  const names = schema.oneOf?.find((choice) => choice.enum)?.enum;
  if (typeof value === "string" && names) return [{ ...common, kind: "choice", choices: names }];
  if (typeof value !== "object" || value === null) return [];
  const full = schema.$ref ? source.$defs[schema.$ref.replace("#/$defs/", "")] : schema;
  if (Array.isArray(value)) {
    // A list that stands for a number, such as speed bands. Other lists have forms of their own.
    const items = full?.oneOf?.find((choice) => choice.type === "array")?.items;
    return value.flatMap((item, k) =>
      items ? collect(source, [...path, String(k)], items, item, quantity) : [],
    );
  }
  const fit = full?.oneOf?.find((choice) => choice.type === "object") ?? full;
  return Object.entries(fit?.properties ?? {}).flatMap(([key, inner]) =>
    collect(source, [...path, key], inner, (value as Values)[key], quantity),
  );
}

/** The value at a path; undefined if there is none. */
export function valueAt(values: Values, path: readonly string[]): unknown {
  let found: unknown = values;
  for (const key of path) {
    found = typeof found === "object" && found !== null ? (found as Values)[key] : undefined;
  }
  return found;
}

/** A copy of `values` with another value at `path`. */
export function withValue(values: Values, path: readonly string[], value: unknown): Values {
  const [key, ...rest] = path;
  if (key === undefined) return values;
  const inner = values[key];
  const below = typeof inner === "object" && inner !== null ? (inner as Values) : {};
  const next = rest.length > 0 ? withValue(below, rest, value) : value;
  if (Array.isArray(values)) {
    return values.map((item: unknown, k) => (String(k) === key ? next : item)) as unknown as Values;
  }
  return { ...values, [key]: next };
}

/**
 * The path of what is written to the file when the value at `path` changes: of the whole list if
 * the value is in one, because a list replaces that of the base.
 */
export function writtenPath(values: Values, path: readonly string[]): readonly string[] {
  const list = path.findIndex((_, k) => Array.isArray(valueAt(values, path.slice(0, k))));
  return list < 0 ? path : path.slice(0, list);
}

/** A copy of `values` without the value at `path` and without objects that become empty. */
export function withoutValue(values: Values, path: readonly string[]): Values {
  const [key, ...rest] = path;
  if (key === undefined || !(key in values)) return values;
  const { [key]: inner, ...others } = values;
  if (rest.length === 0 || typeof inner !== "object" || inner === null) return others;
  const left = withoutValue(inner as Values, rest);
  return Object.keys(left).length > 0 ? { ...others, [key]: left } : others;
}

/** Whether `changes` has a value at `path` that differs from the base. Some files repeat the base. */
export function isChanged(changes: Values, base: Values, path: readonly string[]): boolean {
  const written = writtenPath(changes, path);
  const [own, usual] = [valueAt(changes, written), valueAt(base, written)];
  return own !== undefined && usual !== undefined && JSON.stringify(own) !== JSON.stringify(usual);
}

/** The label of a parameter within its group, or within the fit or list that it belongs to. */
export function label({ path, quantity }: Parameter): string {
  const keys = path.length === 1 ? path : path.slice(quantity === "" ? 1 : QUANTITY);
  const [first = "", inner] = keys;
  if (inner === "up_to" || inner === "friction")
    return t(`band.${inner}`, { number: Number(first) + 1 });
  return keys.map(title).join(", ");
}

/** The hint of a parameter; empty if it needs none. The schema's own text is for programmers. */
function hint(part: Part, path: readonly string[]): string {
  const keys = path.filter((key) => !/^\d+$/.test(key)).map((key) => key.replace(/_deg$/, ""));
  const place = keys[0]?.endsWith("_pocket") ? ["pocket", ...keys.slice(1)] : [part, ...keys];
  return named("hint", place.join(".")) ?? "";
}
