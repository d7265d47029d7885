/** The shots of a plan on the table: a number, a dash and a colour tell them apart, also in grey. */

import type { DrawnMark, Engine, MarkColor, Point, Trace } from "../../engine/index.ts";
import { VERTEX } from "../../viewer/viewer-types.ts";
import type { Leg } from "./desk/desk-protocol.ts";

/** Tolerance (m) of the lines: a third of their width on a large screen. */
const TOLERANCE = 0.002;

/** The lines of the first, second and third shot: lengths of a dash and of a gap, m; the first has no gap. */
export const DASHES: readonly (readonly [dash: number, gap: number] | null)[] = [
  null,
  [0.07, 0.04],
  [0.015, 0.035],
];
const COLORS: readonly MarkColor[] = ["white", "yellow", "blue"];

/** Distance (m) of a number from its line. */
const ASIDE = 0.06;

/**
 * The marks of a plan's shots.
 *
 * @param first The shot that is next: earlier ones are not drawn.
 */
export function planMarks(engine: Engine, legs: readonly Leg[], first: number): DrawnMark[] {
  return legs.slice(first).flatMap((leg, k) => legMarks(engine, leg, first + k));
}

function legMarks(engine: Engine, leg: Leg, number: number): DrawnMark[] {
  const shot = engine.shot(leg.shot);
  const trace = shot.simulate();
  const cue = shot.struck!;
  const ball = shot.balls.findIndex(({ id }) => id === leg.ball);
  const [stroke, pot] = [pathOf(trace, cue), pathOf(trace, ball)];
  const { radius } = shot.balls[cue]!;
  trace.free();
  shot.free();
  const color = COLORS[number % COLORS.length]!;
  const dash = DASHES[number % DASHES.length]!;
  const lines = [stroke, pot].flatMap((path) => dashed(path, dash));
  return [
    ...lines.map(([from, to]): DrawnMark => ({ kind: "line", color, from, to })),
    { kind: "circle", color, center: stroke.at(-1)!, radius },
    { kind: "label", color, text: String(number + 1), at: beside(pot) },
  ];
}

function pathOf(trace: Trace, ball: number): Point[] {
  const numbers = trace.polyline(ball, TOLERANCE);
  return Array.from({ length: numbers.length / VERTEX }, (_, k): Point => {
    return [numbers[VERTEX * k]!, numbers[VERTEX * k + 1]!];
  });
}

/** The pieces of a path that a dash covers. */
export function dashed(
  path: readonly Point[],
  dash: readonly [dash: number, gap: number] | null,
): (readonly [from: Point, to: Point])[] {
  const pieces: [Point, Point][] = [];
  // What is left of the present dash or gap, m.
  let [isOn, left] = [true, dash ? dash[0] : Infinity];
  for (let k = 1; k < path.length; k += 1) {
    let from = path[k - 1]!;
    const to = path[k]!;
    let length = Math.hypot(to[0] - from[0], to[1] - from[1]);
    while (length > 0) {
      const step = Math.min(left, length);
      const end = step === length ? to : between(from, to, step / length);
      if (isOn) pieces.push([from, end]);
      from = end;
      length -= step;
      left -= step;
      if (left > 0 || !dash) continue;
      isOn = !isOn;
      left = dash[isOn ? 0 : 1];
    }
  }
  return pieces;
}

/** A place beside the middle of a path. */
function beside(path: readonly Point[]): Point {
  const [from, to] = [path[0]!, path.at(-1)!];
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]) || 1;
  const [x, y] = between(from, to, 0.5);
  return [x - (ASIDE * (to[1] - from[1])) / length, y + (ASIDE * (to[0] - from[0])) / length];
}

function between(from: Point, to: Point, share: number): Point {
  return [from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])];
}
