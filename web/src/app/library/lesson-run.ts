/**
 * A study that is open: it sets the positions of the chapters on the table, judges the shots of a task after their
 * replay, and restores the earlier document at the end.
 */

import { CaromError, type StudyChapter, type StudyFile, type Trace } from "../../engine/index.ts";
import { outlineOf } from "../common/area-outline.ts";
import type { Context } from "../common/context.ts";
import { treeEngine } from "../document/balls-after.ts";
import type { AimedShot, Attempt, Document, Session } from "../document/document.ts";
import { areasOf, positionOf } from "../document/lesson.ts";
import type { Lesson } from "../document/open-study.ts";
import { startsFrom, type TreeNode } from "../document/shot-tree.ts";
import type { State, Store } from "../document/store.ts";
import { leave, replay } from "../replay/replay-control.ts";
import { t } from "../words/translate.ts";
import { goalText, verdictText } from "./lesson-words.ts";

/** Time (ms) between the end of a replay and the next attempt: enough to see where the balls stopped. */
const PAUSE = 1600;

/** Colour of the areas in which a ball shall stop, as of drills. */
const TARGET = "#ffffff";

type Position = ReturnType<typeof positionOf>;

export class LessonRun {
  readonly #store: Store;
  readonly #context: Context;
  readonly #leavePractice: () => void;
  readonly #listeners = new Set<() => void>();
  readonly #positions = new WeakMap<StudyChapter, Position>();
  /** The document before the study; null if the page was opened with it. */
  #before: Document | null = null;
  /** How the last shot of the chapter's task went; empty before the first. */
  said = "";
  /** Whether the task of the chapter is solved, or its solution was shown. */
  isOpen = true;
  #attempt: Attempt | null = null;
  /** The verdict of the shot that is replayed. */
  #verdict: { readonly said: string; readonly met: boolean } | null = null;
  #timer: ReturnType<typeof setTimeout> | undefined;

