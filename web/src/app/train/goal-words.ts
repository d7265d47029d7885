/** Goals in sentences: of puzzles, and of drills that users have made. */

import { ballName, lengthText } from "../common/shot-words.ts";
import { capital, list, paragraph, t } from "../words/translate.ts";
import type { Condition, Step } from "./drills/index.ts";

/** What an attempt at a step must do. */
export function needsText({ goal }: Pick<Step, "goal">): string {
  if (goal.kind === "run") {
    return t(`goal.${goal.order}`, { balls: list(goal.balls.map(ballName)) });
  }
  const zones = goal.zones && goal.zones.length > 0 ? [t("goal.zones")] : [];
  return paragraph([...goal.needs.map(needText), ...zones]);
}

/** What a condition asks for, as a sentence. */
export function needText(need: Condition): string {
  switch (need.kind) {
    case "pot": {
      const ball = ballName(need.ball);
      return need.pocket === undefined ? t("need.pot", { ball }) : t("need.pot-into", { ball });
    }
    case "pot-any":
      return t("need.pot-any");
    case "stop":
      return need.ball === undefined
        ? t("need.stop")
        : t("need.stop-ball", { ball: ballName(need.ball) });
    case "first":
    case "avoid":
    case "hidden":
    case "next":
      return t(`need.${need.kind}`, { ball: ballName(need.ball) });
    case "cushions": {
      const values = { ball: capital(ballName(need.ball)), count: need.cushions };
      return t("need.cushions", values);
    }
    case "kick":
      return t("need.kick", { count: need.cushions });
    case "carom":
      return need.cushions === 0
        ? t("need.carom-plain")
        : t("need.carom", { count: need.cushions });
    case "touch":
      return t("need.touch", { balls: list(need.balls.map(ballName)) });
    case "apart": {
      const length = lengthText(need.distance);
      return t("need.apart", { balls: list(need.balls.map(ballName)), length });
    }
    case "gather":
      return t("need.gather", { length: lengthText(need.distance) });
  }
}
