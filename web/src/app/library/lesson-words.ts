/** Sentences about the tasks of studies. */

import type { GoalCondition, TaskVerdict } from "../../engine/index.ts";
import { ballName, lengthText, pocketName } from "../common/shot-words.ts";
import { list, t } from "../words/translate.ts";

/** What a shot must do, within a sentence. */
export function conditionText(condition: GoalCondition): string {
  switch (condition.kind) {
    case "pot": {
      const ball = ballName(condition.ball);
      const { pocket } = condition;
      return pocket
        ? t("goal.pot-into", { ball, pocket: pocketName(pocket) })
        : t("goal.pot", { ball });
    }
    case "pot-any":
      return t("goal.pot-any");
    case "first":
    case "avoid":
    case "hidden":
    case "next":
      return t(`goal.${condition.kind}`, { ball: ballName(condition.ball) });
    case "kick":
      return t("goal.kick", { count: condition.cushions });
    case "carom":
      return condition.cushions === 0
        ? t("goal.carom-plain")
        : t("goal.carom", { count: condition.cushions });
    case "cushions":
      return t("goal.cushions", { ball: ballName(condition.ball), count: condition.cushions });
    case "touch":
      return t("goal.touch", { balls: list(condition.balls.map(ballName)) });
    case "apart": {
      const balls = list(condition.balls.map(ballName));
      return t("goal.apart", { balls, length: lengthText(condition.distance) });
    }
    case "gather":
      return t("goal.gather", { length: lengthText(condition.distance) });
    case "stop":
      return condition.ball === undefined
        ? t("goal.stop-cue")
        : t("goal.stop", { ball: ballName(condition.ball) });
  }
}

/** The goal as a sentence. */
export function goalText(goal: readonly GoalCondition[]): string {
  return t("goal.task", { conditions: goal.map(conditionText).join(t("goal.and")) });
}

/** How a shot stands to the goal. */
export function verdictText(goal: readonly GoalCondition[], verdict: TaskVerdict): string {
  if (verdict.met) return t("lesson.solved");
  if (verdict.fault === "cue-ball-lost") return t("fault.scratch");
  const condition = goal[verdict.condition ?? 0]!;
  if (condition.kind === "stop" && verdict.distance !== null) {
    const ball = ballName(condition.ball ?? "cue");
    return t("lesson.outside", { ball, length: lengthText(verdict.distance) });
  }
  return t("lesson.missed", { condition: conditionText(condition) });
}
