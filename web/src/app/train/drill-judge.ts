/** Judges a shot of a drill from its trace. */

import type { Point, Trace } from "../../engine/index.ts";
import { STRIDE } from "../../engine/types.ts";
import type { Condition, Drill, RunGoal, ShotGoal, Step } from "./drills/index.ts";
import { length } from "../common/length.ts";
import { type Cloth, distanceTo, regionOf } from "./drill-places.ts";

/** Aims at a ball that are tested for a free path: from one edge to the other. */
const AIMS = 41;

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
  return Math.max(1, ...(goal.zones ?? []).map(({ points }) => points));
}

/**
 * @param left Balls that the run still has to pot before this shot; a goal of one shot ignores it.
 */
export function judge(
  cloth: Cloth,
  { cue }: Drill,
  step: Step,
  trace: Trace,
  left: readonly string[] = [],
): Verdict {
  const shot = { cloth, cue, step, trace };
  return step.goal.kind === "run" ? judgeRun(shot, step.goal, left) : judgeShot(shot, step.goal);
}

interface Judged {
  readonly cloth: Cloth;
  readonly cue: string;
  readonly step: Step;
  readonly trace: Trace;
}

function judgeShot(shot: Judged, { needs, zones }: ShotGoal): Verdict {
  const none = { points: 0, left: [] };
  if (lost(shot.trace, shot.cue)) return { ...none, fault: { kind: "scratch" } };
  for (const condition of needs) {
    if (holds(shot, condition)) continue;
    const distance = condition.kind === "stop" ? outside(shot, condition) : 0;
    return { ...none, fault: { kind: "condition", condition, distance } };
  }
  if (!zones) return { points: 1, fault: null, left: [] };
  const zone = zones.find((one) => outside(shot, one) === 0);
  if (zone) return { points: zone.points, fault: null, left: [] };
  const condition = { kind: "stop", area: zones.at(-1)!.area } as const;
  const distance = outside(shot, condition);
  return { ...none, fault: { kind: "condition", condition, distance } };
}

function judgeRun(shot: Judged, { balls, order }: RunGoal, left: readonly string[]): Verdict {
  const { outcome } = shot.trace;
  const last = balls.at(-1)!;
  const ends = (fault: Fault): Verdict => ({
    points: balls.length - left.length,
    fault,
    left: [],
  });
  if (lost(shot.trace, shot.cue)) return ends({ kind: "scratch" });
  const mayBeMet = order === "eight" ? left.filter((ball) => ball !== last) : left.slice(0, 1);
  const next = mayBeMet[0] ?? last;
  const first = outcome.first_contact;
  if (first === null || !(mayBeMet.length === 0 ? [last] : mayBeMet).includes(first)) {
    return ends({ kind: "wrong-first", ball: next });
  }
  const off = outcome.off_table.at(0);
  if (off !== undefined) return ends({ kind: "wrong-ball", ball: off });
  const fell = outcome.pocketed.map(([ball]) => ball);
  const wrong = fell.find(
    (ball) =>
      (order === "sequence" && ball !== next) ||
      (order === "eight" && ball === last && left.some((one) => !fell.includes(one))),
  );
  if (wrong !== undefined) return ends({ kind: "wrong-ball", ball: wrong });
  if (fell.length === 0) return ends({ kind: "no-pot" });
  const wins = order === "rotation" && fell.includes(last);
  const remaining = wins ? [] : left.filter((ball) => !fell.includes(ball));
  return { points: balls.length - remaining.length, fault: null, left: remaining };
}

function lost({ outcome }: Trace, cue: string): boolean {
  return outcome.cue_ball_scratched || outcome.off_table.includes(cue);
}

function holds(shot: Judged, condition: Condition): boolean {
  const { trace, cue } = shot;
  const { outcome } = trace;
  switch (condition.kind) {
    case "pot":
      return outcome.pocketed.some(
        ([ball, pocket]) =>
          ball === condition.ball &&
          (condition.pocket === undefined || condition.pocket === pocket),
      );
    case "pot-any":
      return outcome.pocketed.some(([ball]) => ball !== cue);
    case "first":
      return outcome.first_contact === condition.ball;
    case "kick":
      return outcome.rails_before_first_contact.length >= condition.cushions;
    case "cushions":
      return cushionsOf(trace, condition.ball) >= condition.cushions;
    case "carom":
      return caroms(trace, cue, condition.cushions);
    case "stop":
      return outside(shot, condition) === 0;
    case "hidden":
      return isHidden(trace, cue, condition.ball);
  }
}

/** How often a ball meets a nose: not the jaws of a pocket. */
function cushionsOf(trace: Trace, id: string): number {
  return trace.events.filter(
    (event) => event.type === "rail-collision" && event.part === "nose" && event.balls[0] === id,
  ).length;
}

/** Whether the cue ball meets two balls, the second one after `least` cushions. */
function caroms(trace: Trace, cue: string, least: number): boolean {
  let cushions = 0;
  const met = new Set<string>();
  for (const { type, balls } of trace.events) {
    if (!balls.includes(cue)) continue;
    if (type === "rail-collision") cushions += 1;
    if (type === "ball-collision") {
      const other = balls.find((ball) => ball !== cue)!;
      if (!met.has(other) && met.size === 1) return cushions >= least;
      met.add(other);
    }
  }
  return false;
}

function outside(
  { cloth, cue, step, trace }: Judged,
  { area }: Pick<Extract<Condition, { kind: "stop" }>, "area">,
): number {
  return distanceTo(regionOf(cloth, area, step.balls), restOf(trace, cue)!);
}

/** Where a ball lies at the end, m; null if the shot does not have it. */
export function restOf(trace: Trace, id: string): Point | null {
  const index = trace.shot.balls.findIndex((ball) => ball.id === id);
  if (index < 0) return null;
  const states = trace.statesAt(trace.duration);
  return [states[index * STRIDE]!, states[index * STRIDE + 1]!];
}

/** Whether no straight line leads the cue ball to the ball, past the other balls on the table. */
function isHidden(trace: Trace, cue: string, ball: string): boolean {
  const gone = new Set(trace.outcome.pocketed.map(([id]) => id).concat(trace.outcome.off_table));
  if (gone.has(ball)) return false;
  const from = restOf(trace, cue)!;
  const to = restOf(trace, ball)!;
  const reach = 2 * trace.shot.balls[0]!.radius;
  const others = trace.shot.balls
    .filter(({ id }) => id !== cue && id !== ball && !gone.has(id))
    .map(({ id }) => restOf(trace, id)!);
  const distance = length(to[0] - from[0], to[1] - from[1]);
  const along: Point = [(to[0] - from[0]) / distance, (to[1] - from[1]) / distance];
  for (let k = 0; k < AIMS; k += 1) {
    // The ghost ball of this aim, `aside` from the line through both centres.
    const aside = reach * ((2 * (k + 0.5)) / AIMS - 1);
    const short = Math.sqrt(reach * reach - aside * aside);
    const ghost: Point = [
      to[0] - short * along[0] - aside * along[1],
      to[1] - short * along[1] + aside * along[0],
    ];
    if (others.every((other) => distanceToSegment(other, from, ghost) >= reach)) return false;
  }
  return true;
}

function distanceToSegment([x, y]: Point, [ax, ay]: Point, [bx, by]: Point): number {
  const [dx, dy] = [bx - ax, by - ay];
  const square = dx * dx + dy * dy;
  const share = square === 0 ? 0 : ((x - ax) * dx + (y - ay) * dy) / square;
  const clamped = Math.min(Math.max(share, 0), 1);
  return length(x - ax - clamped * dx, y - ay - clamped * dy);
}
