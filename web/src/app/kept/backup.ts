/** Everything that the page keeps as one file, `carom-backup/1`, and back. */

import { freshId } from "../common/fresh-id.ts";
import {
  DamagedProgress,
  type Progress,
  progressOfData,
  progressToData,
} from "../train/progress/practice-progress.ts";
import type { Keeper } from "../train/progress/progress-keeper.ts";
import { type FinishedGame, finishedOf } from "./finished-game.ts";
import type { FinishedGames } from "./finished-games.ts";
import { check, entriesAt, isEqual, KeptFault, listAt, timeAt } from "./kept-fault.ts";
import type { Entries, KeptStorage, Table } from "./kept-storage.ts";
import { KINDS, type KeptWork, unpacked } from "./kept-work.ts";
import type { Library } from "./library.ts";
import { entryOf, type LibraryEntry } from "./library-entry.ts";
import type { WorkKeeper } from "./work-keeper.ts";

export const BACKUP_FORMAT = "carom-backup/1";

/** The most works, games and entries of the library in a file. */
const MOST = 100_000;

/** The contents of a file, whose structure was checked. */
export interface Backup {
  readonly works: readonly KeptWork[];
  readonly games: readonly FinishedGame[];
  readonly progress: Progress;
  readonly library: readonly LibraryEntry[];
}

/** Where the contents of a file come from and go. */
export interface Kept {
  readonly works: WorkKeeper;
  readonly games: FinishedGames;
  readonly progress: Keeper;
  readonly library: Library;
}

/**
 * The file with everything that can be read.
 *
 * @param engine Name and version of the engine.
 */
export async function backupText(
  { works: { storage }, progress }: Kept,
  engine: string,
): Promise<string> {
  const works: unknown[] = [];
  const games: unknown[] = [];
  const isReadable = (read: () => unknown) => {
    try {
      read();
      return true;
    } catch (error) {
      if (error instanceof KeptFault) return false;
      throw error;
    }
  };
  for (const kind of KINDS) {
    await storage.eachWork(kind, (data) => {
      if (isReadable(() => unpacked(data, "work"))) works.push(data);
      return true;
    });
  }
  await storage.eachGame((data) => {
    if (isReadable(() => finishedOf(data, "game"))) games.push(data);
    return true;
  });
  const library = (await storage.all("library")).filter((data) =>
    isReadable(() => entryOf(data, "entry")),
  );
  const file = {
    format: BACKUP_FORMAT,
    engine,
    saved: new Date().toISOString(),
    works,
    games,
    progress: progressToData(progress.progress),
    library,
  };
  return `${JSON.stringify(file)}\n`;
}

/** Whether a text is such a file, damaged or not. */
export function isBackupText(text: string): boolean {
  return /^\s*\{\s*"format"\s*:\s*"carom-backup\//.test(text.slice(0, 200));
}

/**
 * The contents of a file.
 *
 * @throws {KeptFault} It is damaged; the place is empty if it is not JSON or another file.
 */
export function backupOf(text: string): Backup {
  let data: unknown;
  try {
    data = JSON.parse(text);
  } catch {
    throw new KeptFault("");
  }
  check((data as { format?: unknown } | null)?.format === BACKUP_FORMAT, "");
  const file = entriesAt(
    data,
    "file",
    ["format", "saved", "works", "games", "progress"],
    ["library", "engine"],
  );
  timeAt(file.saved, "saved");
  return {
    works: listAt(file.works, "works", MOST, (item, at) => {
      unpacked(item, at);
      return item as KeptWork;
    }),
    games: listAt(file.games, "games", MOST, finishedOf),
    progress: progressAt(file.progress),
    // A file of an older page has no library.
    library: listAt(file.library ?? [], "library", MOST, entryOf),
  };
}

function progressAt(data: unknown): Progress {
  try {
    return progressOfData(data);
  } catch (error) {
    if (error instanceof DamagedProgress) throw new KeptFault(`progress.${error.place}`);
    throw error;
  }
}

/**
 * Adds what is not there yet. Nothing is overwritten: another entry with the same id gets a new one.
 *
 * @returns How many works, games, results and entries of the library are new; null if the browser did not store all of them.
 */
export async function addBackup(kept: Kept, backup: Backup): Promise<number | null> {
  const { storage } = kept.works;
  let count = 0;
  let isStored = true;
  for (const [table, entries] of [
    ["works", backup.works],
    ["games", backup.games],
    ["library", backup.library],
  ] as const) {
    for (const entry of entries as readonly Entries[typeof table][]) {
      const added = await missing(storage, table, entry);
      if (added === null) continue;
      isStored = (await storage.put(table, added)) && isStored;
      count += 1;
    }
  }
  const before = sizeOf(kept.progress.progress);
  isStored = (await kept.progress.add(backup.progress)) && isStored;
  kept.games.changed();
  kept.library.changed();
  return isStored ? count + sizeOf(kept.progress.progress) - before : null;
}

/** The entry under an id that is free; null if it is there already, also under the id of an earlier copy. */
async function missing<E extends Entries[Exclude<Table, "progress">]>(
  storage: KeptStorage,
  table: Table,
  entry: E,
): Promise<E | null> {
  const time = "changed" in entry ? entry.changed : entry.ended;
  for (const id of [entry.id, `${entry.id.split("@")[0]!}@${time}`]) {
    const there = await storage.get(table, id);
    const copy = { ...entry, id };
    if (there === undefined) return copy;
    if (isEqual(there, copy)) return null;
  }
  return { ...entry, id: freshId() };
}

function sizeOf({ results, puzzles, attempts, drills }: Progress): number {
  return results.length + puzzles.length + attempts.length + drills.length;
}
