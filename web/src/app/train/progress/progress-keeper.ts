/** Keeps the progress in the browser's database, or in memory where there is none. */

import type { DrillFile } from "../../../engine/index.ts";
import { type Box, earlierProgress } from "./earlier-progress.ts";
import {
  NOTHING,
  type Progress,
  type PuzzleAttempt,
  type PuzzleResult,
  type Result,
  sameDrill,
  withDrill,
} from "./practice-progress.ts";
import {
  entriesOf,
  idsOfDrill,
  type ProgressEntry,
  progressOfEntries,
  type StoredProgress,
} from "./progress-entries.ts";

/** The part of the browser's database that is used: see `KeptStorage`. */
export interface ProgressStorage {
  all(table: "progress"): Promise<readonly unknown[]>;
  put(table: "progress", ...entries: readonly ProgressEntry[]): Promise<boolean>;
  remove(table: "progress", ...ids: readonly string[]): Promise<void>;
  readonly fault: unknown;
}

export class Keeper {
  /** When what is stored is read, and an earlier version's progress is moved over. */
  readonly ready: Promise<void>;
  readonly #storage: ProgressStorage | null;
  readonly #listeners = new Set<() => void>();
  /** By their ids, those that are being stored too. */
  readonly #entries = new Map<string, ProgressEntry>();
  /** Whether the browser refused to store the last ones. */
  #isRefused = false;
  #stored: StoredProgress = { progress: NOTHING, damaged: null };
  /** The ids of those that the browser did not store. They are in memory, and sent again with the next ones. */
  readonly #unkept = new Set<string>();
  /** Called when something was stored or deleted, for other tabs. */
  onStored: () => void = () => undefined;

  /**
   * @param storage Null if the page keeps nothing.
   * @param box Where earlier versions kept the progress; null if there is none.
   */
  constructor(storage: ProgressStorage | null, box: Box | null) {
    this.#storage = storage;
    this.ready = this.#start(box);
  }

  get progress(): Progress {
    return this.#stored.progress;
  }

  /** Whether the progress is still there when the page is opened again. */
  get isKept(): boolean {
    return this.#storage !== null && !this.#storage.fault && !this.#isRefused;
  }

  /** What is stored and cannot be read; null if there is nothing. It stays, and nothing overwrites it. */
  get damaged(): string | null {
    return this.#stored.damaged;
  }

  addResult(result: Result): void {
    void this.add({ ...NOTHING, results: [result] });
  }

  addPuzzle(puzzle: PuzzleResult): void {
    void this.add({ ...NOTHING, puzzles: [puzzle] });
  }

  addAttempt(attempt: PuzzleAttempt): void {
    void this.add({ ...NOTHING, attempts: [attempt] });
  }

  /**
   * Adds a drill, in place of the one with the name `replaced`.
   *
   * @returns The name under which it is kept.
   */
  addDrill(drill: DrillFile, replaced: string | null = null): string {
    const before = this.progress.drills.find(({ name }) => name === replaced);
    const others = this.progress.drills.filter((one) => one !== before);
    const there = sameDrill(others, drill);
    const named = there ?? withDrill(others, drill).at(-1)!;
    const old = before ? idsOfDrill(this.#entries.values(), before) : [];
    const added = there ? [] : entriesOf({ ...NOTHING, drills: [named] });
    void this.#change(added, old);
    return named.name;
  }

  /** Deletes a drill; its results stay. */
  deleteDrill(name: string): void {
    const drill = this.progress.drills.find((one) => one.name === name);
    if (drill) void this.#change([], idsOfDrill(this.#entries.values(), drill));
  }

  /** Adds what is not there yet. @returns Whether the browser has stored it. */
  async add(more: Progress): Promise<boolean> {
    const drills = more.drills.filter((drill) => !sameDrill(this.progress.drills, drill));
    const entries = entriesOf({ ...more, drills }).filter(({ id }) => !this.#entries.has(id));
    return this.#change(entries, []);
  }

  /** Deletes the results. Drills that the user has made stay, and what could not be read. */
  clear(): void {
    const results = [...this.#entries.values()].filter(({ kind }) =>
      ["results", "puzzles", "attempts"].includes(kind),
    );
    void this.#change(
      [],
      results.map(({ id }) => id),
    );
  }

  /** Reads what another tab has stored, or forgets what it has deleted. */
  async refresh(): Promise<void> {
    const stored = ((await this.#storage?.all("progress")) ?? []) as readonly ProgressEntry[];
    for (const id of [...this.#entries.keys()]) {
      if (!this.#unkept.has(id)) this.#entries.delete(id);
    }
    for (const entry of stored) this.#entries.set(entry.id, entry);
    this.#changed();
  }

  subscribe(listener: () => void): void {
    this.#listeners.add(listener);
  }

  async #start(box: Box | null): Promise<void> {
    const stored = (await this.#storage?.all("progress")) as readonly ProgressEntry[] | undefined;
    for (const entry of stored ?? []) this.#entries.set(entry.id, entry);
    const earlier = earlierProgress(box);
    if (earlier && (await this.#change(earlier.entries, []))) earlier.forget();
    else this.#changed();
  }

  /** @returns Whether the browser has stored it. */
  async #change(added: readonly ProgressEntry[], removed: readonly string[]): Promise<boolean> {
    for (const id of removed) {
      this.#entries.delete(id);
      this.#unkept.delete(id);
    }
    for (const entry of added) {
      this.#entries.set(entry.id, entry);
      this.#unkept.add(entry.id);
    }
    // Sent before anything else, since the page may be closed in the next moment.
    const sent = [...this.#unkept].flatMap((id) => this.#entries.get(id) ?? []);
    const storing = this.#store(sent, removed);
    this.#changed();
    const isStored = await storing;
    this.#isRefused = !isStored;
    if (isStored) {
      for (const { id } of sent) this.#unkept.delete(id);
    }
    this.#changed();
    this.onStored();
    return isStored;
  }

  async #store(added: readonly ProgressEntry[], removed: readonly string[]): Promise<boolean> {
    if (!this.#storage) return false;
    const storing = added.length > 0 ? this.#storage.put("progress", ...added) : true;
    if (removed.length > 0) await this.#storage.remove("progress", ...removed);
    return storing;
  }

  #changed(): void {
    this.#stored = progressOfEntries(this.#entries.values());
    for (const listener of this.#listeners) listener();
  }
}