  constructor(store: Store, context: Context, leavePractice: () => void) {
    this.#store = store;
    this.#context = context;
    this.#leavePractice = leavePractice;
    store.subscribe((now, before) => this.#follow(now, before));
    if (this.lesson) this.#begin();
  }

  subscribe(listener: () => void): void {
    this.#listeners.add(listener);
  }

  get lesson(): Lesson | null {
    return this.#store.session.lesson;
  }

  get chapter(): StudyChapter | null {
    const { lesson } = this;
    return lesson?.study.chapters[lesson.chapter] ?? null;
  }

  /** The shots of the chapter's tree. */
  get shots(): readonly TreeNode[] {
    return (this.chapter && this.#positionOf(this.chapter).tree?.nodes) ?? [];
  }

  /** Whether the balls lie as in the chapter. */
  get isSet(): boolean {
    const { chapter } = this;
    return (
      chapter !== null && startsFrom(this.#store.document.shot, this.#positionOf(chapter).shot)
    );
  }

  /**
   * Opens a study. The document is kept until `close`.
   *
   * @param id Its id in the library; null: it can only be read.
   */
  open(study: StudyFile, id: string | null, chapter = 0): boolean {
    this.#leavePractice();
    const before = this.lesson ? this.#before : this.#store.document;
    if (!this.#show({ study, id, chapter })) return false;
    this.#before = before;
    return true;
  }

  /** Shows a chapter. */
  go(chapter: number): void {
    const { lesson } = this;
    if (lesson?.study.chapters[chapter]) this.#show({ ...lesson, chapter });
  }

  /** Puts a changed study in the place of the open one; the table stays as it is. */
  revise(study: StudyFile, chapter: number, id: string | null): void {
    const isSame = this.lesson?.chapter === chapter;
    this.#store.setSession({ lesson: { study, chapter, id } });
    if (!isSame) this.#show({ study, chapter, id });
    else this.#begin();
  }

  close(): void {
    const before = this.#before;
    this.#before = null;
    clearTimeout(this.#timer);
    leave(this.#store);
    this.#store.setSession({ lesson: null });
    this.#changed();
    if (before && before !== this.#store.document) {
      this.#store.apply({ ...before }, t("change.close-study"));
    }
  }

  /** Plays a shot of the chapter: its own, or one of its tree. */
  play(shot: AimedShot): void {
    if (this.#store.document.shot !== shot) {
      leave(this.#store);
      if (!this.#store.apply({ shot, game: null }, t("change.chapter-shot"))) return;
    }
    const { trace } = this.#store.ghost;
    const still = this.#context.reducedMotion();
    if (trace) replay(this.#store, trace, still ? trace.duration : 0, !still);
  }

  /** Plays the solution of the task, which counts as shown. */
  showSolution(): void {
    const { chapter } = this;
    const solution = chapter?.task?.solution;
    if (!chapter || !solution) return;
    this.isOpen = false;
    this.said = "";
    this.#changed();
    this.play({ ...this.#positionOf(chapter).shot, strike: solution });
  }

  /** Sets the balls of the chapter again. */
  setAgain(): void {
    const { lesson } = this;
    if (lesson) this.#show(lesson);
  }

  #positionOf(chapter: StudyChapter): Position {
    let position = this.#positions.get(chapter);
    if (!position) {
      position = positionOf(chapter, treeEngine(this.#context.engine).endOf);
      this.#positions.set(chapter, position);
    }
    return position;
  }

  #show(lesson: Lesson): boolean {
    const chapter = lesson.study.chapters[lesson.chapter]!;
    let position: Position;
    try {
      position = this.#positionOf(chapter);
    } catch (error) {
      if (!(error instanceof CaromError)) throw error;
      this.#store.refuse(error.message);
      return false;
    }
    clearTimeout(this.#timer);
    leave(this.#store);
    // Own marks of the chapter take the place of those of the one before.
    const change = { ...position, game: null, noise: null, study: undefined, filmed: undefined };
    this.#store.setSession({ activity: "library" });
    if (!this.#store.apply(change, t("change.chapter"))) return false;
    this.#store.setSession({ activity: "library", lesson });
    this.#begin();
    return true;
  }

  #begin(): void {
    this.said = "";
    this.isOpen = true;
    this.#verdict = null;
    this.#changed();
  }

  /** Shows the task on the table, and informs the panel. */
  #changed(): void {
    const wanted = this.#wanted();
    const { attempt } = this.#store.session;
    // An attempt of somebody else, such as of a drill, stays.
    if (wanted || (attempt !== null && attempt === this.#attempt)) {
      this.#attempt = wanted;
      this.#store.setSession({ attempt: wanted });
    }
    for (const listener of this.#listeners) listener();
  }

  /** What the table shows of the task; null if there is none, once it is solved, and in another activity. */
  #wanted(): Attempt | null {
    const task = this.chapter?.task;
    if (!task || !this.isOpen || this.#store.session.activity !== "library") return null;
    const text = this.said === "" ? goalText(task.goal) : this.said;
    const areas = areasOf(task.goal).map((area) => ({
      outline: outlineOf(area, this.#store.shot.geometry),
      color: TARGET,
    }));
    const pot = task.goal.find((condition) => condition.kind === "pot");
    const pocket = pot?.pocket;
    return { text, areas, errors: null, seed: 0, ...(pocket && { pocket }) };
  }

  #follow({ session: is }: State, { session: was }: State): void {
    if (is.lesson !== was.lesson && was.lesson === null) {
      // A link or a reload has opened it.
      this.#begin();
      return;
    }
    if (!is.lesson) return;
    if (is.activity !== was.activity) {
      this.#changed();
      return;
    }
    this.#judge(is, was);
  }

  #judge(is: Session, was: Session): void {
    const { trace, playing, time } = is.replay;
    const task = this.chapter?.task;
    const isOwn = is.attempt !== null && is.attempt === this.#attempt;
    if (is.mode === "replay" && was.mode === "aim" && trace && task && isOwn) {
      this.#verdict = this.#verdictOf(trace, task.goal);
    }
    if (!this.#verdict) return;
    const ended = is.mode === "replay" && trace && !playing && time >= trace.duration;
    if (ended || is.mode === "aim") this.#pronounce(is.mode === "replay");
  }

  #verdictOf(trace: Trace, goal: NonNullable<StudyChapter["task"]>["goal"]) {
    if (!this.isSet) return { said: t("deviation.balls"), met: false };
    const verdict = this.#context.engine.judge(trace, goal);
    return { said: verdictText(goal, verdict), met: verdict.met };
  }

  /** @param waits Whether the replay stays for a moment. */
  #pronounce(waits: boolean): void {
    const { said, met } = this.#verdict!;
    this.#verdict = null;
    this.said = said;
    if (met) this.isOpen = false;
    this.#context.announce(said);
    this.#changed();
    clearTimeout(this.#timer);
    if (!waits) return;
    this.#timer = setTimeout(() => {
      const { mode, replay: shown } = this.#store.session;
      if (mode === "replay" && !shown.playing) leave(this.#store);
    }, PAUSE);
  }
}
