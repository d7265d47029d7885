/** What can be heard of a shot. */

import type { Trace, TraceEvent } from "../engine/index.ts";

export type ImpactKind = "tip" | "ball" | "rail" | "slate" | "pocket";

/** An impact that sounds. */
export interface Impact {
  readonly kind: ImpactKind;
  /** Since the strike, s. */
  readonly time: number;
  /** Change of the fastest ball's velocity, m/s: the impulse per mass. */
  readonly strength: number;
  /** Where it sounds from, −1 (left end of the picture) to 1. */
  readonly pan: number;
}

/** Changes of velocity (m/s) below which nothing is heard. A ball that settles would crackle. */
const QUIETEST: Readonly<Record<ImpactKind, number>> = {
  tip: 0,
  ball: 0.01,
  rail: 0.02,
  slate: 0.05,
  pocket: 0,
};

/** The impacts of a trace, in the order of time. */
export function impactsOf(trace: Trace): Impact[] {
  const [width, length] = trace.shot.geometry.size ?? [1, 1];
  const along = length >= width ? 1 : 0;
  const side = Math.max(width, length);
  const masses = new Map(trace.shot.balls.map(({ id, mass }) => [id, mass]));
  return trace.events.flatMap((event) => {
    const kind = kindOf(event);
    if (kind === null) return [];
    const strength = strengthOf(event, masses);
    if (strength < QUIETEST[kind]) return [];
    const at = "points" in event ? event.points[0] : event.before[0]?.position;
    const place = at?.[along] ?? side / 2;
    const pan = Math.min(1, Math.max(-1, (2 * place) / side - 1));
    return [{ kind, time: event.time, strength, pan }];
  });
}

function kindOf({ type }: TraceEvent): ImpactKind | null {
  switch (type) {
    case "cue-strike":
      return "tip";
    case "ball-collision":
      return "ball";
    case "rail-collision":
      return "rail";
    case "slate-collision":
      return "slate";
    case "pocket-collision":
      return "pocket";
    default:
      return null;
  }
}

function strengthOf(event: TraceEvent, masses: ReadonlyMap<string, number>): number {
  // A ball that falls keeps its velocity at the hole; it is heard by its speed.
  if (!("impulses" in event)) return Math.max(0.5, Math.hypot(...event.before[0]!.velocity));
  const changes = event.impulses.map((impulse, k) => {
    return Math.hypot(...impulse) / masses.get(event.balls[k]!)!;
  });
  return Math.max(0, ...changes);
}
