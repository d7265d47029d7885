/** The look of a ball by its id, in the colours of commercial balls. */

/** Appearance of one ball. */
export interface Look {
  /** Colour of the ball, and of its path, which is lighter if the ball is too dark for the cloth. */
  body: string;
  path: string;
  /** Whether the ball is white with a stripe of the body's colour. */
  striped: boolean;
  /** Text in the white circles; empty: no circles. */
  label: string;
  /** Colour of six small dots that make the spin visible; empty: no dots. */
  dots: string;
}

export const IVORY = "#f4eedd";
const RED = "#c62a20";

/** Colours of body and path of the pool balls 1 to 8; 9 to 15 are 1 to 7 with stripes. */
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

/** Body colours of other balls, used in turn. */
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

/** Longest label that is readable on a ball, characters. */
const LABEL_LENGTH = 2;

/** An id without the number behind it, and without what is between them. */
function stem(id: string): string {
  let end = id.length;
  while (end > 0 && "0123456789".includes(id[end - 1]!)) end -= 1;
  while (end > 0 && "-_ ".includes(id[end - 1]!)) end -= 1;
  return id.slice(0, end);
}

/**
 * The look of a ball.
 *
 * @param id - The ball's id, such as `9`, `cue`, `red-4` or `red4`.
 * @param index - The ball's index in the shot, which decides the colour of balls with other names.
 * @param carom - Whether the table is a carom table; there coloured balls have dots too.
 */
export function look(id: string, index: number, carom = false): Look {
  const number = /^\d+$/.test(id) ? Number(id) : 0;
  if (number >= 1 && number <= 15) {
    const [body, path] = POOL[(number - 1) % 8]!;
    return { body, path, striped: number > 8, label: String(number), dots: "" };
  }
  const name = stem(id.toLowerCase());
  const named = Object.hasOwn(NAMED, name) ? NAMED[name] : undefined;
  if (named) {
    const [body, path, dots] = named;
    return { body, path, striped: false, label: "", dots: dots || (carom ? IVORY : "") };
  }
  const body = OTHERS[index % OTHERS.length]!;
  return { body, path: body, striped: false, label: id.slice(0, LABEL_LENGTH), dots: "" };
}
