/** Names of balls and places, and the outcome of a shot in short sentences. */

import type { Outcome, PocketName, RailName, Trace } from "../../engine/index.ts";
import { seenPocket, seenRail } from "./seen.ts";
import { decimal, named, sentence, t } from "../words/translate.ts";

/** Lowest hop (m) that is reported: nearly every elevated cue makes the ball hop a little. */
const REPORTED_HOP = 0.003;

/** Tolerance (m) of the path whose height is read: a tenth of the lowest reported hop. */
const TOLERANCE = REPORTED_HOP / 10;

/** A ball's name within a sentence, as in "red 15": no other ball has it. */
export function ballName(id: string): string {
  if (/^\d+$/.test(id)) return t("ball.numbered", { id });
  const [, kind, number] = /^([a-z]+)-(\d+)$/.exec(id) ?? [];
  if (kind === "red") return t("ball.red-n", { number: number! });
  if (kind !== undefined) return t("ball.other-n", { id: kind, number: number! });
  return BALLS.includes(id) ? named("ball", id)! : t("ball.other", { id });
}

/** A ball's name on a small button: its number, or its name without the article that English has. */
export function shortName(id: string): string {
  return /^\d+$/.test(id) ? id : ballName(id).replace(/^the /, "");
}

/** A ball as players name it within a sentence: one of many reds is "a red". */
export function playedName(id: string): string {
  return isOneRed(id) ? t("ball.a-red") : ballName(id);
}

/** Balls as players name them, for a list: many reds are counted. */
export function playedNames(ids: readonly string[]): string[] {
  const count = ids.filter(isOneRed).length;
  if (count < 2) return ids.map(playedName);
  const names = ids.map((id) => (isOneRed(id) ? t("ball.reds", { count }) : ballName(id)));
  return [...new Set(names)];
}

/**
 * The name of each ball where no two may be equal, as in rows of a table: one of several reds has its number, and
 * the ball `cue` is the white one while another ball is struck.
 */
export function distinctNames(ids: readonly string[], struck: string | null): string[] {
  const several = ids.filter(isOneRed).length > 1;
  return ids.map((id) =>
    several && isOneRed(id) ? ballName(id) : objectName(id, { cue_ball: struck }),
  );
}

/** Whether a ball is one of many reds, as in snooker. */
const isOneRed = (id: string): boolean => /^red-\d+$/.test(id);

/** The name of a ball that is hit: the ball `cue` is the white one while another ball is struck, as in carom. */
export function objectName(id: string, { cue_ball: struck }: Pick<Outcome, "cue_ball">): string {
  return id === "cue" && struck !== null && struck !== "cue" ? t("ball.white") : playedName(id);
}

/** Balls that have a name, not a number. */
const BALLS: readonly string[] = [
  "cue",
  "white",
  "yellow",
  "red",
  "green",
  "brown",
  "blue",
  "pink",
  "black",
];

/** A pocket's name in the picture, as in "top left". */
export function pocketName(pocket: PocketName): string {
  return t(`pocket.${seenPocket(pocket)}`);
}

/** A rail's name in the picture, within a sentence. */
export function railName(rail: RailName): string {
  return t(`rail.${seenRail(rail)}`);
}

/** A length (m) as text: in mm below 1 m, else in m. */
export function lengthText(metres: number): string {
  return metres < 1
    ? t("length.mm", { length: Math.round(metres * 1000) })
    : t("length.m", { length: decimal(metres, 2) });
}

/** A warning if a ball or rail is in the way of the cue; null if none is. */
export function obstruction(outcome: Outcome): string | null {
  const { cue_obstructed: by, least_elevation_deg: least } = outcome;
  return by === null ? null : obstructionBy(by, least);
}

/** The warning that a ball or a rail is in the way. `least` clears it, degrees; null: nothing does. */
export function obstructionBy(by: string, least: number | null): string {
  const obstacle = isRail(by) ? railName(by) : ballName(by);
  if (least === null) return t("obstruction.turn", { obstacle });
  return t("obstruction.raise", { obstacle, degrees: raised(least) });
}

function isRail(name: string): name is RailName {
  return named("rail", name) !== null;
}

/** The least elevation that clears the obstacle, rounded up to a tenth of a degree. */
export function raised(leastElevation: number): number {
  return Math.ceil(leastElevation * 10) / 10;
}

/** The outcome of a shot in sentences, the most important first. */
export function summary(trace: Trace): string[] {
  const { outcome } = trace;
  const cue = outcome.cue_ball;
  const said: string[] = [];
  if (outcome.miscue) said.push(t("outcome.miscue"));
  said.push(contact(outcome));
  for (const [id, pocket] of outcome.pocketed) {
    const drop = { ball: objectName(id, outcome), pocket: pocketName(pocket) };
    if (id !== cue) said.push(sentence(t("outcome.drops", drop)));
  }
  if (outcome.cue_ball_scratched) {
    const pocket = outcome.pocketed.find(([ball]) => ball === cue)?.[1];
    said.push(
      pocket ? t("outcome.scratch-in", { pocket: pocketName(pocket) }) : t("outcome.scratch"),
    );
  }
  for (const id of outcome.off_table) {
    said.push(sentence(t("outcome.off", { ball: objectName(id, outcome) })));
  }
  for (const [id, over] of outcome.jumped) {
    said.push(
      sentence(t("outcome.jumps", { ball: playedName(id), other: objectName(over, outcome) })),
    );
  }
  const hop = cue === null ? 0 : highest(trace, cue);
  if (hop > REPORTED_HOP) {
    said.push(sentence(t("outcome.hops", { ball: ballName(cue!), height: lengthText(hop) })));
  }
  for (const [id, pocket] of outcome.hanging) {
    said.push(sentence(t("outcome.hangs", { ball: playedName(id), pocket: pocketName(pocket) })));
  }
  return said;
}

function contact(outcome: Outcome): string {
  if (outcome.cue_ball === null) return t("outcome.no-strike");
  const count = outcome.rails_before_first_contact.length;
  if (outcome.first_contact === null)
    return count === 0 ? t("outcome.misses") : t("outcome.misses-after", { count });
  const ball = objectName(outcome.first_contact, outcome);
  return count === 0 ? t("outcome.hits", { ball }) : t("outcome.hits-after", { ball, count });
}

/** Greatest height of a ball's lowest point above the cloth (m). */
function highest(trace: Trace, id: string): number {
  const index = trace.shot.balls.findIndex((ball) => ball.id === id);
  const ball = trace.shot.balls[index];
  if (!ball) return 0;
  const points = trace.polyline(index, TOLERANCE);
  let top = 0;
  for (let k = 2; k < points.length; k += 4) top = Math.max(top, points[k]!);
  return top - ball.radius;
}
