/** Keeps the progress in the browser's storage, or in memory where there is none. */

import {
  DamagedProgress,
  merged,
  NOTHING,
  type Progress,
  progressOfText,
  progressToText,
  type PuzzleResult,
  type Result,
} from "./practice-progress.ts";

/** Name of the progress in the browser's storage, and of copies that could not be read. */
const STORED = "carom-progress";
const DAMAGED = "carom-progress-damaged";

/** The part of the browser's storage that is used. */
export type Box = Pick<Storage, "getItem" | "setItem" | "removeItem">;

export class Keeper {
  readonly #box: Box | null;
  readonly #listeners = new Set<() => void>();
  #present: Progress = NOTHING;
  #isKept = true;
  #damaged: string | null = null;

  /** @param box Null if the browser has no storage for this page. */
  constructor(box: Box | null) {
    this.#box = box;
    this.#read();
  }

  get progress(): Progress {
    return this.#present;
  }

  /** Whether the progress is still there when the page is opened again. */
  get isKept(): boolean {
    return this.#isKept;
  }

  /** What was stored and could not be read; null if nothing was. It is set aside, not lost. */
  get damaged(): string | null {
    return this.#damaged;
  }

  addResult(result: Result): void {
    this.add({ results: [result], puzzles: [] });
  }

  addPuzzle(puzzle: PuzzleResult): void {
    this.add({ results: [], puzzles: [puzzle] });
  }

  /** Adds what is not there yet. */
  add(more: Progress): void {
    // Another tab may have stored something since.
    this.#read();
    this.#present = merged(this.#present, more);
    this.#write();
    this.#changed();
  }

  /** Deletes the progress. Damaged copies that were set aside stay. */
  clear(): void {
    this.#present = NOTHING;
    try {
      this.#box?.removeItem(STORED);
    } catch {
      this.#isKept = false;
    }
    this.#changed();
  }

  /** Reads what another tab has stored, or forgets what it has deleted. */
  refresh(): void {
    this.#read();
    this.#changed();
  }

  subscribe(listener: () => void): void {
    this.#listeners.add(listener);
  }

  #changed(): void {
    for (const listener of this.#listeners) listener();
  }

  #read(): void {
    let text: string | null;
    try {
      if (!this.#box) throw new Error("no storage");
      text = this.#box.getItem(STORED);
    } catch {
      this.#isKept = false;
      return;
    }
    // What could not be stored is in memory alone.
    const unkept = this.#isKept ? NOTHING : this.#present;
    if (text === null) {
      this.#present = unkept;
      return;
    }
    try {
      this.#present = merged(progressOfText(text), unkept);
    } catch (error) {
      if (!(error instanceof DamagedProgress)) throw error;
      this.#setAside(text);
    }
  }

  /** Moves a text that cannot be read to a name of its own, so that it is not overwritten. */
  #setAside(text: string): void {
    this.#damaged = text;
    try {
      let number = 1;
      while (this.#box!.getItem(`${DAMAGED}-${number}`) !== null) number += 1;
      this.#box!.setItem(`${DAMAGED}-${number}`, text);
      this.#box!.removeItem(STORED);
    } catch {
      // There is no room for a copy: the original stays, and nothing more is stored.
      this.#isKept = false;
    }
  }

  #write(): void {
    if (!this.#isKept) return;
    try {
      this.#box!.setItem(STORED, progressToText(this.#present));
    } catch {
      this.#isKept = false;
    }
  }
}

/** The browser's storage; null where a page may not use it. */
export function browserBox(): Box | null {
  try {
    return localStorage;
  } catch {
    // Some frames and browsers have no storage.
    return null;
  }
}
