/** The engine's verdict on a shot of a drill, in the drill's own terms. */

import type { Point, ShotVerdict, Trace } from "../../engine/index.ts";
import { STRIDE } from "../../engine/types.ts";
import type { Condition, Step } from "./drills/index.ts";
import { type Cloth, goalInMetres } from "./drill-places.ts";

/** What was wrong with a shot: the first condition that it does not meet, or the loss of the cue ball. */
export type Fault =
  | { readonly kind: "scratch" }
  /** The condition, and how far outside its area the cue ball stopped, m. */
  | { readonly kind: "condition"; readonly condition: Condition; readonly distance: number }
  /** A run's shot: another ball was met first, or none. */
  | { readonly kind: "wrong-first"; readonly ball: string }
  /** A run's shot: no ball fell that may fall. */
  | { readonly kind: "no-pot" }
  | { readonly kind: "wrong-ball"; readonly ball: string };

export interface Verdict {
  /** Points of the attempt so far. */
  readonly points: number;
  /** Null if the shot was good. */
  readonly fault: Fault | null;
  /** Balls that a run still has to pot; empty if the attempt is over. */
  readonly left: readonly string[];
}

/** The most points that an attempt can give, without those of a ladder. */
export function mostPoints({ goal }: Step): number {
  if (goal.kind === "run") return goal.balls.length;
  const zones = (goal.zones ?? []).map(({ points }) => points);
  return zones.length > 0 ? Math.max(...zones) : (goal.points ?? 1);
}

/**
 * @param left Balls that the run still has to pot before this shot; a goal of one shot ignores it.
 */
export function judge(
  cloth: Cloth,
  step: Step,
  trace: Trace,
  left: readonly string[] = [],
): Verdict {
  const { fault, ...verdict } = trace.shot.judge(goalInMetres(cloth, step), left);
  return { ...verdict, fault: fault && faultOf(step, fault) };
}

function faultOf({ goal }: Step, fault: NonNullable<ShotVerdict["fault"]>): Fault {
  const { needs = [], zones = [] } = goal.kind === "shot" ? goal : {};
  switch (fault.kind) {
    case "scratch":
    case "no-pot":
      return { kind: fault.kind };
    case "need":
      return { kind: "condition", condition: needs[fault.index]!, distance: fault.distance };
    case "zone": {
      const condition = { kind: "stop", area: zones.at(-1)!.area } as const;
      return { kind: "condition", condition, distance: fault.distance };
    }
    case "wrong-first":
    case "wrong-ball":
      return { kind: fault.kind, ball: fault.ball };
  }
}

/** Where a ball lies at the end, m; null if the shot does not have it. */
export function restOf(trace: Trace, id: string): Point | null {
  const index = trace.shot.balls.findIndex((ball) => ball.id === id);
  if (index < 0) return null;
  const states = trace.statesAt(trace.duration);
  return [states[index * STRIDE]!, states[index * STRIDE + 1]!];
}
