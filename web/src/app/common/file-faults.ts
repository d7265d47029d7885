/**
 * What is wrong with a file or link, as a sentence for players: where, and what kind of fault.
 *
 * The engine names keys of the file, in English. They stay after the sentence, for those who write files by hand.
 */

import { capital, named, t } from "../words/translate.ts";
import { nameOf } from "./parameter-names.ts";
import { ballName } from "./shot-words.ts";

/** The balls of a refused file; an id may be of any type. */
export type Balls = readonly { readonly id?: unknown }[];

/** Parts in which the places of a file can be: a trace has its shot, a game its start and its plays. */
const PART = /^(?:shot|from|setup|options|game|study|play|record|moves\[\d+\])$/;

/** A place without the parts that contain it. */
function withoutParts(place: string): string {
  let at = 0;
  for (;;) {
    const dot = place.indexOf(".", at);
    if (dot < 0 || !PART.test(place.slice(at, dot)) || !/^[a-z]/.test(place.charAt(dot + 1))) {
      return place.slice(at);
    }
    at = dot + 1;
  }
}

/** Faults by the engine's words for them, from the rarest to the most general. */
const FAULTS: readonly (readonly [
  pattern: RegExp,
  text: (where: string, found: RegExpExecArray) => string,
])[] = [
  [/not JSON/, (where, { input }) => notJson(input) ?? t("fault.other", { where })],
  [/^"(.*)" is already the id of/s, (_, [, id]) => t("fault.same-id", { id: id! })],
  [/^found (\d+) balls/, (_, [, count]) => t("fault.balls", { count: Number(count) })],
  [
    /^(?:no ball has the id|there is no ball) "?([^"]*)"?/,
    (where, [, id]) => t("fault.no-ball", { where, id: id! }),
  ],
  [
    /^there is no [^"]*"([^"]*)"/,
    (where, [, word]) => t("fault.unknown-word", { where, word: word! }),
  ],
  [/^not a play, a choice/, () => t("fault.no-move")],
  [/^ball .* is already moving/s, (where) => t("fault.moves", { where })],
  [/^ball .* does not lie on the cloth/s, (where) => t("fault.not-on-cloth", { where })],
  [/^the ball is .* deep in the slate/s, (where) => t("fault.in-slate", { where })],
  [/^a ball of radius/, (where) => t("fault.radius", { where })],
  [/hash to/, () => t("fault.changed")],
  [/^the shot has no strike/, () => t("fault.no-strike")],
  [/^the key is missing|^found (?:null|nothing)/, (where) => t("fault.missing", { where })],
  [/^unknown key/, (where) => t("fault.unknown-key", { where })],
  [
    /occurs twice|is listed twice|gives the same angle|describe the same property/,
    (where) => t("fault.twice", { where }),
  ],
  [
    /out of range|not a whole number|not a number|too large|is no coefficient|not above the end/,
    (where) => t("fault.number", { where }),
  ],
  [/^found /, (where) => t("fault.kind", { where })],
];

/** The line in which a text is not JSON, as a sentence; null if the message has none. */
function notJson(message: string): string | null {
  const at = message.lastIndexOf("line ");
  const line = at < 0 ? NaN : parseInt(message.slice(at + "line ".length), 10);
  return Number.isNaN(line) ? null : t("fault.not-json", { line });
}

/** The fault without the engine's words. */
export function faultText(message: string, place: string, balls: Balls): string {
  const what = message.startsWith(`${place}: `) ? message.slice(place.length + 2) : message;
  // The place of an unknown key is the key itself.
  const at = what.startsWith("unknown key")
    ? place.slice(0, Math.max(0, place.lastIndexOf(".")))
    : place;
  const where = whereText(at, balls);
  for (const [pattern, text] of FAULTS) {
    const found = pattern.exec(what);
    if (found) return text(where, found);
  }
  return t("fault.other", { where });
}

/** The most of the engine's words that follow a sentence, characters: the rest lists the keys of a part. */
const LONGEST = 160;

/** A sentence with the engine's words behind it. */
export function withDetail(text: string, message: string): string {
  const isLong = message.length > LONGEST;
  return t("fault.detail", {
    text,
    message: isLong ? `${message.slice(0, LONGEST).trimEnd()} …` : message,
  });
}

/** The ball in whose entry a place is; null if it is in none. */
export function ballAt(place: string, balls: Balls): string | null {
  const index = /(?:^|\.)balls\[(\d+)\]/.exec(place)?.[1];
  if (index === undefined) return null;
  const id = balls[Number(index)]?.id;
  return typeof id === "string" && id !== ""
    ? ballName(id)
    : t("where.ball-number", { number: Number(index) + 1 });
}

/** A place of a file as players say it. */
function whereText(place: string, balls: Balls): string {
  const own = withoutParts(place);
  const name = nameOf(own);
  if (name !== null) return name;
  const ball = ballAt(own, balls);
  const [, part = ""] = /^(\w*)/.exec(own)!;
  const key = /^(?:balls\[\d+\]|noise|strike)\.(\w+)/.exec(own)?.[1];
  const what = key === undefined ? null : (named("where", key) ?? named("sigma", key));
  if (ball !== null) {
    return capital(what === null ? ball : t("where.of", { whole: ball, part: what }));
  }
  const whole = named("where", part) ?? t("where.file");
  return what === null ? whole : t("where.of", { whole, part: what });
}
