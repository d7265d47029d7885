/** Names of balls and places, and the outcome of a shot in short sentences. */

import { CaromError, type Outcome, type Trace } from "../../engine/index.ts";
import { lengthText } from "./units.ts";

/** Lowest hop (m) that is reported: nearly every elevated cue makes the ball hop a little. */
const REPORTED_HOP = 0.003;

/** Tolerance (m) of the path whose height is read: a tenth of the lowest reported hop. */
const TOLERANCE = REPORTED_HOP / 10;

/** A ball's name within a sentence. */
export function ballName(id: string): string {
  if (/^\d+$/.test(id)) return `ball ${id}`;
  return /^[a-z]+-\d+$/.test(id) ? id.replace("-", " ") : `the ${id}${id === "cue" ? " ball" : ""}`;
}

/** A rail's or pocket's name within a sentence. */
export function placeName(name: string): string {
  return name.replace("-", " ");
}

/** A text as a sentence: with a capital and a full stop. */
export function sentence(text: string): string {
  return `${text.charAt(0).toUpperCase()}${text.slice(1)}.`;
}

/** A warning if a ball or rail is in the way of the cue; null if none is. */
export function obstruction(outcome: Outcome): string | null {
  const { cue_obstructed: by, least_elevation_deg: least } = outcome;
  if (by === null) return null;
  const what = /^(left|right|top|bottom)/.test(by) ? `the ${placeName(by)} rail` : ballName(by);
  const remedy =
    least === null ? "aim in another direction" : `raise it to ${raised(least)}° or more`;
  return `The cue would pass through ${what}: ${remedy}.`;
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
  if (outcome.miscue) said.push("Miscue: the tip would slip off the ball.");
  said.push(contact(outcome));
  for (const [ball, pocket] of outcome.pocketed) {
    if (ball !== cue)
      said.push(sentence(`${ballName(ball)} drops in the ${placeName(pocket)} pocket`));
  }
  if (outcome.cue_ball_scratched) {
    const pocket = outcome.pocketed.find(([ball]) => ball === cue)?.[1];
    said.push(pocket ? `Scratch in the ${placeName(pocket)} pocket.` : "Scratch.");
  }
  for (const ball of outcome.off_table) said.push(sentence(`${ballName(ball)} leaves the table`));
  for (const [ball, over] of outcome.jumped) {
    said.push(sentence(`${ballName(ball)} jumps over ${ballName(over)}`));
  }
  const hop = cue === null ? 0 : highest(trace, cue);
  if (hop > REPORTED_HOP) said.push(sentence(`${ballName(cue!)} hops ${lengthText(hop)} high`));
  for (const [ball, pocket] of outcome.hanging) {
    said.push(sentence(`${ballName(ball)} hangs at the ${placeName(pocket)} pocket`));
  }
  return said;
}

function contact(outcome: Outcome): string {
  if (outcome.cue_ball === null) return "No ball is struck.";
  const rails = outcome.rails_before_first_contact.length;
  const after = rails > 0 ? ` after ${rails} ${rails === 1 ? "rail" : "rails"}` : "";
  if (outcome.first_contact === null) return `Hits no ball${after}.`;
  return `Hits ${ballName(outcome.first_contact)} first${after}.`;
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

/** An error as text: the engine's own message, or type and message of any other error. */
export function errorText(error: unknown): string {
  if (error instanceof CaromError) return error.message;
  return error instanceof Error ? `${error.name}: ${error.message}` : String(error);
}
