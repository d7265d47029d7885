/**
 * What is wrong, as a sentence for players.
 *
 * The engine's messages name keys of the shot file, in English. Those of shots that are aimed and played are
 * replaced here. The others are faults of files and links: their place and kind become a sentence, and the
 * engine's words follow it.
 */

import { CaromError, type PocketName, type RailName } from "../../engine/index.ts";
import { decimal, named, type PlainKey, sentence, t } from "../words/translate.ts";
import { ballAt, type Balls, faultText, withDetail } from "./file-faults.ts";
import { nameOf } from "./parameter-names.ts";
import { ballName, lengthText, obstructionBy, pocketName, railName } from "./shot-words.ts";

/** A refusal by the page. Its message is already a sentence for players. */
export class PageError extends CaromError {}

/** The part of an engine's error that is read here; a worker sends only this. */
export interface Refused {
  readonly message: string;
  readonly place: string;
}

type Rule = readonly [
  pattern: RegExp,
  text: (found: RegExpExecArray, ball: string) => string | null,
];

/** The largest number that is written in a sentence. */
const LARGEST = 1e9;

/** Patterns of the engine's messages, in the crates `carom` and `carom-rules`. */
const RULES: readonly Rule[] = [
  [
    /" overlaps balls\[\d+\] \("/,
    ({ input }) => {
      const id = between(input, 'ball "', '" overlaps balls[');
      const other = between(input, '] ("', '") by ');
      const depth = parseFloat(input.slice(input.lastIndexOf('") by ') + '") by '.length));
      if (id === null || other === null || Number.isNaN(depth)) return null;
      const names = { ball: ballName(id), other: ballName(other) };
      return sentence(t("error.overlap", { ...names, depth: depthText(depth) }));
    },
  ],
  [
    /m deep in the \w+ of the ([\w-]+) cushion/,
    ([, rail], ball) => sentence(t("error.in-rail", { ball, rail: railName(rail as RailName) })),
  ],
  [
    /the ball stands over the ([\w-]+) pocket/,
    ([, pocket], ball) =>
      sentence(t("error.in-pocket", { ball, pocket: pocketName(pocket as PocketName) })),
  ],
  [
    /the ball is (?:outside the table|beyond the rails)/,
    (_, ball) => sentence(t("error.outside", { ball })),
  ],
  [/a miscue: /, () => t("error.miscue")],
  [/the tip would miss the ball/, () => t("error.off-ball")],
  [
    /the cue would pass through /,
    ({ input }) => {
      const by =
        between(input, 'pass through ball "', '"; ') ??
        between(input, "pass through the ", " rail; ");
      const least = parseFloat(between(input, "raise the elevation to ", "") ?? "");
      return by === null ? null : obstructionBy(by, Number.isNaN(least) ? null : least);
    },
  ],
  [
    /^noise\.(\w+): \S+ is out of range/,
    ([, key]) => {
      const name = named("sigma", key!);
      return name === null ? null : t("error.noise", { name });
    },
  ],
  [
    /^([\w.[\]]+): (\S+) is out of range; write (.+)$/,
    ([, place, value, wanted]) => outOfRange(place!, Number(value), wanted!),
  ],
  [/^max_events: /, () => t("error.too-many-events")],
  ...sentences([
    [/^call: nothing is called/, "error.no-call"],
    [/^call: no ball is nominated/, "error.no-nomination"],
    [/^call: this shot is not called/, "error.not-called"],
    [/^call: the called ball is not on the table/, "error.called-ball-gone"],
    [/^call: a safety is not called/, "error.no-safety"],
    [/^call: a push-out is allowed only/, "error.no-push-out"],
    [/^call: that ball cannot be nominated/, "error.wrong-nomination"],
    [/^cue_ball: .* is not behind the head string/s, "error.hand.behind-head-string"],
    [/^cue_ball: .* is not in the D/s, "error.hand.the-d"],
    [/^cue_ball: .* is not on the table/s, "error.hand.on-table"],
    [/^cue_ball: it would touch another ball/, "error.hand.touches"],
    [/^choice: ".*" is not among the choices/s, "error.not-a-choice"],
    [/^concede: the frame is over/, "error.frame-over"],
  ]),
];

/** The text between the first `from` and the next `to`; null if one of them is missing. */
function between(text: string, from: string, to: string): string | null {
  const start = text.indexOf(from) + from.length;
  if (start < from.length) return null;
  const end = to === "" ? text.length : text.indexOf(to, start);
  return end < 0 ? null : text.slice(start, end);
}

function sentences(rules: readonly (readonly [RegExp, PlainKey])[]): Rule[] {
  return rules.map(([pattern, key]) => [pattern, () => sentence(t(key))]);
}

/** The refusal as a sentence. `balls` are those of the refused shot. */
export function refusalText({ message, place }: Refused, balls: Balls = []): string {
  return known({ message, place }, balls) ?? withDetail(faultText(message, place, balls), message);
}

/** The sentence for an error that players cause; null for another one. */
function known({ message, place }: Refused, balls: Balls): string | null {
  const ball = ballAt(place, balls) ?? t("error.a-ball");
  for (const [pattern, text] of RULES) {
    const found = pattern.exec(message);
    if (!found) continue;
    const said = text(found, ball);
    if (said !== null) return said;
  }
  return null;
}

/** Any error as text: a refusal for players, or type and message of another error. */
export function errorText(error: unknown, balls: Balls = []): string {
  if (error instanceof PageError) return error.message;
  if (error instanceof CaromError) return refusalText(error, balls);
  return error instanceof Error ? `${error.name}: ${error.message}` : String(error);
}

/** As `errorText`, for files and links: those who write them by hand always get the engine's words, too. */
export function detailedText(error: unknown, balls: Balls = []): string {
  const text = errorText(error, balls);
  const isOurs = error instanceof PageError || !(error instanceof CaromError);
  return isOurs || text.includes(error.message) ? text : withDetail(text, error.message);
}

/** Most overlaps are below a millimetre, so they have a decimal. */
function depthText(metres: number): string {
  return metres < 0.1 ? t("length.mm", { length: decimal(1000 * metres, 1) }) : lengthText(metres);
}

/** Null if the place has no name on the page, or the range is of another form. */
function outOfRange(place: string, value: number, wanted: string): string | null {
  const name = nameOf(place);
  const range = rangeText(wanted);
  // Such a number has hundreds of digits.
  const isLong = Math.abs(value) > LARGEST;
  return name === null || range === null || isLong
    ? null
    : t("error.range", { name, value, range });
}

function rangeText(wanted: string): string | null {
  if (wanted.startsWith("a number greater than 0")) return t("error.range.positive");
  if (wanted.startsWith("a number ≥ 0")) return t("error.range.not-negative");
  const [, open, low, high, close, unit] =
    /^a number in ([[(])([^,\s]+), ([^\])\s]+)([\])])((?: [^\s(]+)?)/.exec(wanted) ?? [];
  if (open === undefined) return null;
  const ends = { low: Number(low), high: Number(high), unit: unit! };
  if (open === "(") return t("error.range.above-to", ends);
  return close === ")" ? t("error.range.from-below", ends) : t("error.range.from-to", ends);
}
