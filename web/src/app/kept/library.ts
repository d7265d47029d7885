/** The library in the browser's storage: named positions, games and studies in folders. */

import { freshId } from "../common/fresh-id.ts";
import { KeptFault } from "./kept-fault.ts";
import type { KeptStorage } from "./kept-storage.ts";
import {
  ENTRY_FORMAT,
  entryOf,
  type LibraryEntry,
  type LinkEntry,
  type StudyEntry,
} from "./library-entry.ts";

/** An entry; the library gives it what this leaves out. */
export type NewEntry =
  Omit<LinkEntry, "format" | "id" | "changed"> | Omit<StudyEntry, "format" | "id" | "changed">;

/** What the storage has of the library. */
export interface Shelf {
  /** By folder and name. */
  readonly entries: readonly LibraryEntry[];
  /** Entries that cannot be read, as they are stored. */
  readonly damaged: readonly unknown[];
}

export class Library {
  readonly storage: KeptStorage;
  readonly #listeners = new Set<() => void>();

  constructor(storage: KeptStorage) {
    this.storage = storage;
  }

  /** Calls `listener` when an entry was stored or deleted. */
  subscribe(listener: () => void): void {
    this.#listeners.add(listener);
  }

  async list(): Promise<Shelf> {
    const entries: LibraryEntry[] = [];
    const damaged: unknown[] = [];
    for (const data of await this.storage.all("library")) {
      const entry = readEntry(data);
      if (entry) entries.push(entry);
      else damaged.push(data);
    }
    entries.sort((a, b) => a.folder.localeCompare(b.folder) || a.name.localeCompare(b.name));
    return { entries, damaged };
  }

  /** The entry with an id; null if it is not there or damaged. */
  async get(id: string): Promise<LibraryEntry | null> {
    return readEntry(await this.storage.get("library", id));
  }

  /** Adds an entry. @returns Null if the browser did not store it. */
  async add(entry: NewEntry): Promise<LibraryEntry | null> {
    const added: LibraryEntry = {
      ...entry,
      format: ENTRY_FORMAT,
      id: freshId(),
      changed: new Date().toISOString(),
    };
    return (await this.#put(added)) ? added : null;
  }

  /**
   * Changes an entry. If another tab has changed it meanwhile, or deleted it, the change becomes an entry of its
   * own, so that nothing is overwritten.
   *
   * @param entry The entry as it was read, with what is changed.
   * @returns What is stored; null if the browser did not store it.
   */
  async change(entry: LibraryEntry): Promise<LibraryEntry | null> {
    const there = await this.get(entry.id);
    if (there?.changed !== entry.changed) return this.add(entry);
    const next = { ...entry, changed: laterThan(entry.changed) };
    return (await this.#put(next)) ? next : null;
  }

  /** Stores an entry that was deleted again. */
  async restore(entry: LibraryEntry): Promise<void> {
    await this.#put(entry);
  }

  async remove(id: string): Promise<void> {
    await this.storage.remove("library", id);
    this.changed();
  }

  /** Tells the listeners that the stored entries are others. */
  changed(): void {
    for (const listener of this.#listeners) listener();
  }

  async #put(entry: LibraryEntry): Promise<boolean> {
    const isStored = await this.storage.put("library", entry);
    this.changed();
    return isStored;
  }
}

/** The present time; later than another one also within its millisecond. */
function laterThan(time: string): string {
  return new Date(Math.max(Date.now(), Date.parse(time) + 1)).toISOString();
}

function readEntry(data: unknown): LibraryEntry | null {
  try {
    return entryOf(data, "entry");
  } catch (error) {
    if (error instanceof KeptFault) return null;
    throw error;
  }
}
