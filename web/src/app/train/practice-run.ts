/** A drill or a puzzle in progress, on the page's table or at a real one, and its result. */

import { h } from "../common/dom.ts";
import { levelName } from "../common/preset-names.ts";
import { paragraph, t } from "../words/translate.ts";
import { scoresOf } from "./drill-detail.ts";
import { diagram } from "./drill-diagram.ts";
import { mostPoints } from "./drill-judge.ts";
import { nearestLevel } from "./drill-levels.ts";
import { button, heading, type Trainer } from "./train-parts.ts";
import type { Running } from "./practice-state.ts";
import { greatest, total } from "./drill-score.ts";
import { mountPuzzleRun } from "./puzzle-run.ts";
import { drillName, goalText, scoreText } from "./train-words.ts";

/** Size of the balls over their size on the table. */
const ENLARGED = 1.4;

export function mountRun(root: HTMLElement, trainer: Trainer, running: Running): void {
  const { practice, go } = trainer;
  const { drill, puzzle } = running;
  if (puzzle) {
    mountPuzzleRun(root, trainer, { ...running, puzzle });
    return;
  }
  root.append(heading(drillName(drill)));
  const leave = button("leave-drill", t("train.leave"), () => {
    practice.leave();
    go({ kind: "drill", drill });
  });
  if (running.result) mountEnd(root, trainer, running, leave);
  else mountAttempt(root, trainer, running, leave);
}

function mountAttempt(
  root: HTMLElement,
  { context, practice }: Trainer,
  running: Running,
  leave: HTMLElement,
): void {
  const setting = practice.setting!;
  const { drill, place } = running;
  const label = t("train.diagram", { name: drillName(drill) });
  const deviation = practice.deviation;
  root.append(
    h("p", {}, goalText(setting)),
    attempts(running),
    h("p", { role: "status" }, scoreText(running)),
  );
  if (place === "table") {
    // The buttons come first: they are used after every attempt, and must not be scrolled to.
    root.append(
      taps(practice, setting),
      h("p", { class: "hint" }, t("train.at-table-hint")),
      diagram(context.engine, setting, { label, enlarged: ENLARGED }),
    );
  } else {
    root.append(
      h("p", { class: "train-said" }, deviation ? t(`deviation.${deviation}`) : running.said),
    );
  }
  const again = button("set-again", t("train.set-again"), () => practice.setAgain());
  again.hidden = deviation === null;
  const back = button("take-back", t("train.take-back"), () => practice.takeBack());
  back.hidden = place === "page" || running.points.length === 0;
  root.append(h("div", { class: "row" }, again, back, leave));
}

/** Buttons for how an attempt at a real table went. */
function taps(practice: Trainer["practice"], setting: NonNullable<Trainer["practice"]["setting"]>) {
  const { step } = setting;
  const most = mostPoints(step);
  const isRun = step.goal.kind === "run";
  const tap = (points: number, text: string) =>
    button(`tap-${points}`, text, () => practice.tap(points), points > 0 && most === 1);
  const buttons =
    most === 1
      ? [tap(1, t("train.made")), tap(0, t("train.missed"))]
      : Array.from({ length: most + 1 }, (_, points) => tap(points, String(points)));
  return h(
    "div",
    {},
    isRun && h("p", { class: "hint" }, t("train.run-hint")),
    h("div", { class: "row tap" }, ...buttons),
  );
}

/** The attempts as boxes: the points of those that were played, and the open ones. */
function attempts({ drill, points }: Running): HTMLElement {
  const boxes = Array.from({ length: drill.attempts }, (_, k) => {
    const gained = points[k];
    const number = k + 1;
    const text =
      gained === undefined
        ? t("train.attempt-open", { number })
        : t("train.attempt-made", { number, points: t("train.points", { count: gained }) });
    const made = gained === undefined ? undefined : String(gained > 0);
    return h(
      "li",
      { "data-made": made },
      h("span", { class: "unseen" }, text),
      h("span", { "aria-hidden": "true" }, gained === undefined ? "" : String(gained)),
    );
  });
  const label = t("train.progress", { done: points.length, attempts: drill.attempts });
  return h("ol", { class: "attempts", "aria-label": label }, ...boxes);
}

function mountEnd(root: HTMLElement, trainer: Trainer, running: Running, leave: HTMLElement): void {
  const { practice } = trainer;
  const { drill, points, said, errors, place } = running;
  const score = total(points);
  const level = nearestLevel(drill, score);
  const finished = t("train.finished", { score, most: greatest(drill) });
  const like = level === null ? "" : t("train.like", { level: levelName(level) });
  const again = () => {
    if (place === "page") practice.start(drill, errors);
    else practice.startAtTable(drill);
  };
  root.append(
    h("p", {}, said),
    attempts(running),
    h("p", { class: "train-said", role: "status" }, paragraph([finished, like])),
    h("div", { class: "row" }, button("drill-again", t("train.again"), again, true), leave),
    ...scoresOf(trainer, drill),
  );
}
