/** Studies and entries between the table and the library: what is saved, opened and shared. */

import { CaromError, type StudyFile } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { errorText } from "../common/refusals.ts";
import { chapterOf, LONGEST_TITLE } from "../document/lesson.ts";
import type { Store } from "../document/store.ts";
import type { Library } from "../kept/library.ts";
import type { LibraryEntry } from "../kept/library-entry.ts";
import { linkText, openText } from "../share/address.ts";
import { isTooLong } from "../share/link.ts";
import { lessonToFragment } from "../share/link-state.ts";
import { toPrettyJson } from "../share/literal.ts";
import { language, t } from "../words/translate.ts";
import { LANGUAGES } from "../words/catalogue.ts";
import type { LessonRun } from "./lesson-run.ts";

export class StudyShelf {
  readonly #store: Store;
  readonly #context: Context;
  readonly #run: LessonRun;
  readonly #library: Library | null;
  readonly #listeners = new Set<() => void>();
  /** The entry of the open study, as it is stored. */
  #own: LibraryEntry | null = null;
  /** Changes are stored one after another. */
  #storing: Promise<unknown> = Promise.resolve();

  constructor(store: Store, context: Context, run: LessonRun, library: Library | null) {
    this.#store = store;
    this.#context = context;
    this.#run = run;
    this.#library = library;
  }

  subscribe(listener: () => void): void {
    this.#listeners.add(listener);
  }

  /** Whether the open study is in the library and can be changed. */
  get isOwn(): boolean {
    const { lesson } = this.#run;
    return lesson?.id != null && lesson.id === this.#own?.id;
  }

  get canKeep(): boolean {
    return this.#library !== null;
  }

  /** After a reload: finds the entry of the study that is open. */
  async findOwn(): Promise<void> {
    const { lesson } = this.#run;
    if (!lesson?.id) return;
    const entry = (await this.#library?.get(lesson.id)) ?? null;
    // The user may have gone on.
    if (this.#run.lesson?.id !== lesson.id) return;
    if (entry?.kind !== "study") this.#run.revise(lesson.study, lesson.chapter, null);
    else if (this.#accepts(entry.study)) {
      this.#own = entry;
      const chapter = Math.min(lesson.chapter, entry.study.chapters.length - 1);
      this.#run.revise(entry.study, chapter, entry.id);
    }
  }

  /** Opens an entry; one that is refused changes nothing. */
  async open(entry: LibraryEntry): Promise<void> {
    if (entry.kind !== "study") {
      this.#store.setSession({ activity: entry.kind === "game" ? "play" : "analyse" });
      await openText(this.#store, this.#context, entry.link);
      return;
    }
    if (!this.#accepts(entry.study)) return;
    this.#own = entry;
    this.#run.open(entry.study, entry.id);
  }

  /** Opens a study that can only be read. */
  openReadOnly(study: StudyFile): void {
    this.#own = null;
    this.#run.open(study, null);
  }

  /** Adds what the table shows: the position with its shots and marks, or the game. */
  async addPosition(name: string, folder: string): Promise<void> {
    const kind = this.#store.document.game ? "game" : "position";
    const session = { ...this.#store.session, lesson: null, mode: "aim" as const };
    const link = linkText(this.#store, this.#context.engine, { ...this.#store.state, session });
    if (isTooLong(link)) this.#store.refuse(t("library.too-long"));
    else await this.#add({ kind, name, folder, link });
  }

  /** Makes a study whose first chapter is what the table shows, and opens it. */
  async addStudy(title: string, folder: string): Promise<void> {
    const first = this.chapter(t("lesson.chapter", { number: 1 }));
    const study: StudyFile = {
      format: "carom-study/1",
      title,
      language: LANGUAGES[language()].tag,
      chapters: [first],
    };
    await this.#addOpened(study, folder);
  }

  /** Adds the open study to the library, where it can be changed. */
  async copy(): Promise<void> {
    const { lesson } = this.#run;
    if (lesson) await this.#addOpened(lesson.study, "", lesson.chapter);
  }

  /** A chapter of what the table shows. */
  chapter(
    title: string,
    more: { text?: string; task?: StudyFile["chapters"][number]["task"] } = {},
  ) {
    const { document } = this.#store;
    const dated = this.#context.engine.withDatedNames(document.shot);
    const { text, task } = more;
    return chapterOf(document, dated, {
      title: title.slice(0, LONGEST_TITLE),
      ...(text !== undefined && { text }),
      ...(task && { task }),
    });
  }

  /** Stores a change of the open study. A study that the engine refuses changes nothing. */
  change(study: StudyFile, chapter: number): boolean {
    const own = this.#own;
    if (own?.kind !== "study" || !this.#accepts(study)) return false;
    this.#run.revise(study, chapter, own.id);
    this.#storing = this.#storing.then(() => this.#keep(study));
    return true;
  }

  async #keep(study: StudyFile): Promise<void> {
    const own = this.#own;
    if (own?.kind !== "study" || !this.#library) return;
    const stored = await this.#library.change({ ...own, name: study.title, study });
    if (!stored) return;
    const isCopy = stored.id !== own.id;
    this.#own = stored;
    const { lesson } = this.#run;
    // Another tab has changed the study: this one goes on with a copy.
    if (isCopy && lesson?.id === own.id) {
      this.#store.setSession({ lesson: { ...lesson, id: stored.id } });
      this.#context.announce(t("library.copied-change"));
    }
  }

  /** The link to a study that opens read-only; null if it is too long. */
  link(): string | null {
    const { lesson } = this.#run;
    if (!lesson) return null;
    return lessonToFragment({ ...lesson, id: null, chapter: 0 }, this.#store.view);
  }

  /** The file of a study. */
  file(study: StudyFile): string {
    return `${toPrettyJson(study)}\n`;
  }

  async #addOpened(study: StudyFile, folder: string, chapter = 0): Promise<void> {
    if (!this.#accepts(study)) return;
    const entry = await this.#add({ kind: "study", name: study.title, folder, study });
    if (!entry) return;
    this.#own = entry;
    this.#run.open(study, entry.id, chapter);
  }

  async #add(entry: Parameters<Library["add"]>[0]): Promise<LibraryEntry | null> {
    const added = (await this.#library?.add(entry)) ?? null;
    if (added) this.#context.announce(t("library.added", { name: added.name }));
    else this.#store.refuse(t("library.not-stored"));
    for (const listener of this.#listeners) listener();
    return added;
  }

  #accepts(study: StudyFile): boolean {
    try {
      this.#context.engine.study(JSON.stringify(study));
      return true;
    } catch (error) {
      if (!(error instanceof CaromError)) throw error;
      this.#store.refuse(t("kept.refused", { why: errorText(error) }));
      return false;
    }
  }
}
