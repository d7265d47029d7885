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
  return trace.events.flatMap((event) => {
    const kind = kindOf(event);
    if (kind === null) return [];
    const strength = strengthOf(event, kind);
    if (strength < QUIETEST[kind]) return [];
    const place = event.before[0]?.position[along] ?? side / 2;
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

function strengthOf(event: TraceEvent, kind: ImpactKind): number {
  // A ball that falls keeps its velocity at the hole; it is heard by its speed.
  if (kind === "pocket") return Math.max(0.5, Math.hypot(...event.before[0]!.velocity));
  const changes = event.after.map(({ velocity: [x, y, z] }, k) => {
    const before = event.before[k]!.velocity;
    return Math.hypot(x - before[0], y - before[1], z - before[2]);
  });
  return Math.max(0, ...changes);
}
