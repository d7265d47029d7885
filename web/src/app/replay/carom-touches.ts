/** The balls and cushions that a replay counts on a table without pockets. */

import type { Trace, TraceEvent } from "../../engine/index.ts";
import { objectName } from "../common/shot-words.ts";
import { t } from "../words/translate.ts";
import { eventInWords } from "./replay-words.ts";

/** What the cue ball has touched up to an event that counts. */
interface Touch {
  readonly event: number;
  readonly kind: "cushion" | "first" | "second";
  readonly balls: number;
  readonly cushions: number;
}

const known = new WeakMap<Trace, readonly Touch[]>();

/** The events that count, in order; none on a table with pockets. */
export function touchesOf(trace: Trace): readonly Touch[] {
  let touches = known.get(trace);
  if (!touches) {
    touches = trace.shot.geometry.pockets.length === 0 ? counted(trace) : [];
    known.set(trace, touches);
  }
  return touches;
}

function counted(trace: Trace): Touch[] {
  const met = new Set<string>();
  let cushions = 0;
  return trace.countedTouches().flatMap(([event, ball]): Touch[] => {
    if (ball === null) {
      cushions += 1;
      return [{ event, kind: "cushion", balls: met.size, cushions }];
    }
    // The first ball may be met again.
    if (met.has(ball)) return [];
    met.add(ball);
    return [{ event, kind: met.size === 1 ? "first" : "second", balls: met.size, cushions }];
  });
}

/** An event of a trace as text, with its number where it counts. */
export function tracedEvent(trace: Trace, event: TraceEvent): string {
  const words = eventInWords(event, (id) => objectName(id, trace.outcome));
  const touch = touchesOf(trace).find((one) => trace.events[one.event] === event);
  if (!touch) return words;
  return touch.kind === "cushion"
    ? t("carom.event.cushion", { event: words, number: touch.cushions })
    : t(`carom.event.${touch.kind}`, { event: words });
}

/** What has been counted until a time (s): "1 ball, 2 cushions"; empty before the first touch. */
export function countText(trace: Trace, time: number): string {
  const last = touchesOf(trace).findLast((touch) => trace.events[touch.event]!.time <= time);
  if (!last) return "";
  const { balls, cushions } = last;
  return [t("carom.balls", { count: balls }), t("carom.cushions", { count: cushions })].join(
    t("lines.gap"),
  );
}
