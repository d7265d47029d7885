/**
 * A drill or a puzzle in progress, on the page's table or at a real one. On the page it sets
 * the balls, judges every shot after its replay, and restores the earlier document at the end.
 */

import type { DrawnMark, Strike, Trace } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import type { AimedShot, Attempt, Document } from "../document/document.ts";
import { withMarks } from "../document/marks.ts";
import { aimed } from "../document/shot-file.ts";
import type { State, Store } from "../document/store.ts";
import { shoot } from "../aim/shoot.ts";
import { leave } from "../replay/replay-control.ts";
import { paragraph, t } from "../words/translate.ts";
import { markedAreas } from "./drill-areas.ts";
import type { Drill } from "./drills/index.ts";
import { judge } from "./drill-judge.ts";
import { type Deviation, deviation, layoutOf, type Setting } from "./drill-layout.ts";
import { clothOf } from "./drill-places.ts";
import type { Keeper } from "./progress/progress-keeper.ts";
import type { Result } from "./progress/practice-progress.ts";
import type { PuzzleTask } from "./puzzle/puzzle-task.ts";
import { aimedAt, continued, runOf } from "./practice-layout.ts";
import type { KeptPractice, OnPage, Running } from "./practice-state.ts";
import { resumed } from "./resumed-practice.ts";
import { counted, isOver, stepAfter } from "./drill-score.ts";
import { goalText, scoreText, verdictText } from "./train-words.ts";

/** Time (ms) between the end of a replay and the next attempt: enough to see where the balls stopped. */
const PAUSE = 1600;

/** Seeds of errors are below this. */
const SEEDS = 2 ** 31;

export class Practice {
  readonly #store: Store;
  readonly #context: Context;
  readonly #keeper: Keeper;
  readonly #listeners = new Set<() => void>();
  #running: Running | null = null;
  #page: OnPage | null = null;

