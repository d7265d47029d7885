/** Sentences about drills: goals, verdicts and scores. */

import { ballName, lengthText } from "../common/shot-words.ts";
import { presetLabel } from "../common/preset-names.ts";
import { capital, list, named, paragraph, sentence, t } from "../words/translate.ts";
import { needsText } from "./goal-words.ts";
import type { Drill } from "./drills/index.ts";
import type { Fault, Verdict } from "./drill-judge.ts";
import type { Setting } from "./drill-layout.ts";
import type { PuzzleTask } from "./puzzle/puzzle-task.ts";
import { total } from "./drill-score.ts";

/** The name of a drill; its id if this version of the page does not have it. */
export function drillName({ id, name }: Pick<Drill, "id" | "name">): string {
  return name ?? named("drill", id) ?? id;
}

/** The goal, with the number of the step if there are several. */
export function goalText({ drill, step }: Setting): string {
  const { steps } = drill;
  const number = steps.indexOf(step) + 1;
  const which =
    steps.length > 1 ? sentence(t("train.step", { step: number, steps: steps.length })) : "";
  const own = named("drill-goal", drill.id);
  return paragraph([own ?? paragraph([drill.text ?? "", needsText(step)]), which]);
}

/** Table and number of attempts. */
export function tableText({ table, attempts }: Drill): string {
  return t("train.table-of", {
    table: presetLabel(table),
    attempts: t("train.attempts", { count: attempts }),
  });
}

/** The book whose theme a drill has; empty if it has none. */
export function sourceText({ id }: Drill): string {
  return named("drill-source", id) ?? "";
}

/** The present attempt and the score; of a puzzle the number of shots. */
export function scoreText({
  drill,
  puzzle,
  points,
}: {
  readonly drill: Drill;
  readonly puzzle: PuzzleTask | null;
  readonly points: readonly number[];
}): string {
  if (puzzle) return points.length > 0 ? t("train.shots", { count: points.length }) : "";
  const { attempts } = drill;
  const attempt = Math.min(points.length + 1, attempts);
  return t("train.score", { attempt, attempts, score: total(points) });
}

/** How a shot of a drill went. */
export function verdictText({ points, fault, left }: Verdict, { step }: Setting): string {
  if (step.goal.kind === "run") {
    if (fault) return paragraph([faultText(fault), t("verdict.run", { count: points })]);
    return left.length > 0 ? t("verdict.on", { count: left.length }) : t("verdict.cleared");
  }
  if (fault) return faultText(fault);
  return step.goal.zones ? t("verdict.points", { count: points }) : t("verdict.made");
}

function faultText(fault: Fault): string {
  switch (fault.kind) {
    case "scratch":
    case "no-pot":
      return t(`fault.${fault.kind}`);
    case "wrong-first":
      return t("fault.wrong-first", { ball: ballName(fault.ball) });
    case "wrong-ball":
      return t("fault.wrong-ball", { ball: capital(ballName(fault.ball)) });
    case "condition":
      return conditionText(fault);
  }
}

function conditionText({ condition, distance }: Extract<Fault, { kind: "condition" }>): string {
  switch (condition.kind) {
    case "pot":
    case "first":
    case "cushions":
    case "avoid":
    case "next":
    case "hidden":
      return t(`fault.${condition.kind}`, { ball: ballName(condition.ball) });
    case "touch":
    case "apart":
      return t(`fault.${condition.kind}`, { balls: list(condition.balls.map(ballName)) });
    case "gather":
      return t("fault.gather", { length: lengthText(condition.distance) });
    case "pot-any":
    case "kick":
    case "carom":
      return t(`fault.${condition.kind}`);
    case "stop":
      return t("fault.stop", { length: lengthText(distance) });
  }
}
