/**
 * The browser's database of what the page keeps: works in progress, games that have ended, the library, and the
 * progress in drills and puzzles. Another tab may write into it at any time; every entry has an id of its own, and a tab
 * writes only to its own works.
 */

import { type DBSchema, type IDBPDatabase, openDB } from "idb";
import type { FinishedGame } from "./finished-game.ts";
import type { Kind, KeptWork } from "./kept-work.ts";
import type { ProgressEntry } from "../train/progress/progress-entries.ts";
import type { LibraryEntry } from "./library-entry.ts";

/** Name and version of the database. */
const NAME = "carom";
const VERSION = 3;

/** The most works of a kind that are kept; older ones are dropped. */
export const MOST_WORKS = 10;

interface Schema extends DBSchema {
  works: { key: string; value: KeptWork; indexes: { order: [Kind, string] } };
  games: { key: string; value: FinishedGame; indexes: { ended: string } };
  library: { key: string; value: LibraryEntry };
  progress: { key: string; value: ProgressEntry };
}

/** What an entry of each table is. */
export interface Entries {
  readonly works: KeptWork;
  readonly games: FinishedGame;
  readonly library: LibraryEntry;
  readonly progress: ProgressEntry;
}

/** Why nothing is kept: the browser refuses, there is no room, or the database is damaged. */
export type StorageFault = "refused" | "full" | "damaged";

export type Table = keyof Entries;

export class KeptStorage {
  readonly #opening: Promise<IDBPDatabase<Schema> | null>;
  #base: IDBPDatabase<Schema> | null = null;
  #fault: StorageFault | null = null;
  readonly #listeners = new Set<() => void>();

  constructor() {
    this.#opening = this.#open();
  }

  /** What kept the page from storing something the last time; null if it was stored. */
  get fault(): StorageFault | null {
    return this.#fault;
  }

  /** Calls `listener` when the fault changes. */
  subscribe(listener: () => void): void {
    this.#listeners.add(listener);
  }

  /** Shows `see` the stored works of a kind, the newest first, as long as it returns true. */
  async eachWork(kind: Kind, see: (data: unknown) => boolean): Promise<void> {
    await this.#read(async (base) => {
      const index = base.transaction("works").store.index("order");
      let cursor = await index.openCursor(rangeOf(kind), "prev");
      while (cursor && see(cursor.value)) cursor = await cursor.continue();
    }, undefined);
  }

  /** Shows `see` the stored games, those that ended last first, as long as it returns true. */
  async eachGame(see: (data: unknown) => boolean): Promise<void> {
    await this.#read(async (base) => {
      let cursor = await base.transaction("games").store.index("ended").openCursor(null, "prev");
      while (cursor && see(cursor.value)) cursor = await cursor.continue();
    }, undefined);
  }

  /** All entries of a table, in the order of their ids. */
  async all(table: "library" | "progress"): Promise<readonly unknown[]> {
    return this.#read<readonly unknown[]>((base) => base.getAll(table), []);
  }

  async get(table: Table, id: string): Promise<unknown> {
    return this.#read((base) => base.get(table, id) as Promise<unknown>, undefined);
  }

  /**
   * Stores entries in the place of those with their ids, all or none. They are sent to the browser at once, so that they
   * are kept when the page is closed in the next moment.
   *
   * @returns Whether they are stored; if not, `fault` has the reason.
   */
  async put<T extends Table>(table: T, ...entries: readonly Entries[T][]): Promise<boolean> {
    const isStored = await this.#change(async (base) => {
      const transaction = base.transaction(table, "readwrite");
      const writing = entries.map((entry) => transaction.store.put(entry));
      transaction.commit();
      try {
        await Promise.all([...writing, transaction.done]);
      } catch (error) {
        // The request only says that its transaction was aborted.
        throw transaction.error ?? error;
      }
    });
    if (isStored) this.#say(null);
    return isStored;
  }

  async remove(table: Table, ...ids: readonly string[]): Promise<void> {
    await this.#change(async (base) => {
      const { store, done } = base.transaction(table, "readwrite");
      await Promise.all([...ids.map((id) => store.delete(id)), done]);
    });
  }

  /** Deletes all but the newest works of a kind, except those with ids in `held`. */
  async prune(kind: Kind, held: ReadonlySet<string>): Promise<void> {
    await this.#change(async (base) => {
      const { store, done } = base.transaction("works", "readwrite");
      let cursor = await store.index("order").openCursor(rangeOf(kind), "prev");
      for (let count = 0; cursor; cursor = await cursor.continue()) {
        count += 1;
        if (count > MOST_WORKS && !held.has(cursor.primaryKey)) await cursor.delete();
      }
      await done;
    });
  }

  async #open(): Promise<IDBPDatabase<Schema> | null> {
    // Some browsers have no database in private windows, and old ones none at all.
    if (!(globalThis as { readonly indexedDB?: IDBFactory | null }).indexedDB) {
      this.#say("refused");
      return null;
    }
    try {
      const base = await openDB<Schema>(NAME, VERSION, {
        upgrade: (fresh, before) => {
          if (before < 1) {
            fresh
              .createObjectStore("works", { keyPath: "id" })
              .createIndex("order", ["kind", "changed"]);
            fresh.createObjectStore("games", { keyPath: "id" }).createIndex("ended", "ended");
          }
          if (before < 2) fresh.createObjectStore("library", { keyPath: "id" });
          fresh.createObjectStore("progress", { keyPath: "id" });
        },
        // A newer page in another tab may change the database.
        blocking: () => this.#close("refused"),
        terminated: () => this.#close("damaged"),
      });
      this.#base = base;
      return base;
    } catch (error) {
      this.#fail(error, "refused");
      return null;
    }
  }

  #close(fault: StorageFault): void {
    this.#base?.close();
    this.#base = null;
    this.#say(fault);
  }

  async #read<T>(read: (base: IDBPDatabase<Schema>) => Promise<T>, otherwise: T): Promise<T> {
    await this.#opening;
    if (!this.#base) return otherwise;
    try {
      return await read(this.#base);
    } catch (error) {
      this.#fail(error, "damaged");
      return otherwise;
    }
  }

  /** Does not wait if the database is open: a page that is closed has no time to wait. */
  async #change(change: (base: IDBPDatabase<Schema>) => Promise<void>): Promise<boolean> {
    if (!this.#base) await this.#opening;
    if (!this.#base) return false;
    try {
      await change(this.#base);
      return true;
    } catch (error) {
      this.#fail(error, "damaged");
      return false;
    }
  }

  #fail(error: unknown, otherwise: StorageFault): void {
    if (!(error instanceof DOMException) || error.name === "DataCloneError") throw error;
    this.#say(faultOf(error.name) ?? otherwise);
  }

  #say(fault: StorageFault | null): void {
    if (fault === this.#fault) return;
    this.#fault = fault;
    for (const listener of this.#listeners) listener();
  }
}

function rangeOf(kind: Kind): IDBKeyRange {
  return IDBKeyRange.bound([kind, ""], [kind, "\uffff"]);
}

/** The fault that an error of the browser's database tells; null if it may have several reasons. */
export function faultOf(name: string): StorageFault | null {
  if (name === "QuotaExceededError") return "full";
  if (["SecurityError", "InvalidStateError"].includes(name)) return "refused";
  return null;
}
