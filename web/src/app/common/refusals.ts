/**
 * What is wrong, as a sentence for players.
 *
 * The engine's messages name keys of the shot file, in English. The errors of shots that are aimed and played have
 * sentences of their own. Those of files and links have a sentence for their kind, and the engine's words follow it.
 */

import { CaromError, type PocketName, type RailName, type Refusal } from "../../engine/index.ts";
import { decimal, named, sentence, t } from "../words/translate.ts";
import { ballAt, type Balls, faultText, withDetail } from "./file-faults.ts";
import { nameOf } from "./parameter-names.ts";
import { ballName, lengthText, obstructionBy, pocketName, railName } from "./shot-words.ts";

/** A refusal by the page. Its message is already a sentence for players. */
export class PageError extends CaromError {
  constructor(message: string, place = "") {
    super({ kind: "other", place, fault: message, message });
  }
}

/** The text for a refusal; null if this one has none. `ball` is the ball at its place. */
type Text = (refusal: Refusal, ball: string) => string | null;

/** The largest number that is written in a sentence. */
const LARGEST = 1e9;

/** The texts for errors that players cause. */
const TEXTS: Partial<Record<Refusal["kind"], Text>> = {
  overlap: ({ details: { ball, other, depth } }) => {
    const names = { ball: ballName(String(ball)), other: ballName(String(other)) };
    return sentence(t("error.overlap", { ...names, depth: depthText(Number(depth)) }));
  },
  "in-cushion": ({ details: { rail } }, ball) =>
    sentence(t("error.in-rail", { ball, rail: railName(rail as RailName) })),
  "over-pocket": ({ details: { pocket } }, ball) =>
    sentence(t("error.in-pocket", { ball, pocket: pocketName(pocket as PocketName) })),
  "outside-table": (_, ball) => sentence(t("error.outside", { ball })),
  miscue: () => t("error.miscue"),
  "misses-ball": () => t("error.off-ball"),
  "cue-obstructed": ({ details: { ball, rail, least_elevation_deg: least } }) =>
    obstructionBy(String(ball ?? rail), least === undefined ? null : Number(least)),
  "out-of-range": ({ place, details }) => noiseText(place) ?? outOfRange(place, details),
  "too-many-events": () => t("error.too-many-events"),
  "no-call": () => sentence(t("error.no-call")),
  "no-nomination": () => sentence(t("error.no-nomination")),
  "not-called": () => sentence(t("error.not-called")),
  "called-ball-down": () => sentence(t("error.called-ball-gone")),
  "no-safety": () => sentence(t("error.no-safety")),
  "no-push-out": () => sentence(t("error.no-push-out")),
  "wrong-nomination": () => sentence(t("error.wrong-nomination")),
  "outside-region": ({ details: { region } }) => {
    const where = named("error.hand", String(region));
    return where === null ? null : sentence(where);
  },
  "touches-ball": () => sentence(t("error.hand.touches")),
  "not-a-choice": () => sentence(t("error.not-a-choice")),
  "frame-over": () => sentence(t("error.frame-over")),
};

/** The refusal as a sentence. `balls` are those of the refused shot. */
export function refusalText(refusal: Refusal, balls: Balls = []): string {
  return known(refusal, balls) ?? withDetail(faultText(refusal, balls), refusal.message);
}

/** The sentence for an error that players cause; null for another one. */
function known(refusal: Refusal, balls: Balls): string | null {
  const ball = ballAt(refusal.place, balls) ?? t("error.a-ball");
  return TEXTS[refusal.kind]?.(refusal, ball) ?? null;
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

/** Null if the place is not a σ of a noise. */
function noiseText(place: string): string | null {
  const [part, key] = place.split(".");
  const name = part === "noise" && key !== undefined ? named("sigma", key) : null;
  return name === null ? null : t("error.noise", { name });
}

/** Null if the place has no name on the page, or the range has no words. */
function outOfRange(place: string, { value, ...range }: Refusal["details"]): string | null {
  const name = nameOf(place);
  const words = rangeText(range);
  // A larger number has hundreds of digits.
  const isShort = Math.abs(Number(value)) <= LARGEST;
  return name === null || words === null || !isShort
    ? null
    : t("error.range", { name, value: Number(value), range: words });
}

function rangeText({ low, high, open, unit }: Refusal["details"]): string | null {
  if (low === undefined || high === undefined) return null;
  if (Number(high) >= LARGEST) {
    if (Number(low) < 0) return null;
    return t(low === 0 && open === "none" ? "error.range.not-negative" : "error.range.positive");
  }
  const ends = { low: Number(low), high: Number(high), unit: unit ? ` ${unit}` : "" };
  if (open === "low") return t("error.range.above-to", ends);
  return t(open === "high" ? "error.range.from-below" : "error.range.from-to", ends);
}
