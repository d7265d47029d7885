/** A puzzle in progress: its goal, the hints that were taken, the solution with its reasons. */

import type { Strike } from "../../engine/index.ts";
import { h } from "../common/dom.ts";
import { decimal, t } from "../words/translate.ts";
import { goalText, scoreText } from "./train-words.ts";
import { playNext, ratingText, themeName } from "./puzzle-card.ts";
import type { Running } from "./practice-state.ts";
import { HINTS, hintTexts, lineMarks } from "./puzzle/puzzle-hints.ts";
import type { PuzzleTask } from "./puzzle/puzzle-task.ts";
import { whyPuzzle } from "./puzzle/puzzle-why.ts";
import { button, heading, type Trainer } from "./train-parts.ts";

export function mountPuzzleRun(
  root: HTMLElement,
  trainer: Trainer,
  running: Running & { readonly puzzle: PuzzleTask },
): void {
  const { context, practice, go } = trainer;
  const { engine } = context;
  const { puzzle: task, hints, seen, solved } = running;
  const { id, theme, rating } = task.puzzle;
  root.dataset.puzzle = id;
  const title = { theme: themeName(theme), rating: decimal(rating, 0) };
  const status = h("p", { class: "hint", role: "status", id: "puzzle-status" });
  const show = (strike: Strike) => practice.show(strike);
  const leave = () => {
    practice.leave();
    go({ kind: "overview" });
  };
  const hint = button("puzzle-hint", t("puzzle.hint"), () =>
    practice.hint(hints === HINTS - 1 ? lineMarks(engine, task) : []),
  );
  hint.hidden = hints >= HINTS || solved;
  const again = button("set-again", t("train.set-again"), () => practice.setAgain());
  again.hidden = practice.deviation === null;
  const solution = t(seen ? "puzzle.solution-again" : "puzzle.solution");
  const next = button("next-puzzle", t("puzzle.next"), () => playNext(trainer, status), solved);
  root.append(
    heading(task.date === null ? t("puzzle.heading", title) : t("puzzle.title")),
    h("p", {}, goalText(practice.setting!)),
    h("p", { role: "status" }, scoreText(running)),
    h("p", { class: "train-said" }, said(trainer, running)),
    ...hintTexts(engine, task, hints).map((text, k) =>
      h("p", { class: "puzzle-hint" }, t("puzzle.hint-number", { number: k + 1, text })),
    ),
    h(
      "div",
      { class: "row" },
      again,
      hint,
      button("puzzle-solution", solution, () => show(task.puzzle.ways[0]!.strike)),
    ),
    h("div", { class: "row" }, next, button("leave-drill", t("train.leave"), leave)),
    status,
    h("p", { class: "hint" }, ratingText(trainer)),
    ...(solved || seen ? whyPuzzle(engine, task, show) : []),
  );
}

/** How the last shot went; at the end, with how many shots it was solved. */
function said({ practice }: Trainer, { solved, points, said }: Running): string {
  if (solved) return t("puzzle.solved", { count: points.length });
  const { deviation } = practice;
  return deviation ? t(`deviation.${deviation}`) : said;
}