  constructor(store: Store, context: Context, keeper: Keeper) {
    this.#store = store;
    this.#context = context;
    this.#keeper = keeper;
    store.subscribe((now, before) => this.#follow(now, before));
  }

  /** What is practised; null if nothing is. */
  get running(): Running | null {
    return this.#running;
  }

  /** The step of the present attempt. */
  get setting(): Setting | null {
    const running = this.#running;
    if (!running) return null;
    const { drill, points } = running;
    return { drill, step: drill.steps[stepAfter(drill, points)]!, attempt: points.length };
  }

  /** How the balls on the page differ from the layout; null if they do not, or at a real table. */
  get deviation(): Deviation | null {
    const { setting } = this;
    if (!setting || !this.#page || this.#running?.result) return null;
    const { shot } = this.#store.document;
    return deviation(this.#context.engine, setting, this.#page.set, shot, this.#inHand());
  }

  subscribe(listener: () => void): void {
    this.#listeners.add(listener);
  }

  /** Starts a drill on the page's table. The document is kept until `leave`. */
  start(drill: Drill, errors: string | null, puzzle: PuzzleTask | null = null): void {
    const before = this.#page?.before ?? this.#store.document;
    const setting = { drill, step: drill.steps[0]!, attempt: 0 };
    // In the order of the balls in which the engine has measured the puzzle.
    const set = puzzle ? aimed(puzzle.puzzle.shot) : layoutOf(this.#context.engine, setting);
    if (!this.#apply(set)) return;
    const seed = Math.floor(Math.random() * SEEDS);
    clearTimeout(this.#page?.timer);
    this.#page = {
      before,
      set,
      seed,
      verdict: null,
      next: null,
      shown: false,
      deviation: null,
      timer: undefined,
    };
    this.#begin(drill, "page", errors, puzzle);
  }

  /** Starts a drill at a real table. */
  startAtTable(drill: Drill): void {
    this.leave();
    this.#begin(drill, "table", null, null);
  }

  /**
   * What a reload keeps, and the document before the drill; null if nothing is practised. A shot whose
   * replay has not ended counts now.
   */
  keep(): { readonly kept: KeptPractice; readonly before: Document | null } | null {
    if (!this.#running) return null;
    if (this.#page && this.#page.verdict !== null) this.#pronounce(this.#page, false);
    if (this.#page) leave(this.#store);
    return this.snapshot();
  }

  /** As `keep`, but nothing changes: a shot whose replay has not ended does not count. */
  snapshot(): { readonly kept: KeptPractice; readonly before: Document | null } | null {
    if (!this.#running) return null;
    const { drill, puzzle: task, ...running } = this.#running;
    const own = this.#keeper.progress.drills.find(({ name }) => name === drill.name);
    const puzzle = task && { id: task.puzzle.id, date: task.date };
    const page = this.#page && { set: this.#page.set, seed: this.#page.seed };
    const shown = this.#store.session.activity === "train";
    const kept = {
      running: { ...running, puzzle, drill: drill.id, ...(own && { own }) },
      page,
      shown,
    };
    return { kept, before: this.#page?.before ?? null };
  }

  /** Goes on with what a reload has kept. */
  resume({ running, page, shown }: KeptPractice, before: Document | null): void {
    const found = resumed(this.#context.engine, running);
    if (!found || (page && !before)) return;
    this.#running = found;
    this.#page = page && {
      ...page,
      before: before!,
      verdict: null,
      next: null,
      shown: false,
      deviation: null,
      timer: undefined,
    };
    if (shown) this.#store.setSession({ activity: "train" });
    this.#changed();
  }

  /** Ends the drill; on the page's table the document before it comes back. */
  leave(): void {
    const page = this.#page;
    this.#running = null;
    this.#page = null;
    if (page) {
      clearTimeout(page.timer);
      leave(this.#store);
      this.#store.setSession({ attempt: null });
      if (this.#store.document !== page.before) {
        this.#store.apply({ ...page.before }, t("change.leave-drill"));
      }
    }
    this.#changed();
  }

  /** Sets the balls of the present attempt again. */
  setAgain(): void {
    const { setting } = this;
    if (!setting || !this.#page) return;
    this.#apply(this.#page.set);
    this.#changed();
  }

  /** Points of an attempt at a real table. */
  tap(points: number): void {
    this.#count(points, "");
  }

  /** Takes the last attempt at a real table back. */
  takeBack(): void {
    if (this.#running?.place !== "table") return;
    this.#set({ points: this.#running.points.slice(0, -1) });
  }

  /** Counts a hint of the puzzle; with `marks`, draws them beside its balls. */
  hint(marks: readonly DrawnMark[]): void {
    const page = this.#page;
    if (!page || !this.#running) return;
    this.#record(false);
    if (marks.length > 0) {
      page.set = withMarks(page.set, marks);
      this.#apply(page.set);
    }
    this.#set({ hints: this.#running.hints + 1 });
  }

  /** Sets the balls of the puzzle with a strike, to be shot and watched: it does not count. */
  show(strike: Strike): void {
    const page = this.#page;
    if (!page || !this.#running) return;
    this.#record(false);
    clearTimeout(page.timer);
    if (this.#store.session.mode === "replay") leave(this.#store);
    page.shown = true;
    const shot = aimedAt(page.set, strike);
    if (this.#apply(shot)) shoot(this.#store, this.#context);
    this.#set({ seen: true });
  }

  /** Keeps whether the puzzle was solved at the first attempt, without help; only the first call counts. */
  #record(made: boolean): void {
    const { puzzle: task, points, hints, seen } = this.#running!;
    if (!task || points.length > 0 || hints > 0 || seen) return;
    const { id, rating } = task.puzzle;
    const time = new Date().toISOString();
    this.#keeper.addAttempt({ puzzle: id, time, made, rating: Math.round(rating) });
  }

  #begin(drill: Drill, place: Result["place"], errors: string | null, puzzle: PuzzleTask | null) {
    this.#running = {
      drill,
      place,
      errors,
      puzzle,
      hints: 0,
      seen: false,
      points: [],
      shots: 0,
      left: runOf(drill),
      said: "",
      result: null,
      solved: false,
    };
    this.#changed();
  }

  #set(patch: Partial<Running>): void {
    if (!this.#running) return;
    this.#running = { ...this.#running, ...patch };
    this.#changed();
  }

  /** Shows the attempt on the table, and informs the panel. */
  #changed(): void {
    if (this.#page) this.#store.setSession({ attempt: this.#attempt() });
    for (const listener of this.#listeners) listener();
  }

  /** What the table shows of the attempt; null once the drill is over, and in another activity. */
  #attempt(): Attempt | null {
    const { setting } = this;
    const running = this.#running;
    if (!setting || !running || !this.#page || running.result || running.solved) return null;
    if (this.#store.session.activity !== "train") return null;
    const { engine } = this.#context;
    const goal = goalText(setting);
    return {
      text: paragraph([running.said, ...(running.said === "" ? [goal] : []), scoreText(running)]),
      areas: markedAreas(engine, setting, this.#inHand()),
      errors: running.errors === null ? null : (engine.noisePresets[running.errors] ?? null),
      seed: this.#page.seed,
    };
  }

  /** Whether the cue ball may be placed now: only before the first shot of an attempt. */
  #inHand(): boolean {
    return this.#running?.shots === 0;
  }

  #apply(file: AimedShot): boolean {
    // A miscue is an attempt too.
    const shot: AimedShot = { ...file, strike: { ...file.strike, miscue: "report" } };
    return this.#store.apply({ shot, noise: null, game: null }, t("change.drill"));
  }

  #follow(now: State, before: State): void {
    const page = this.#page;
    if (!page || !this.#running) return;
    if (now.session.activity !== before.session.activity) {
      this.#changed();
      return;
    }
    if (!now.session.attempt) return;
    const [is, was] = [now.session, before.session];
    const { trace, playing, time } = is.replay;
    if (is.mode === "replay" && was.mode === "aim" && trace) this.#shot(page, trace);
    const ended = is.mode === "replay" && trace && !playing && time >= trace.duration;
    if (ended && page.shown) this.#wait(page);
    if (ended && page.verdict !== null) this.#pronounce(page, true);
    else if (is.mode === "aim" && page.verdict !== null) this.#pronounce(page, false);
    else if (is.mode === "aim" && was.mode === "replay") {
      page.shown = false;
      this.#next(page);
    }
    // The user watches the shot again.
    if (is.mode === "replay" && playing) clearTimeout(page.timer);
    const { deviation } = this;
    if (deviation === page.deviation) return;
    page.deviation = deviation;
    for (const listener of this.#listeners) listener();
  }

  /** Judges a shot; the verdict is pronounced when its replay ends. */
  #shot(page: OnPage, trace: Trace): void {
    const { setting } = this;
    const running = this.#running!;
    if (page.shown) return;
    page.verdict =
      this.deviation ??
      judge(clothOf(this.#context.engine, running.drill.table), setting!.step, trace, running.left);
    page.next = continued(page.set, trace);
    page.seed = (page.seed + 1) % SEEDS;
  }

  /** @param waits Whether the replay stays for a moment. */
  #pronounce(page: OnPage, waits: boolean): void {
    const verdict = page.verdict!;
    page.verdict = null;
    if (typeof verdict === "string") {
      const said = t(`deviation.${verdict}`);
      this.#context.announce(said);
      this.#set({ said });
    } else {
      const { setting } = this;
      const said = verdictText(verdict, setting!);
      this.#context.announce(said);
      if (verdict.left.length > 0) {
        page.set = page.next!;
        this.#set({ said, left: verdict.left, shots: this.#running!.shots + 1 });
      } else {
        this.#count(verdict.points, said);
      }
    }
    if (waits) this.#wait(page);
    else this.#next(page);
  }

  /** Leaves the replay after a moment. */
  #wait(page: OnPage): void {
    clearTimeout(page.timer);
    page.timer = setTimeout(() => {
      if (this.#store.session.mode === "replay") leave(this.#store);
    }, PAUSE);
  }

  /** Sets the balls of the next shot, unless they lie so already. */
  #next(page: OnPage): void {
    if (this.#running?.result || this.#running?.solved) return;
    if (this.deviation !== null && this.#page === page) this.#apply(page.set);
    this.#changed();
  }

  /** Counts an attempt, and sets the layout of the next one. */
  #count(points: number, said: string): void {
    const running = this.#running;
    const { setting } = this;
    if (!running || !setting || running.result) return;
    const { drill } = running;
    const step = drill.steps.indexOf(setting.step);
    const all = [...running.points, counted(drill, step, points)];
    const next = { points: all, said, shots: 0, left: runOf(drill) };
    if (running.puzzle) {
      const solved = points > 0;
      const { date } = running.puzzle;
      this.#record(solved);
      if (date !== null) this.#keeper.addPuzzle({ date, tries: all.length, solved });
      this.#set({ ...next, solved });
    } else if (!isOver(drill, all)) {
      this.#running = { ...running, ...next };
      if (this.#page) this.#page.set = this.#layout();
      this.#changed();
    } else {
      const { place, errors } = running;
      const ended = new Date().toISOString();
      const result = { drill: drill.id, ended, place, points: all, errors };
      this.#keeper.addResult(result);
      this.#set({ ...next, result });
    }
  }

  #layout(): AimedShot {
    return layoutOf(this.#context.engine, this.setting!);
  }
}
