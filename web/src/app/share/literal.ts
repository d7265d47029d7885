/** Plain data as JSON or Python text that reads back to the same bits. */

/** The widest line, in characters, before a list or an object is broken over several lines. */
const WIDTH = 96;

interface Dialect {
  /** The words for true, false and null. */
  words: { true: string; false: string; null: string };
  /** Text after the last entry of a list over several lines. */
  trailing: string;
}

const JSON_DIALECT: Dialect = {
  words: { true: "true", false: "false", null: "null" },
  trailing: "",
};

const PYTHON_DIALECT: Dialect = {
  words: { true: "True", false: "False", null: "None" },
  trailing: ",",
};

/** Compact JSON that keeps negative zeros. */
export function toJson(value: unknown): string {
  return inline(value, JSON_DIALECT);
}

/** Readable JSON: a value stays on one line if it fits. */
export function toPrettyJson(value: unknown): string {
  return broken(value, "", 0, JSON_DIALECT);
}

/** A Python expression that evaluates to the same data. */
export function toPython(value: unknown): string {
  return broken(value, "", 0, PYTHON_DIALECT);
}

function scalar(value: unknown, dialect: Dialect): string | null {
  if (value === null) return dialect.words.null;
  switch (typeof value) {
    case "boolean":
      return value ? dialect.words.true : dialect.words.false;
    case "number":
      if (!Number.isFinite(value))
        throw new TypeError(`a shot file cannot contain ${value}; use a finite number`);
      // JSON.stringify drops the sign of a negative zero, which would change the hash.
      return Object.is(value, -0) ? "-0.0" : String(value);
    case "string":
      // The escapes of JSON have the same meaning in Python.
      return JSON.stringify(value);
    default:
      return null;
  }
}

function entries(value: object): [string, unknown][] {
  const all = Array.isArray(value)
    ? value.map((item): [string, unknown] => ["", item])
    : Object.entries(value).map(([key, item]): [string, unknown] => [
        `${JSON.stringify(key)}: `,
        item,
      ]);
  return all.filter(([, item]) => item !== undefined);
}

function brackets(value: object): [string, string] {
  return Array.isArray(value) ? ["[", "]"] : ["{", "}"];
}

function inline(value: unknown, dialect: Dialect): string {
  const simple = scalar(value, dialect);
  if (simple !== null) return simple;
  const object = value as object;
  const [open, close] = brackets(object);
  const items = entries(object).map(([key, item]) => key + inline(item, dialect));
  return open + items.join(", ") + close;
}

/** `used`: characters already on the line before the value. */
function broken(value: unknown, indent: string, used: number, dialect: Dialect): string {
  const short = inline(value, dialect);
  if (scalar(value, dialect) !== null || used + short.length <= WIDTH) return short;
  const object = value as object;
  const [open, close] = brackets(object);
  const deeper = `${indent}  `;
  const lines = entries(object).map(
    ([key, item]) => deeper + key + broken(item, deeper, deeper.length + key.length + 1, dialect),
  );
  return `${open}\n${lines.join(",\n")}${dialect.trailing}\n${indent}${close}`;
}
