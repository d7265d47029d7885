/** The hints of a puzzle, from its best way: which ball, which strike, and the line on the table. */

import type { DrawnMark, Engine, MarkColor, Point, Strike, Trace } from "../../../engine/index.ts";
import { STRIDE } from "../../../engine/types.ts";
import { strikeText } from "../../analyse/analyse-words.ts";
import { round4 } from "../../common/angles.ts";
import { playedName, pocketName, railName } from "../../common/shot-words.ts";
import { capital, list, paragraph, t } from "../../words/translate.ts";
import type { PuzzleTask } from "./puzzle-task.ts";

/** Hints of a puzzle, one after the other. */
export const HINTS = 3;

/** Pieces of a ball's way that are drawn. */
const PIECES = 6;

/** The shot with a strike, simulated. The caller frees it. */
export function traceOf(engine: Engine, { puzzle }: PuzzleTask, strike: Strike): Trace {
  const shot = engine.shot(puzzle.shot);
  const struck = shot.withStrike(strike);
  const trace = struck.simulate();
  struck.free();
  shot.free();
  return trace;
}

/** The texts of the first `count` hints. */
export function hintTexts(engine: Engine, task: PuzzleTask, count: number): string[] {
  if (count === 0) return [];
  const { strike } = task.puzzle.ways[0]!;
  const trace = traceOf(engine, task, strike);
  const texts = [
    firstText(trace),
    t("puzzle.hint-strike", { strike: strikeText(strike) }),
    t("puzzle.hint-line"),
  ];
  trace.free();
  return texts.slice(0, count);
}

/** What the cue ball meets first, and where a ball falls. */
function firstText({ outcome }: Trace): string {
  const { first_contact: first, rails_before_first_contact: rails, pocketed } = outcome;
  const ball = first === null ? "" : playedName(first);
  const meets =
    rails.length > 0
      ? t("puzzle.hint-rails", { rails: list(rails.map(railName)), ball })
      : t("need.first", { ball });
  const falls = pocketed.map(([fallen, pocket]) =>
    t("puzzle.hint-falls", { ball: capital(playedName(fallen)), pocket: pocketName(pocket) }),
  );
  return paragraph([meets, ...falls]);
}

/** The ways of the cue ball and of the ball that falls, or of the first one that is hit, as arrows. */
export function lineMarks(engine: Engine, task: PuzzleTask): readonly DrawnMark[] {
  const trace = traceOf(engine, task, task.puzzle.ways[0]!.strike);
  const { cue } = task.drill;
  const other = trace.outcome.pocketed[0]?.[0] ?? trace.outcome.first_contact;
  const marks = [
    ...wayOf(trace, cue, "white"),
    ...(other === null || other === cue ? [] : wayOf(trace, other, "yellow")),
  ];
  trace.free();
  return marks;
}

function wayOf(trace: Trace, id: string, color: MarkColor): DrawnMark[] {
  const index = trace.shot.balls.findIndex((ball) => ball.id === id);
  const meetings = trace.events.filter(
    ({ type, balls }) =>
      balls.includes(id) &&
      (type === "ball-collision" || type === "rail-collision" || type === "pocket-collision"),
  );
  const times = [0, ...meetings.map(({ time }) => time), trace.duration];
  const points = times.map((time): Point => {
    const states = trace.statesAt(time);
    return [round4(states[index * STRIDE]!), round4(states[index * STRIDE + 1]!)];
  });
  const pieces = points.slice(1).map((to, k) => ({ from: points[k]!, to }));
  return pieces
    .filter(({ from, to }) => from[0] !== to[0] || from[1] !== to[1])
    .slice(0, PIECES)
    .map((piece) => ({ color, kind: "arrow", ...piece }));
}
