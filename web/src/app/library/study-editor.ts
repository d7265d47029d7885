/** The form with which a study of the library is changed: titles, texts, chapters, tasks. */

import type { StudyChapter, GoalCondition, StudyFile } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { button, h, labelled, uniqueId } from "../common/dom.ts";
import { omit } from "../common/omit.ts";
import { LONGEST_TEXT, LONGEST_TITLE, MOST_CHAPTERS } from "../document/lesson.ts";
import type { Store } from "../document/store.ts";
import { capital, t } from "../words/translate.ts";
import { conditionText } from "./lesson-words.ts";
import type { LessonRun } from "./lesson-run.ts";
import type { StudyShelf } from "./study-shelf.ts";
import { factsOf } from "./task-facts.ts";

/** The most conditions of a goal, as the format allows. */
const MOST_CONDITIONS = 10;

export class StudyEditor {
  readonly element = h("div", { class: "study-editor" });
  readonly #store: Store;
  readonly #context: Context;
  readonly #run: LessonRun;
  readonly #shelf: StudyShelf;
  /** Earlier states of the study, for its own undo. */
  readonly #past: { readonly study: StudyFile; readonly chapter: number }[] = [];
  readonly #undoButton = this.#button("study-undo", t("lesson.undo"), () => this.#undo());
  #id: string | null = null;
  /** What is shown, so that the same is not built again. */
  #shown: readonly unknown[] = [];

  constructor(store: Store, context: Context, run: LessonRun, shelf: StudyShelf) {
    this.#store = store;
    this.#context = context;
    this.#run = run;
    this.#shelf = shelf;
  }

  show(): void {
    const { lesson, chapter } = this.#run;
    if (!lesson || !chapter) return;
    if (lesson.id !== this.#id) this.#past.length = 0;
    this.#undoButton.disabled = this.#past.length === 0;
    this.#id = lesson.id;
    const { document, session } = this.#store;
    const { length } = lesson.study.chapters;
    const { shot, task } = chapter;
    const { mode, orientation } = session;
    // Not the texts: the field to which the focus goes from a changed one must stay.
    const now = [lesson.id, lesson.chapter, length, shot, task, document, mode, orientation];
    if (now.every((part, k) => part === this.#shown[k])) return;
    const { activeElement } = globalThis.document;
    const had = this.element.contains(activeElement) ? activeElement!.id : "";
    this.#shown = now;
    this.element.replaceChildren(...this.#fields(lesson.study, chapter), this.#task(chapter));
    if (had !== "") this.element.querySelector<HTMLElement>(`#${had}`)?.focus();
  }

  #fields(study: StudyFile, chapter: StudyChapter): HTMLElement[] {
    const { chapter: index } = this.#run.lesson!;
    const title = this.#line("study-title", study.title, (value) =>
      this.#change({ ...this.#study, title: value }),
    );
    const author = this.#line("study-author", study.author ?? "", (value) => {
      const rest = omit(this.#study, "author");
      this.#change(value === "" ? rest : { ...rest, author: value });
    });
    const name = this.#line("chapter-title", chapter.title, (value) =>
      this.#revise({ ...this.#chapter, title: value }),
    );
    const text = h("textarea", { id: "chapter-text", rows: 5, maxlength: LONGEST_TEXT });
    text.value = chapter.text ?? "";
    text.addEventListener("change", () =>
      this.#revise({ ...this.#chapter, text: text.value.replaceAll("\r\n", "\n") }),
    );
    return [
      labelled(t("lesson.study-title"), title),
      labelled(t("lesson.author"), author),
      h(
        "h2",
        { tabindex: -1 },
        t("lesson.place", { number: index + 1, count: study.chapters.length }),
      ),
      labelled(t("lesson.chapter-title"), name),
      labelled(t("lesson.text"), text),
      this.#table(index),
      this.#order(study.chapters.length, index),
    ];
  }

