/** How a ball looks, by its id: the colours of the balls as they are sold. */

/** Appearance of one ball. */
export interface Look {
  /** Colour of the body, and the lighter one of its path where the body is too dark for the cloth. */
  body: string;
  path: string;
  /** A white ball with a band of the body's colour. */
  striped: boolean;
  /** Text in the white circles; empty for none. */
  label: string;
  /** Colour of six small dots that let its spin be seen; empty for none. */
  dots: string;
}

export const IVORY = "#f4eedd";
const RED = "#c62a20";

/** Body and path of the pool balls 1 to 8; 9 to 15 are 1 to 7, striped. */
const POOL: readonly (readonly [string, string])[] = [
  ["#f2b90f", "#ffd23f"],
  ["#1d4fae", "#7fb2ff"],
  [RED, "#ff6a5c"],
  ["#56308f", "#c2a0ff"],
  ["#e8701a", "#ff9d4d"],
  ["#12723f", "#63d897"],
  ["#7a2323", "#d98b80"],
  ["#17181a", "#a3a9b1"],
];

const NAMED: Readonly<Record<string, readonly [body: string, path: string, dots: string]>> = {
  cue: [IVORY, "#ffffff", RED],
  white: [IVORY, "#ffffff", RED],
  spotted: [IVORY, "#d9d4c4", "#17181a"],
  red: [RED, "#ff6a5c", ""],
  yellow: ["#f2b90f", "#ffd23f", ""],
  green: ["#12723f", "#63d897", ""],
  brown: ["#6b3f1d", "#cf9a68", ""],
  blue: ["#1d4fae", "#7fb2ff", ""],
  pink: ["#ee8fa5", "#ffb9c8", ""],
  black: ["#17181a", "#a3a9b1", ""],
  orange: ["#e8701a", "#ff9d4d", ""],
  purple: ["#56308f", "#c2a0ff", ""],
};

/** Bodies of balls with any other name, in turn. */
const OTHERS = [
  "#5b8fd6",
  "#d9ab24",
  "#d9564a",
  "#9a78d6",
  "#db7f36",
  "#43b377",
  "#b36a60",
  "#58b9bd",
] as const;

/** A label of more characters would not be readable on a ball. */
const LABEL_LENGTH = 2;

/**
 * The look of a ball.
 *
 * @param id - The ball's id; `9`, `cue`, `red-4` and `red4` are understood.
 * @param index - Its place in the shot: balls of other names take their colours in this order.
 * @param carom - Whether the table is a carom table, where coloured balls are dotted too.
 */
export function look(id: string, index: number, carom = false): Look {
  const number = /^\d+$/.test(id) ? Number(id) : 0;
  if (number >= 1 && number <= 15) {
    const [body, path] = POOL[(number - 1) % 8]!;
    return { body, path, striped: number > 8, label: String(number), dots: "" };
  }
  const name = id.toLowerCase().replace(/[-_ ]*\d*$/, "");
  const named = Object.hasOwn(NAMED, name) ? NAMED[name] : undefined;
  if (named) {
    const [body, path, dots] = named;
    return { body, path, striped: false, label: "", dots: dots || (carom ? IVORY : "") };
  }
  const body = OTHERS[index % OTHERS.length]!;
  return { body, path: body, striped: false, label: id.slice(0, LABEL_LENGTH), dots: "" };
}
