/** The puzzles on the first page of the Train tab: that of the day, the next one, the player's rating. */

import type { Puzzle } from "../../engine/index.ts";
import { h } from "../common/dom.ts";
import { decimal, named, paragraph, sentence, t } from "../words/translate.ts";
import { diagram } from "./drill-diagram.ts";
import { needsText } from "./goal-words.ts";
import { button, type Trainer } from "./train-parts.ts";
import { dayOf, streakOf } from "./progress/practice-progress.ts";
import { firstAttempts, ratingOf, solvedInARow } from "./puzzle/player-rating.ts";
import {
  DIFFICULTIES,
  type Difficulty,
  nextPuzzle,
  puzzleOfDay,
  themeOf,
} from "./puzzle/puzzle-choice.ts";
import { makePuzzle } from "./puzzle/puzzle-client.ts";
import { taskOf } from "./puzzle/puzzle-task.ts";

/** Size of the balls over their size on the table. */
const ENLARGED = 1.6;

/** Puzzles by id: those of the day are made once. */
const made = new Map<string, Promise<Puzzle>>();

/** What the user has chosen, while the page is open. */
let theme: string | null = null;
let difficulty: Difficulty = "rating";

export function mountPuzzles(root: HTMLElement, trainer: Trainer): void {
  const status = h("p", { class: "hint", role: "status", id: "puzzle-status" });
  const next = button("next-puzzle", t("puzzle.next"), () => playNext(trainer, status), true);
  const day = h("div", {}, h("p", { class: "hint" }, t("puzzle.loading")));
  root.append(
    h("h2", {}, t("puzzle.many")),
    h("p", { class: "hint" }, ratingText(trainer)),
    themeChoice(trainer),
    difficultyChoice(),
    h("div", { class: "row" }, next),
    status,
    h("h2", {}, t("puzzle.title")),
    day,
  );
  // The worker starts only for those who train.
  if (trainer.store.session.activity === "train") void mountDay(day, trainer);
}

async function mountDay(root: HTMLElement, trainer: Trainer): Promise<void> {
  const { engine } = trainer.context;
  const date = dayOf(new Date());
  const [id] = puzzleOfDay(engine.puzzles, date);
  let promise = made.get(id);
  if (!promise) made.set(id, (promise = makePuzzle(engine, id)));
  try {
    root.replaceChildren(...cardOf(await promise, date, trainer));
  } catch {
    root.replaceChildren(h("p", {}, t("puzzle.failed")));
  }
}

function cardOf(puzzle: Puzzle, date: string, { context, keeper, practice }: Trainer): Element[] {
  const task = taskOf(context.engine, puzzle, date);
  const { drill } = task;
  const setting = { drill, step: drill.steps[0]!, attempt: 0 };
  const { progress } = keeper;
  const result = progress.puzzles.find((one) => one.date === date);
  const streak = streakOf(progress, date);
  const said = [
    ...(result?.solved ? [t("puzzle.solved", { count: result.tries })] : []),
    ...(streak > 0 ? [sentence(t("puzzle.streak", { count: streak }))] : []),
  ].join(" ");
  return [
    diagram(context.engine, setting, { label: t("puzzle.diagram"), enlarged: ENLARGED }),
    h("p", {}, needsText(setting.step)),
    ...(said === "" ? [] : [h("p", { class: "hint" }, said)]),
    h(
      "div",
      { class: "row" },
      button("play-puzzle", t("puzzle.play"), () => practice.start(drill, null, task)),
    ),
  ];
}

/** The player's rating, how many puzzles it is from, and how many were solved in a row. */
export function ratingText({ keeper }: Trainer): string {
  const { attempts } = keeper.progress;
  const count = firstAttempts(attempts).length;
  if (count === 0) return t("puzzle.no-rating");
  const { rating, deviation } = ratingOf(attempts);
  const numbers = { rating: decimal(rating, 0), deviation: decimal(2 * deviation, 0) };
  const row = solvedInARow(attempts);
  return paragraph([
    t("puzzle.rating", numbers),
    t("puzzle.count", { count }),
    row > 1 ? t("puzzle.row", { count: row }) : "",
  ]);
}

/** Makes the next puzzle of what is chosen, and sets it on the table. */
export function playNext(trainer: Trainer, status: HTMLElement): void {
  const { context, keeper, practice } = trainer;
  const { engine } = context;
  const { attempts } = keeper.progress;
  const [id] = nextPuzzle(
    engine.puzzles,
    {
      theme,
      difficulty,
      rating: ratingOf(attempts).rating,
      played: new Set(attempts.map(({ puzzle }) => puzzle)),
    },
    Math.random,
  );
  status.textContent = t("puzzle.loading");
  makePuzzle(engine, id).then(
    (puzzle) => {
      const task = taskOf(engine, puzzle, null);
      practice.start(task.drill, null, task);
    },
    () => {
      status.textContent = t("puzzle.failed");
    },
  );
}

/** The name of a theme. */
export function themeName(name: string): string {
  return named("theme", name) ?? name;
}

function themeChoice({ context }: Trainer): HTMLElement {
  const themes = [...new Set(context.engine.puzzles.map(([id]) => themeOf(id)))];
  const select = h(
    "select",
    { id: "puzzle-theme" },
    h("option", { value: "" }, t("puzzle.all-themes")),
    ...themes.map((name) => h("option", { value: name }, themeName(name))),
  );
  select.value = theme ?? "";
  select.addEventListener("change", () => {
    theme = select.value || null;
  });
  return h("div", { class: "labelled" }, h("label", { for: select.id }, t("puzzle.theme")), select);
}

function difficultyChoice(): HTMLElement {
  const select = h(
    "select",
    { id: "puzzle-difficulty" },
    ...DIFFICULTIES.map((name) => h("option", { value: name }, t(`puzzle.by-${name}`))),
  );
  select.value = difficulty;
  select.addEventListener("change", () => {
    difficulty = select.value as Difficulty;
  });
  return h(
    "div",
    { class: "labelled" },
    h("label", { for: select.id }, t("puzzle.difficulty")),
    select,
  );
}
