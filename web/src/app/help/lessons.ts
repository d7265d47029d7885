/** The first shots of somebody who has never seen the page. */

import type { PocketName, Point, Trace } from "../../engine/index.ts";
import { STRIDE } from "../../engine/types.ts";
import type { AimedShot } from "../document/document.ts";
import type { PlainKey } from "../words/translate.ts";

export interface Lesson {
  readonly text: PlainKey;
  readonly shot: AimedShot;
  /** The ball that is to fall, and its pocket. */
  readonly ball: string;
  readonly pocket: PocketName;
  /** Where the cue ball is to stop; null: anywhere on the table. */
  readonly circle: { readonly center: Point; readonly radius: number } | null;
}

export const LESSONS: readonly Lesson[] = [
  {
    // The cue points a little beside an easy cut.
    text: "steps.pot",
    shot: {
      format: "carom-shot/1",
      table: "wpa-9ft",
      balls: [
        { id: "cue", position: [0.42, 0.72] },
        { id: "9", position: [0.86, 1.74] },
        { id: "1", position: [0.35, 1.62] },
        { id: "3", position: [0.98, 0.9] },
      ],
      strike: { ball: "cue", speed: 2, azimuth_deg: 65 },
    },
    ball: "9",
    pocket: "top-right",
    circle: null,
  },
  {
    // A straight shot: without draw the cue ball follows the 1.
    text: "steps.stop",
    shot: {
      format: "carom-shot/1",
      table: "wpa-9ft",
      balls: [
        { id: "cue", position: [0.63, 1.42] },
        { id: "1", position: [0.9, 1.9] },
        { id: "9", position: [0.3, 0.7] },
      ],
      strike: { ball: "cue", speed: 1.5, azimuth_deg: 60.64 },
    },
    ball: "1",
    pocket: "top-right",
    circle: { center: [0.872, 1.85], radius: 0.1 },
  },
];

/** Whether a shot does what its lesson asks for. */
export function isDone({ ball, pocket, circle }: Lesson, trace: Trace): boolean {
  const { pocketed, cue_ball_scratched: scratched } = trace.outcome;
  if (scratched || !pocketed.some(([id, into]) => id === ball && into === pocket)) return false;
  if (!circle) return true;
  const { struck } = trace.shot;
  const [x, y] = trace.statesAt(trace.duration).subarray(STRIDE * struck!);
  return Math.hypot(x! - circle.center[0], y! - circle.center[1]) <= circle.radius;
}
