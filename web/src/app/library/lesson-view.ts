/** The study that is open: the chapter with its text and task, and the way to the other chapters. */

import type { StudyChapter } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { button, h } from "../common/dom.ts";
import { aimed } from "../document/shot-file.ts";
import { printing } from "../diagram/print-diagram.ts";
import type { Store } from "../document/store.ts";
import { copy } from "../share/clipboard.ts";
import { download } from "../share/download.ts";
import { leave } from "../replay/replay-control.ts";
import { t } from "../words/translate.ts";
import { goalText } from "./lesson-words.ts";
import type { LessonRun } from "./lesson-run.ts";
import { fileName } from "./library-list.ts";
import { StudyEditor } from "./study-editor.ts";
import type { StudyShelf } from "./study-shelf.ts";

export class LessonView {
  readonly element = h("section", { class: "lesson", id: "lesson" });
  readonly #run: LessonRun;
  readonly #shelf: StudyShelf;
  readonly #store: Store;
  readonly #editor: StudyEditor;
  #isEditing = false;
  /** What is shown, so that the same is not built again. */
  #shown: readonly unknown[] = [];

  constructor(store: Store, context: Context, run: LessonRun, shelf: StudyShelf) {
    this.#store = store;
    this.#run = run;
    this.#shelf = shelf;
    this.#editor = new StudyEditor(store, context, run, shelf);
  }

