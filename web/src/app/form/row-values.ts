/** What the rows of a form of parameters show, and what a changed or a reset value writes. */

import { kindOf, type Kind, quantityOf } from "./kinds.ts";
import {
  isChanged,
  type Parameter,
  QUANTITY,
  valueAt,
  type Values,
  withoutValue,
  withValue,
  writtenPath,
} from "./parameters.ts";
import { round } from "../common/units.ts";

/** Decimals shown: lengths to a micrometre, without the rounding errors of binary fractions. */
const DIGITS = 6;

/** The values of a part of the shot file. */
export interface FormValues {
  /** The present values, and those of the preset that the changes start from. */
  readonly now: Values;
  readonly base: Values;
  /** The changes in the shot file, with their `base`. */
  readonly changes: Values;
}

/** A quantity with its numbers: one, or those of a fit or of a list. */
export interface Quantity {
  readonly path: readonly string[];
  /** The hint above the numbers of a fit or of a list; else empty. */
  readonly hint: string;
  /** Bands of a list have the same hints: `isHintRepeated` is true after the first. */
  readonly rows: readonly { readonly parameter: Parameter; readonly isHintRepeated: boolean }[];
}

/** The value of a row as text, and whether the file changes it. */
export function rowValue(values: FormValues, path: readonly string[]): [string, boolean] {
  const { now, base, changes } = values;
  return [textOf(valueAt(now, path)), isChanged(changes, base, path)];
}

/** The kind of a quantity, and whether it is another one than that of the preset. */
export function rowKind(
  { now, base }: FormValues,
  path: readonly string[],
): [Kind | null, boolean] {
  const [kind, usual] = [kindOf(valueAt(now, path)), kindOf(valueAt(base, path))];
  return [kind, kind !== usual];
}

/** The changes of the file with another value at `path`; a value equal to that of the preset is left out. */
export function changesWith(
  { now, base, changes }: FormValues,
  path: readonly string[],
  value: unknown,
): Values {
  const written = writtenPath(now, path);
  const next = written.length < path.length ? valueAt(withValue(now, path, value), written) : value;
  const isSame = textOf(valueAt(base, written)) === textOf(next);
  return isSame ? withoutValue(changes, written) : withValue(changes, written, next);
}

/** Single values, and one group of quantities per object. */
export function grouped(found: readonly Parameter[]): {
  readonly single: readonly Parameter[];
  readonly groups: readonly (readonly [key: string, quantities: readonly Quantity[]])[];
} {
  const inGroups = found.filter(({ path }) => path.length > 1);
  return {
    single: found.filter(({ path }) => path.length === 1),
    groups: byKey(inGroups, 0).map(([key, parameters]) => [
      key,
      byKey(parameters, QUANTITY - 1).map(([, same]) => quantityWith(same)),
    ]),
  };
}

/** The parameters by a key of their paths. */
function byKey(found: readonly Parameter[], index: number): [string, readonly Parameter[]][] {
  const keys = new Set(found.map(({ path }) => path[index]!));
  return [...keys].map((key) => [key, found.filter(({ path }) => path[index] === key)]);
}

function quantityWith(parameters: readonly Parameter[]): Quantity {
  const hints = parameters.map(({ description }) => description);
  const rows = parameters.map((parameter, k) => ({
    parameter,
    isHintRepeated: parameter.quantity !== "" && hints.indexOf(parameter.description) < k,
  }));
  return { path: quantityOf(parameters[0]!), hint: parameters[0]!.quantity, rows };
}

/** The value for the file; null if the text is not a number. */
export function valueOf({ kind }: Parameter, written: string): string | number | null {
  if (kind === "choice") return written;
  const number = written.trim() === "" ? NaN : Number(written);
  return Number.isNaN(number) ? null : number;
}

/** A value of the file as text. */
function textOf(value: unknown): string {
  if (typeof value === "number") return String(round(value, DIGITS));
  if (value === undefined) return "";
  return typeof value === "string" ? value : JSON.stringify(value);
}
