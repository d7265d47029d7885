/**
 * What is wrong with a file or link, as a sentence for players: where, and what kind of fault.
 *
 * The engine names keys of the file, in English. They stay after the sentence, for those who write files by hand.
 */

import type { Refusal } from "../../engine/index.ts";
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

/** The text for a fault at `where`. */
type Text = (where: string, details: Refusal["details"]) => string;

/** The texts for faults of files, by their kind. */
const FAULTS: Partial<Record<Refusal["kind"], Text>> = {
  syntax: (where, { line }) =>
    line === undefined ? t("fault.other", { where }) : t("fault.not-json", { line: Number(line) }),
  "duplicate-id": (_, { id }) => t("fault.same-id", { id: String(id) }),
  "ball-count": (_, { count }) => t("fault.balls", { count: Number(count) }),
  "unknown-ball": (where, { ball }) =>
    ball === undefined
      ? t("fault.other", { where })
      : t("fault.no-ball", { where, id: String(ball) }),
  "unknown-name": (where, { name }) =>
    name === undefined
      ? t("fault.other", { where })
      : t("fault.unknown-word", { where, word: String(name) }),
  "not-a-move": () => t("fault.no-move"),
  moving: (where) => t("fault.moves", { where }),
  "not-on-cloth": (where) => t("fault.not-on-cloth", { where }),
  "in-slate": (where) => t("fault.in-slate", { where }),
  "wrong-radius": (where) => t("fault.radius", { where }),
  changed: () => t("fault.changed"),
  "no-strike": () => t("fault.no-strike"),
  missing: (where) => t("fault.missing", { where }),
  "unknown-key": (where) => t("fault.unknown-key", { where }),
  duplicate: (where) => t("fault.twice", { where }),
  "out-of-range": (where) => t("fault.number", { where }),
  "wrong-type": (where) => t("fault.kind", { where }),
  "wrong-count": (where) => t("fault.kind", { where }),
};

/** The fault without the engine's words. */
export function faultText({ kind, place, details }: Refusal, balls: Balls): string {
  // The place of an unknown key is the key itself.
  const at = kind === "unknown-key" ? place.slice(0, Math.max(0, place.lastIndexOf("."))) : place;
  const where = whereText(at, balls);
  return FAULTS[kind]?.(where, details) ?? t("fault.other", { where });
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
