/** The first contact of the aimed shot with a ball, as far as the guide shows it. */

import type { Trace } from "../../../engine/index.ts";
import type { Guide } from "../../document/stored-game.ts";
import { firstMeeting } from "../../pot/first-contact.ts";
import { endOfAimLine } from "./short-paths.ts";

type Place = readonly [x: number, y: number, z: number];

export interface ShownContact {
  /** Centre of the struck ball at the contact: the ghost ball, m. */
  readonly ghost: Place;
  /** Centre of the ball that it meets, m. */
  readonly other: Place;
}

/** Null without a contact, and where the guide does not show it: the short one ends at the first cushion. */
export function shownContact(trace: Trace, guide: Guide): ShownContact | null {
  const contact = guide === "none" ? null : firstMeeting(trace, "cue-strike", "ball-collision");
  if (!contact || (guide === "short" && contact.event !== endOfAimLine(trace))) return null;
  const { before } = contact.event;
  const other = before.findIndex((_, k) => k !== contact.own);
  return { ghost: before[contact.own]!.position, other: before[other]!.position };
}
