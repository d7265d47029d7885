/** The browser's database of works and games, and the file with everything. */

import "fake-indexeddb/auto";
import { IDBFactory, IDBObjectStore } from "fake-indexeddb";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import {
  addBackup,
  type Backup,
  backupOf,
  backupText,
  isBackupText,
  type Kept,
} from "../../../src/app/kept/backup.ts";
import { KeptFault } from "../../../src/app/kept/kept-fault.ts";
import { KeptStorage, MOST_WORKS } from "../../../src/app/kept/kept-storage.ts";
import { type KeptWork, packed } from "../../../src/app/kept/kept-work.ts";
import { Library } from "../../../src/app/kept/library.ts";
import { ENTRY_FORMAT, type LibraryEntry } from "../../../src/app/kept/library-entry.ts";
import { type FinishedGame, GAME_FORMAT } from "../../../src/app/kept/finished-game.ts";
import { Keeper } from "../../../src/app/train/progress/progress-keeper.ts";
import SCHEMA from "../../../schemas/carom-backup-1.json";
import { begun } from "../game/games.ts";

beforeEach(() => {
  vi.stubGlobal("indexedDB", new IDBFactory());
});
afterEach(() => {
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

const ENGINE = "carom 0.0.1";

const GAME = begun("nine-ball").document.game!;

const day = (k: number) => new Date(Date.UTC(2026, 10, k)).toISOString();

function work(id: string, changed: string, kind: KeptWork["kind"] = "game"): KeptWork {
  const { steps } = begun("nine-ball");
  return packed({ id, kind, changed, over: false, steps, practice: null }, () => "g");
}

function game(id: string, ended: string): FinishedGame {
  return { format: GAME_FORMAT, id, ended, game: GAME, winner: 1, scores: [0, 1] };
}

function entry(id: string, changed: string): LibraryEntry {
  return {
    format: ENTRY_FORMAT,
    id,
    name: "One",
    folder: "",
    changed,
    kind: "position",
    link: "#s=1.x",
  };
}

async function idsOf(storage: KeptStorage, kind: KeptWork["kind"] = "game"): Promise<string[]> {
  const ids: string[] = [];
  await storage.eachWork(kind, (data) => ids.push((data as KeptWork).id) > 0);
  return ids;
}

function keptOf(storage: KeptStorage): Kept {
  const games = { changed: vi.fn() };
  const library = new Library(storage);
  return {
    works: { storage },
    games,
    progress: new Keeper(storage, null),
    library,
  } as unknown as Kept;
}

test("works and games come back, the newest first, to another page too", async () => {
  const storage = new KeptStorage();
  for (const [id, k] of [
    ["b", 2],
    ["c", 3],
    ["a", 1],
  ] as const) {
    expect(await storage.put("works", work(id, day(k)))).toBe(true);
    expect(await storage.put("games", game(id, day(k)))).toBe(true);
  }
  await storage.put("works", work("x", day(9), "analysis"));
  const other = new KeptStorage();
  expect(await idsOf(other)).toEqual(["c", "b", "a"]);
  expect(await idsOf(other, "analysis")).toEqual(["x"]);
  const ended: string[] = [];
  await other.eachGame((data) => ended.push((data as FinishedGame).id) < 2);
  expect(ended).toEqual(["c", "b"]);
  expect(await other.get("works", "a")).toEqual(work("a", day(1)));
  await other.remove("works", "a");
  expect(await other.get("works", "a")).toBeUndefined();
});

test("the oldest works are dropped, except those that a tab holds", async () => {
  const storage = new KeptStorage();
  for (let k = 1; k <= MOST_WORKS + 3; k += 1) await storage.put("works", work(`w${k}`, day(k)));
  await storage.prune("game", new Set(["w2"]));
  const ids = await idsOf(storage);
  expect(ids).toHaveLength(MOST_WORKS + 1);
  expect(ids.at(-1)).toBe("w2");
  expect(ids).not.toContain("w1");
});

test("a browser without a database keeps nothing, and says why", async () => {
  vi.stubGlobal("indexedDB", undefined);
  const storage = new KeptStorage();
  expect(await storage.put("works", work("a", day(1)))).toBe(false);
  expect(storage.fault).toBe("refused");
  expect(await idsOf(storage)).toEqual([]);
});

test("the faults of a browser that refuses and of a full one differ, and a write that succeeds ends the fault", async () => {
  const failing = (name: string) => {
    const factory = new IDBFactory();
    factory.open = () => {
      throw new DOMException("no", name);
    };
    vi.stubGlobal("indexedDB", factory);
    return new KeptStorage();
  };
  for (const [name, fault] of [
    ["SecurityError", "refused"],
    // Some browsers say so in private windows.
    ["UnknownError", "refused"],
    ["QuotaExceededError", "full"],
  ] as const) {
    const storage = failing(name);
    await storage.get("works", "a");
    expect([name, storage.fault]).toEqual([name, fault]);
  }
  vi.stubGlobal("indexedDB", new IDBFactory());
  const storage = new KeptStorage();
  const told = vi.fn();
  storage.subscribe(told);
  await storage.get("works", "a");
  const spy = vi.spyOn(IDBObjectStore.prototype, "put").mockImplementation(() => {
    throw new DOMException("no room", "QuotaExceededError");
  });
  expect(await storage.put("games", game("a", day(1)))).toBe(false);
  expect(storage.fault).toBe("full");
  spy.mockRestore();
  expect(await storage.put("games", game("a", day(1)))).toBe(true);
  expect(storage.fault).toBeNull();
  expect(told).toHaveBeenCalledTimes(2);
});

test("everything goes into one file and back, once", async () => {
  const storage = new KeptStorage();
  await storage.put("works", work("a", day(1)));
  await storage.put("works", work("b", day(2), "analysis"));
  await storage.put("games", game("g", day(1)));
  await storage.put("library", entry("e", day(1)));
  const kept = keptOf(storage);
  kept.progress.addPuzzle({ date: "2026-11-28", tries: 2, solved: true });
  const text = await backupText(kept, ENGINE);
  expect(isBackupText(text)).toBe(true);
  const backup = backupOf(text);
  expect(await addBackup(kept, backup), "all of it is there").toBe(0);

  vi.stubGlobal("indexedDB", new IDBFactory());
  const other = keptOf(new KeptStorage());
  expect(await addBackup(other, backup)).toBe(5);
  expect(await addBackup(other, backup)).toBe(0);
  const again = JSON.parse(await backupText(other, ENGINE)) as Backup;
  expect((JSON.parse(text) as { engine: unknown }).engine).toBe(ENGINE);
  expect({ ...again, saved: "" }).toEqual({ ...(JSON.parse(text) as object), saved: "" });
});

test("a file overwrites nothing: what was changed since stays, and the old one is added", async () => {
  const storage = new KeptStorage();
  await storage.put("works", work("a", day(1)));
  const kept = keptOf(storage);
  const backup = backupOf(await backupText(kept, ENGINE));
  await storage.put("works", work("a", day(5)));
  expect(await addBackup(kept, backup)).toBe(1);
  expect(await addBackup(kept, backup), "not twice").toBe(0);
  expect(await idsOf(storage)).toEqual(["a", `a@${day(1)}`]);
  expect(await storage.get("works", "a")).toEqual(work("a", day(5)));
});

/** The keys of an object of the schema, those that may be missing apart. */
function keysIn(schema: { properties: object; required: string[] }) {
  const keys = Object.keys(schema.properties);
  return { always: schema.required, known: keys };
}

test("the schema has the keys of the file", async () => {
  const storage = new KeptStorage();
  await storage.put("works", work("a", day(1)));
  await storage.put("games", game("g", day(1)));
  await storage.put("library", entry("e", day(1)));
  const file = JSON.parse(await backupText(keptOf(storage), ENGINE)) as {
    library: [LibraryEntry];
    works: [KeptWork];
    games: [FinishedGame];
    progress: object;
  };
  const { $defs } = SCHEMA;
  const [kept, ended] = [file.works[0], file.games[0]];
  for (const [data, schema] of [
    [file, SCHEMA],
    [kept, $defs.work],
    [kept.steps[0]!, $defs.step],
    [kept.setups[0]!, $defs.work.properties.setups.items],
    [kept.games[0]!, $defs.work.properties.games.items],
    [ended, $defs.finished],
    [ended.game, $defs.finished.properties.game],
    [file.progress, $defs.progress],
    [file.library[0], $defs.entry],
  ] as const) {
    const { always, known } = keysIn(schema);
    expect(Object.keys(data)).toEqual(expect.arrayContaining([...always]));
    expect(known).toEqual(expect.arrayContaining(Object.keys(data)));
  }
});

test("a file of an older page, without a library, is read", async () => {
  const kept = keptOf(new KeptStorage());
  const old = JSON.parse(await backupText(kept, ENGINE)) as Record<string, unknown>;
  delete old.library;
  delete old.engine;
  expect(backupOf(JSON.stringify(old)).library).toEqual([]);
});

test("a database of an older page gets a library, and keeps what it has", async () => {
  const { openDB } = await import("idb");
  const old = await openDB("carom", 1, {
    upgrade: (base) => {
      base.createObjectStore("works", { keyPath: "id" }).createIndex("order", ["kind", "changed"]);
      base.createObjectStore("games", { keyPath: "id" }).createIndex("ended", "ended");
    },
  });
  await old.put("works", work("a", day(1)));
  old.close();
  const storage = new KeptStorage();
  expect(await idsOf(storage)).toEqual(["a"]);
  expect(await storage.put("library", entry("e", day(1)))).toBe(true);
  expect(await storage.all("library")).toEqual([entry("e", day(1))]);
});

test("a change in the library never overwrites that of another tab", async () => {
  const [one, other] = [new Library(new KeptStorage()), new Library(new KeptStorage())];
  const added = await one.add({ kind: "position", name: "A", folder: "", link: "#s=1.x" });
  const first = await one.change({ ...added!, name: "B" });
  expect(first?.id).toBe(added?.id);
  const second = await other.change({ ...added!, name: "C" });
  expect(second?.id).not.toBe(added?.id);
  const { entries, damaged } = await one.list();
  expect(entries.map(({ name }) => name)).toEqual(["B", "C"]);
  expect(damaged).toEqual([]);
  await one.remove(second!.id);
  await one.restore(second!);
  expect((await other.list()).entries).toHaveLength(2);
});

test("damaged entries of the library are listed apart from the others", async () => {
  const storage = new KeptStorage();
  await storage.put("library", entry("e", day(1)));
  for (const [id, change] of [
    ["x", { kind: "film" }],
    ["y", { link: 3 }],
    ["z", { changed: "yesterday" }],
  ] as const) {
    await storage.put("library", { ...entry(id, day(1)), ...change } as unknown as LibraryEntry);
  }
  const { entries, damaged } = await new Library(storage).list();
  expect(entries.map(({ id }) => id)).toEqual(["e"]);
  expect(damaged).toHaveLength(3);
});

test("a damaged file is refused as a whole, with the place", async () => {
  const storage = new KeptStorage();
  await storage.put("games", game("g", day(1)));
  const text = await backupText(keptOf(storage), ENGINE);
  const data = JSON.parse(text) as Record<string, unknown>;
  for (const [change, place] of [
    [{ works: [{}] }, "works[0].format"],
    [{ games: [5] }, "games[0]"],
    [{ progress: { format: "carom-progress/1", results: 1, puzzles: [] } }, "progress.results"],
    [{ saved: 5 }, "saved"],
    [{ more: [] }, "file.more"],
    [{ format: "carom-backup/2" }, ""],
  ] as const) {
    const read = () => backupOf(JSON.stringify({ ...data, ...change }));
    expect(read).toThrow(KeptFault);
    expect(read).toThrow(expect.objectContaining({ place }));
  }
  expect(() => backupOf("{oops")).toThrow(KeptFault);
  expect(isBackupText('{"format": "carom-shot/1"}')).toBe(false);
});
