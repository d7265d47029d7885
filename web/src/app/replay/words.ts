/** Events as text. */

import type { CushionPart, Motion, RailName, TraceEvent } from "../../engine/index.ts";
import { ballName, placeName } from "../common/words.ts";

/** An event as text, for the list of events and the slider. */
export function eventInWords(event: TraceEvent): string {
  const names = event.balls.map(ballName);
  const [first = ""] = names;
  switch (event.type) {
    case "cue-strike":
      return strikeInWords(event, first, names.slice(1));
    case "ball-collision":
      return `${listInWords(names)} collide`;
    case "rail-collision":
      return `${first} hits ${railInWords(event.rail, event.part)}`;
    case "pocket-collision":
      return `${first} drops into the ${placeName(event.pocket)} pocket`;
    case "motion-transition":
      return `${first} ${transitionInWords(event.from, event.to)}`;
    case "slate-collision":
      return `${first} lands`;
    case "off-table":
      return `${first} leaves the table`;
  }
}

function strikeInWords(
  { tip_contacts = 1, pushed = false }: TraceEvent & { type: "cue-strike" },
  struck: string,
  moved: readonly string[],
): string {
  const others = moved.length > 0 ? `, which moves ${listInWords(moved)}` : "";
  const faults = [tip_contacts > 1 && "double hit", pushed && "push"].filter(Boolean);
  return `cue strikes ${struck}${others}${faults.length > 0 ? ` (${faults.join(", ")})` : ""}`;
}

function transitionInWords(from: Motion, to: Motion): string {
  if (to === "stationary") return "comes to rest";
  if (to === "airborne") return "leaves the cloth";
  if (to === from) return `goes on ${to} in a slower speed band`;
  return `stops ${from}, starts ${to}`;
}

function railInWords(rail: RailName, part: CushionPart): string {
  const name = `the ${placeName(rail)} rail`;
  return part === "nose" ? name : `the ${part} of ${name}`;
}

/** "a", "a and b", "a, b and c". */
export function listInWords(items: readonly string[]): string {
  if (items.length < 2) return items.join("");
  return `${items.slice(0, -1).join(", ")} and ${items.at(-1)}`;
}

/** Radians per second in revolutions per minute. */
export function rpm(angularSpeed: number): number {
  return (angularSpeed * 60) / (2 * Math.PI);
}

/** A time of the shot, "1.234 s". */
export function seconds(time: number): string {
  return `${time.toFixed(3)} s`;
}