  #line(id: string, value: string, change: (value: string) => void): HTMLInputElement {
    const field = h("input", { type: "text", id, maxlength: LONGEST_TITLE });
    field.value = value;
    field.addEventListener("change", () => {
      const text = field.value.trim();
      if (text === "" && id !== "study-author") field.value = value;
      else change(text);
    });
    return field;
  }

  /** What is taken from the table. */
  #table(index: number): HTMLElement {
    const take = this.#button("chapter-take", t("lesson.take"), () => {
      const { title, text, task } = this.#chapter;
      // A task about other balls has lost its meaning.
      const kept = this.#run.isSet ? task : undefined;
      const next = this.#shelf.chapter(title, {
        ...(text !== undefined && { text }),
        ...(kept && { task: kept }),
      });
      this.#revise(next);
    });
    const add = this.#button("chapter-add", t("lesson.add"), () => {
      const study = this.#study;
      const number = study.chapters.length + 1;
      const added = this.#shelf.chapter(t("lesson.chapter", { number }));
      const chapters = study.chapters.toSpliced(index + 1, 0, added);
      this.#change({ ...study, chapters }, index + 1);
    });
    add.disabled = this.#study.chapters.length >= MOST_CHAPTERS;
    return h(
      "div",
      {},
      h("p", { class: "hint" }, t("lesson.table-hint")),
      h("div", { class: "row" }, take, add),
    );
  }

  #order(count: number, index: number): HTMLElement {
    const move = (to: number) => () => {
      const { chapters } = this.#study;
      const moved = chapters.toSpliced(index, 1).toSpliced(to, 0, chapters[index]!);
      this.#change({ ...this.#study, chapters: moved }, to);
    };
    const up = this.#button("chapter-up", t("lesson.up"), move(index - 1));
    up.disabled = index === 0;
    const down = this.#button("chapter-down", t("lesson.down"), move(index + 1));
    down.disabled = index === count - 1;
    const remove = this.#button("chapter-delete", t("lesson.delete-chapter"), () => {
      const left = this.#study.chapters.toSpliced(index, 1);
      this.#change({ ...this.#study, chapters: left }, Math.min(index, left.length - 1));
    });
    remove.disabled = count === 1;
    return h("div", { class: "row" }, up, down, remove, this.#undoButton);
  }

  /** The task: what the aimed shot does can be asked for, and the shot is then the solution. */
  #task(chapter: StudyChapter): HTMLElement {
    const { task } = chapter;
    const facts = this.#facts();
    const goal = task?.goal ?? [];
    const keyOf = (condition: GoalCondition) => JSON.stringify(condition);
    const asked = new Set(goal.map(keyOf));
    const boxes = facts.map((fact) => {
      const box = h("input", { type: "checkbox", id: uniqueId("fact") });
      box.checked = asked.has(keyOf(fact));
      return { fact, box };
    });
    const take = this.#button("task-take", t("lesson.task-take"), () => {
      const wanted = boxes.filter(({ box }) => box.checked).map(({ fact }) => fact);
      const { strike } = this.#store.document.shot;
      if (wanted.length === 0) this.#store.refuse(t("lesson.task-none"));
      else this.#retask({ goal: wanted.slice(0, MOST_CONDITIONS), solution: strike });
    });
    const remove = this.#button("task-remove", t("lesson.task-remove"), () =>
      this.#retask(undefined),
    );
    const present = goal.map((condition) => h("li", {}, capital(conditionText(condition))));
    return h(
      "section",
      { "aria-labelledby": "task-title" },
      h("h3", { id: "task-title" }, t("lesson.task")),
      task && h("ul", {}, ...present),
      task && h("div", { class: "row" }, remove),
      h("p", { class: "hint" }, t(facts.length > 0 ? "lesson.task-hint" : "lesson.task-nothing")),
      ...boxes.map(({ fact, box }) =>
        h("div", { class: "fact" }, box, h("label", { for: box.id }, capital(conditionText(fact)))),
      ),
      facts.length > 0 && h("div", { class: "row" }, take),
    );
  }

  /** What the aimed shot does; nothing if the balls do not lie as in the chapter. */
  #facts(): GoalCondition[] {
    const { trace } = this.#store.ghost;
    if (!trace || !this.#run.isSet) return [];
    return factsOf(this.#context.engine, trace, this.#store.document.shot);
  }

  #retask(task: StudyChapter["task"]): void {
    const chapter = this.#chapter;
    const { strike } = this.#store.document.shot;
    const position = omit(chapter.shot, "strike");
    this.#revise({
      ...omit(chapter, "task"),
      // With a task the chapter does not show the shot that solves it.
      shot: task ? position : { ...position, strike },
      ...(task && { task }),
    });
  }

  #revise(chapter: StudyChapter): void {
    const { study, chapter: index } = this.#run.lesson!;
    this.#change({ ...study, chapters: study.chapters.with(index, chapter) });
  }

  get #study(): StudyFile {
    return this.#run.lesson!.study;
  }

  get #chapter(): StudyChapter {
    return this.#run.chapter!;
  }

  #change(study: StudyFile, chapter = this.#run.lesson!.chapter): void {
    const { study: before, chapter: at } = this.#run.lesson!;
    this.#past.push({ study: before, chapter: at });
    if (!this.#shelf.change(study, chapter)) this.#past.pop();
    this.show();
    this.#undoButton.disabled = this.#past.length === 0;
  }

  #undo(): void {
    const last = this.#past.pop();
    if (last) this.#shelf.change(last.study, last.chapter);
    this.#shown = [];
    this.show();
    this.#undoButton.disabled = this.#past.length === 0;
  }

  #button(id: string, text: string, onclick: () => void): HTMLButtonElement {
    const one = button(text, onclick);
    one.id = id;
    return one;
  }
}
