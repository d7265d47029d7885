/** What a shot does, as conditions that a task may ask for: the shot then solves it. */

import type { Engine, GoalCondition, Trace } from "../../engine/index.ts";
import type { AimedShot } from "../document/aimed-shot.ts";
import { areasOfMarks } from "../document/marks.ts";

/** The conditions that a shot meets; none if it loses the cue ball. */
export function factsOf(engine: Engine, trace: Trace, { marks = [] }: AimedShot): GoalCondition[] {
  const { outcome, shot } = trace;
  const cue = outcome.cue_ball;
  const first = outcome.first_contact;
  const others = shot.balls.map(({ id }) => id).filter((id) => id !== cue);
  const counts = (most: number) => Array.from({ length: most + 1 }, (_, k) => most - k);
  const meets = (condition: GoalCondition) => engine.judge(trace, [condition]).met;
  /** Of several numbers the largest that is met. */
  const largest = (numbers: readonly number[], of: (count: number) => GoalCondition) =>
    numbers.map(of).filter(meets).slice(0, 1);
  return [
    ...outcome.pocketed.map(([ball, pocket]): GoalCondition => ({ kind: "pot", ball, pocket })),
    ...outcome.pocketed.map(([ball]): GoalCondition => ({ kind: "pot", ball })),
    ...(first === null ? [] : [{ kind: "first", ball: first } as const]),
    ...largest(counts(MOST_CUSHIONS), (cushions) => ({ kind: "carom", cushions })),
    ...largest(counts(MOST_CUSHIONS).slice(0, -1), (cushions) => ({ kind: "kick", cushions })),
    ...areasOfMarks(marks).map((area): GoalCondition => ({ kind: "stop", area })),
    ...others.map((ball): GoalCondition => ({ kind: "hidden", ball })),
  ].filter(meets);
}

/** More cushions than a player plans. */
const MOST_CUSHIONS = 6;