  show(): void {
    const { lesson, chapter, said, isOpen, isSet } = this.#run;
    if (!lesson || !chapter) {
      this.#isEditing = false;
      this.#shown = [];
      return;
    }
    const { mode, orientation } = this.#store.session;
    if (this.#isEditing && this.#shelf.isOwn) {
      this.#editor.show();
      this.#build(this.#editing());
      this.#shown = [];
      return;
    }
    const { isOwn } = this.#shelf;
    const now = [lesson, said, isOpen, isSet, mode, orientation, isOwn];
    if (now.every((part, k) => part === this.#shown[k])) return;
    const isOther = (this.#shown[0] as typeof lesson | undefined)?.chapter !== lesson.chapter;
    this.#shown = now;
    this.#build(this.#reading(chapter));
    if (isOther) this.element.parentElement!.scrollTop = 0;
  }

  /** Replaces the contents; the focus stays on the element with its id, or goes to the heading. */
  #build(contents: readonly (HTMLElement | false)[]): void {
    const { activeElement } = document;
    const had = activeElement && this.element.contains(activeElement) ? activeElement.id : null;
    // A field that is being filled is the same element again, and keeps its place.
    const parts = contents.filter((part) => part !== false);
    if (parts.length === 2 && parts.every((part, k) => part === this.element.children[k])) return;
    this.element.replaceChildren(...parts);
    if (had === null) return;
    const again = had === "" ? null : this.element.querySelector<HTMLElement>(`#${had}`);
    (again ?? this.element.querySelector<HTMLElement>("h2"))?.focus();
  }

  #reading(chapter: StudyChapter): (HTMLElement | false)[] {
    const { lesson, said } = this.#run;
    const { study, chapter: index } = lesson!;
    const { task, text = "" } = chapter;
    const count = study.chapters.length;
    const lang = study.language;
    return [
      h("h2", { tabindex: -1, lang }, study.title),
      study.author !== undefined && h("p", { class: "hint", lang }, study.author),
      this.#contents(),
      this.#steps(index, count),
      h("h3", { lang }, chapter.title),
      text !== "" && h("p", { class: "lesson-text", lang }, text),
      task !== undefined && h("p", { class: "lesson-task" }, goalText(task.goal)),
      task !== undefined && h("p", { class: "lesson-said", role: "status" }, said),
      this.#shotButtons(chapter),
      this.#variations(),
      this.#shareButtons(),
    ];
  }

  /** The list of the chapters. */
  #contents(): HTMLElement {
    const { study, chapter: shown } = this.#run.lesson!;
    const options = study.chapters.map(({ title }, value) => {
      const text = t("lesson.numbered", { number: value + 1, title });
      return h("option", { value, selected: value === shown }, text);
    });
    const select = h(
      "select",
      { id: "lesson-chapter", "aria-label": t("lesson.chapters") },
      ...options,
    );
    select.addEventListener("change", () => this.#run.go(Number(select.value)));
    return select;
  }

  #steps(index: number, count: number): HTMLElement {
    const previous = button(t("lesson.previous"), () => this.#run.go(index - 1));
    previous.id = "lesson-previous";
    previous.setAttribute("aria-keyshortcuts", "PageUp");
    previous.disabled = index === 0;
    const next = button(t("lesson.next"), () => this.#run.go(index + 1), "primary");
    next.id = "lesson-next";
    next.setAttribute("aria-keyshortcuts", "PageDown");
    next.disabled = index === count - 1;
    const place = h("span", { class: "hint" }, t("lesson.place", { number: index + 1, count }));
    return h("div", { class: "row lesson-steps" }, previous, next, place);
  }

  #shotButtons({ shot, task }: StudyChapter): HTMLElement | false {
    const { isSet, isOpen } = this.#run;
    const isReplay = this.#store.session.mode === "replay";
    const buttons: HTMLElement[] = [];
    const add = (id: string, text: string, run: () => void) => {
      const one = button(text, run);
      one.id = id;
      buttons.push(one);
    };
    if (shot.strike) add("lesson-play", t("lesson.play"), () => this.#run.play(aimed(shot)));
    if (task?.solution)
      add("lesson-solution", t("lesson.solution"), () => this.#run.showSolution());
    if (!isSet || (task && !isOpen && !isReplay))
      add("lesson-again", t("lesson.again"), () => this.#run.setAgain());
    if (isReplay) add("lesson-back", t("lesson.to-table"), () => leave(this.#store));
    return buttons.length > 0 && h("div", { class: "row" }, ...buttons);
  }

  /** The shots of the chapter; those of a task after it was solved or its solution was shown. */
  #variations(): HTMLElement | false {
    const { shots, chapter, isOpen, lesson } = this.#run;
    if (shots.length === 0 || (chapter?.task && isOpen)) return false;
    const lang = lesson?.study.language;
    const items = shots.map(({ shot, comment, parent }, k) => {
      const said = comment === "" ? t("lesson.shot", { number: k + 1 }) : comment;
      const play = button(said, () => this.#run.play(shot), "variation");
      play.id = `lesson-shot-${k}`;
      if (lang !== undefined && comment !== "") play.lang = lang;
      return h("li", { "data-follows": parent !== null }, play);
    });
    return h("div", {}, h("h3", {}, t("lesson.shots")), h("ul", { class: "variations" }, ...items));
  }

  #shareButtons(): HTMLElement {
    const { study } = this.#run.lesson!;
    const link = this.#shelf.link();
    const base = location.href.replace(/#.*$/s, "");
    const of = (id: string, text: string, run: () => void) => {
      const one = button(text, run);
      one.id = id;
      return one;
    };
    const said = h("span", { class: "hint", role: "status" });
    const copyLink = async () => {
      const isCopied = await copy(base + link!);
      said.textContent = t(isCopied ? "share.link-copied" : "share.not-allowed");
    };
    const print = () => {
      printing.solutions = !this.#run.isOpen;
      globalThis.print();
    };
    return h(
      "div",
      { class: "row lesson-share" },
      this.#shelf.isOwn &&
        of("lesson-edit", t("lesson.edit"), () => {
          this.#isEditing = true;
          this.show();
        }),
      !this.#shelf.isOwn &&
        this.#shelf.canKeep &&
        of("lesson-copy", t("lesson.copy"), () => void this.#shelf.copy()),
      link !== null && of("lesson-link", t("share.copy-link"), () => void copyLink()),
      of("lesson-file", t("lesson.save-file"), () =>
        download(this.#shelf.file(study), fileName(study.title)),
      ),
      of("lesson-print", t("diagram.print"), print),
      of("lesson-close", t("lesson.close"), () => this.#run.close()),
      link === null && h("p", { class: "hint" }, t("lesson.no-link")),
      said,
    );
  }

  #editing(): HTMLElement[] {
    const done = button(
      t("lesson.read"),
      () => {
        this.#isEditing = false;
        this.show();
      },
      "primary",
    );
    done.id = "lesson-read";
    const bar =
      this.element.querySelector("#lesson-read")?.parentElement ?? h("div", { class: "row" }, done);
    return [bar, this.#editor.element];
  }
}
