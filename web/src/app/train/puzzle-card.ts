/** The card of the puzzle of the day. */

import { h } from "../common/dom.ts";
import { t } from "../words/translate.ts";
import { diagram } from "./drill-diagram.ts";
import { button, type Trainer } from "./train-parts.ts";
import { dayOf, streakOf } from "./progress/practice-progress.ts";
import { makePuzzle } from "./puzzle/puzzle-client.ts";
import type { Puzzle } from "./puzzle/daily-puzzle.ts";
import { puzzleText } from "./train-words.ts";

/** Size of the balls over their size on the table. */
const ENLARGED = 1.6;

/** Puzzles by date: made once, when the tab is first shown. */
const made = new Map<string, Promise<Puzzle>>();

export function mountPuzzle(root: HTMLElement, trainer: Trainer): void {
  const date = dayOf(new Date());
  const content = h("div", {}, h("p", { class: "hint" }, t("puzzle.loading")));
  root.append(h("h2", {}, t("puzzle.title")), content);
  // The worker starts only for those who train.
  if (trainer.store.session.activity !== "train") return;
  let promise = made.get(date);
  if (!promise) made.set(date, (promise = makePuzzle(trainer.context.engine, date)));
  promise
    .then((puzzle) => {
      content.replaceChildren(...cardOf(puzzle, trainer));
    })
    .catch(() => {
      content.replaceChildren(h("p", {}, t("puzzle.failed")));
    });
}

function cardOf(puzzle: Puzzle, { context, keeper, practice }: Trainer): Element[] {
  const { drill, date } = puzzle;
  const setting = { drill, step: drill.steps[0]!, attempt: 0 };
  const { progress } = keeper;
  const result = progress.puzzles.find((one) => one.date === date);
  const streak = streakOf(progress, date);
  const said = [
    ...(result?.solved ? [t("puzzle.solved", { count: result.tries })] : []),
    ...(streak > 0 ? [`${t("puzzle.streak", { count: streak })}.`] : []),
  ].join(" ");
  return [
    diagram(context.engine, setting, { label: t("puzzle.diagram"), enlarged: ENLARGED }),
    h("p", {}, puzzleText(puzzle)),
    ...(said === "" ? [] : [h("p", { class: "hint" }, said)]),
    h(
      "div",
      { class: "row" },
      button("play-puzzle", t("puzzle.play"), () => practice.start(drill, null, puzzle), true),
    ),
  ];
}
