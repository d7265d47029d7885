/** Events as text. */

import type { Motion, TraceEvent } from "../../engine/index.ts";
import { ballName, pocketName, railName } from "../common/shot-words.ts";
import { decimal, list, t } from "../words/translate.ts";

/** An event as text, for the list of events and the slider. @param name The name of a ball. */
export function eventInWords(event: TraceEvent, name: (id: string) => string = ballName): string {
  const names = event.balls.map(name);
  const [ball = ""] = names;
  switch (event.type) {
    case "cue-strike":
      return strikeInWords(event, ball, names.slice(1));
    case "ball-collision":
      return t("event.collide", { balls: list(names) });
    case "rail-collision": {
      const key = event.part === "nose" ? "event.rail" : (`event.part.${event.part}` as const);
      return t(key, { ball, rail: railName(event.rail) });
    }
    case "pocket-collision":
      return t("event.drops", { ball, pocket: pocketName(event.pocket) });
    case "motion-transition":
      return transitionInWords(ball, event.from, event.to);
    case "slate-collision":
      return t("event.lands", { ball });
    case "off-table":
      return t("event.off", { ball });
  }
}

function strikeInWords(
  { tip_contacts = 1, pushed = false }: TraceEvent & { type: "cue-strike" },
  ball: string,
  moved: readonly string[],
): string {
  const event =
    moved.length > 0
      ? t("event.strike-moves", { ball, others: list(moved) })
      : t("event.strike", { ball });
  const faults = [
    ...(tip_contacts > 1 ? [t("event.double-hit")] : []),
    ...(pushed ? [t("event.push")] : []),
  ];
  return faults.length > 0 ? t("event.with-faults", { event, faults: faults.join(", ") }) : event;
}

function transitionInWords(ball: string, from: Motion, to: Motion): string {
  if (to === "stationary") return t("event.rests", { ball });
  if (to === "airborne") return t("event.lifts", { ball });
  if (to === from) return t("event.slower", { ball, motion: t(`motion.${to}`) });
  return t("event.motion", { ball, from: t(`motion.${from}`), to: t(`motion.${to}`) });
}

/** Radians per second in revolutions per minute. */
export function rpm(angularSpeed: number): number {
  return (angularSpeed * 60) / (2 * Math.PI);
}

/** A time of the shot, "1.234 s". */
export function seconds(time: number): string {
  return t("replay.seconds", { seconds: decimal(time, 3) });
}
