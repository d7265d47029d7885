/** How event types are drawn: each has its shape and colour, and a lane on the timeline. */

import type { TraceEvent } from "../../engine/index.ts";
import { svg } from "../common/dom.ts";

export type EventType = TraceEvent["type"];

interface EventLook {
  /** A path around the origin, about 8 pixels across. */
  readonly shape: string;
  /** Number of the lane from the top; events of one lane rarely coincide. */
  readonly lane: number;
}

export const LOOKS: Readonly<Record<EventType, EventLook>> = {
  "cue-strike": { shape: "M-3.5-4.5L4.5 0L-3.5 4.5Z", lane: 0 },
  "ball-collision": {
    shape: "M-4 0A4 4 0 1 1 4 0A4 4 0 1 1-4 0Z",
    lane: 0,
  },
  "rail-collision": { shape: "M-3.3-3.3H3.3V3.3H-3.3Z", lane: 1 },
  "slate-collision": { shape: "M0-4.5L4.5 0L0 4.5L-4.5 0Z", lane: 2 },
  "motion-transition": { shape: "M-1.1-4H1.1V4H-1.1Z", lane: 2 },
  "pocket-collision": { shape: "M-4.5-3.5H4.5L0 4.5Z", lane: 3 },
  "off-table": {
    shape: "M-4-2.4L-2.4-4L0-1.6L2.4-4L4-2.4L1.6 0L4 2.4L2.4 4L0 1.6L-2.4 4L-4 2.4L-1.6 0Z",
    lane: 3,
  },
};

export const LANES = 4;

/** The mark of an event type, for the list of events. */
export function mark(type: EventType): SVGSVGElement {
  return svg(
    "svg",
    { viewBox: "-6 -6 12 12", class: `mark ${type}`, "aria-hidden": "true" },
    svg("path", { d: LOOKS[type].shape }),
  );
}
