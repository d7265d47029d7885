import { describe, expect, test } from "vitest";
import { type Box, Keeper } from "../../../src/app/train/progress/progress-keeper.ts";
import {
  bestOf,
  DamagedProgress,
  dayOf,
  merged,
  NOTHING,
  type Progress,
  progressOfText,
  progressToText,
  type Result,
  streakOf,
} from "../../../src/app/train/progress/practice-progress.ts";

const result = (day: number, points: readonly number[], drill = "stop"): Result => ({
  drill,
  ended: `2026-11-${String(day).padStart(2, "0")}T10:00:00.000Z`,
  place: "table",
  points,
  errors: null,
});
const solved = (date: string, tries = 1) => ({ date, tries, solved: true });
const SOME: Progress = {
  results: [result(3, [1, 0, 2]), result(5, [1, 2, 3])],
  puzzles: [solved("2026-11-03", 2), { date: "2026-11-04", tries: 3, solved: false }],
};

describe("a progress file", () => {
  test("has everything that was in the progress", () => {
    expect(progressOfText(progressToText(SOME))).toEqual(SOME);
    expect(JSON.parse(progressToText(NOTHING))).toEqual({
      format: "carom-progress/1",
      results: [],
      puzzles: [],
    });
  });

  const text = (change: (file: Record<string, unknown[]>) => void) => {
    const file = JSON.parse(progressToText(SOME)) as Record<string, unknown[]>;
    change(file);
    return JSON.stringify(file);
  };
  const set = (list: string, k: number, change: object) =>
    text((file) => {
      file[list]![k] = { ...(file[list]![k] as object), ...change };
    });

  test.each([
    ["{", "json", ""],
    ["null", "format", ""],
    ['{"format": "carom-shot/1"}', "format", ""],
    [progressToText(SOME).slice(0, -20), "json", ""],
    [text((file) => delete file.puzzles), "value", "puzzles"],
    [text((file) => (file.results![1] = 7)), "value", "results[1]"],
    [set("results", 1, { points: [1, -1] }), "value", "results[1].points"],
    [set("results", 1, { points: [] }), "value", "results[1].points"],
    [set("results", 0, { points: [0.5] }), "value", "results[0].points"],
    [set("results", 0, { ended: "yesterday" }), "value", "results[0].ended"],
    [set("results", 0, { ended: "2026-13-01T00:00:00.000Z" }), "value", "results[0].ended"],
    [set("results", 0, { place: "moon" }), "value", "results[0].place"],
    [set("results", 0, { drill: "" }), "value", "results[0].drill"],
    [set("results", 0, { errors: 3 }), "value", "results[0].errors"],
    [set("puzzles", 1, { date: "2026-02-30" }), "value", "puzzles[1].date"],
    [set("puzzles", 1, { tries: "3" }), "value", "puzzles[1].tries"],
    [set("puzzles", 1, { solved: 1 }), "value", "puzzles[1].solved"],
  ])("that is damaged is refused with the place: %#", (damaged, fault, place) => {
    let error: unknown;
    try {
      progressOfText(damaged);
    } catch (caught) {
      error = caught;
    }
    expect(error).toBeInstanceOf(DamagedProgress);
    expect(error).toMatchObject({ fault, place });
  });

  test("of a drill that this version does not have is kept", () => {
    const other = { results: [result(1, [4], "of-tomorrow")], puzzles: [] };
    expect(progressOfText(progressToText(other))).toEqual(other);
  });
});

describe("two progresses", () => {
  test("are merged without duplicates, in the order of time", () => {
    const other = { results: [result(4, [2]), SOME.results[0]!], puzzles: [] };
    const all = merged(SOME, other);
    expect(all.results.map(({ ended }) => Number(ended.slice(8, 10)))).toEqual([3, 4, 5]);
    expect(merged(all, SOME)).toEqual(all);
    expect(merged(SOME, all)).toEqual(all);
  });

  test("keep the better puzzle of a day, in either order", () => {
    const day = "2026-11-04";
    const open = { date: day, tries: 9, solved: false };
    const cases = [
      [open, solved(day, 12), solved(day, 12)],
      [solved(day, 12), solved(day, 4), solved(day, 4)],
      [open, { ...open, tries: 2 }, open],
    ] as const;
    for (const [a, b, best] of cases) {
      const of = (one: typeof a) => ({ results: [], puzzles: [one] });
      expect(merged(of(a), of(b)).puzzles).toEqual([best]);
      expect(merged(of(b), of(a)).puzzles).toEqual([best]);
    }
  });
});

test("the best score is the largest sum of points", () => {
  expect(bestOf(SOME, "stop")).toBe(6);
  expect(bestOf(SOME, "draw")).toBeNull();
});

test("a streak counts solved days in a row, and is not lost before the day is over", () => {
  const days = ["2026-02-27", "2026-02-28", "2026-03-01", "2026-03-03"];
  const of = { results: [], puzzles: days.map((date) => solved(date)) };
  expect(streakOf(of, "2026-03-01")).toBe(3);
  expect(streakOf(of, "2026-03-02")).toBe(3);
  expect(streakOf(of, "2026-03-03")).toBe(1);
  expect(streakOf(of, "2026-03-05")).toBe(0);
  expect(streakOf(NOTHING, "2026-03-05")).toBe(0);
});

test("a day is that of universal time", () => {
  expect(dayOf(new Date("2026-11-23T23:59:59-05:00"))).toBe("2026-11-24");
});

/** A storage in memory. */
function box(first: Record<string, string> = {}): Box & { readonly texts: Map<string, string> } {
  const texts = new Map(Object.entries(first));
  return {
    texts,
    getItem: (key) => texts.get(key) ?? null,
    setItem: (key, value) => void texts.set(key, value),
    removeItem: (key) => void texts.delete(key),
  };
}

describe("the progress in the browser", () => {
  test("is there again when the page is opened again", () => {
    const storage = box();
    new Keeper(storage).add(SOME);
    const again = new Keeper(storage);
    expect(again.progress).toEqual(SOME);
    expect([again.isKept, again.damaged]).toEqual([true, null]);
  });

  test("lasts as long as the page where there is no storage", () => {
    const broken: Box = {
      getItem: () => {
        throw new Error("denied");
      },
      setItem: () => undefined,
      removeItem: () => undefined,
    };
    for (const storage of [null, broken]) {
      const keeper = new Keeper(storage);
      keeper.addResult(result(3, [1]));
      keeper.addPuzzle(solved("2026-11-03"));
      expect(keeper.isKept).toBe(false);
      expect(keeper.progress.results).toHaveLength(1);
      expect(keeper.progress.puzzles).toHaveLength(1);
    }
  });

  test("is not overwritten when the storage is full, and the page can warn of it", () => {
    const storage = box();
    new Keeper(storage).add(SOME);
    const before = storage.texts.get("carom-progress");
    const keeper = new Keeper({
      ...storage,
      setItem: () => {
        throw new Error("full");
      },
    });
    keeper.addResult(result(9, [1]));
    expect(keeper.isKept).toBe(false);
    expect(keeper.progress.results).toHaveLength(3);
    expect(storage.texts.get("carom-progress")).toBe(before);
  });

  test("is set aside if it is damaged, each time under another name", () => {
    const storage = box({ "carom-progress": "{", "carom-progress-damaged-1": "older" });
    const keeper = new Keeper(storage);
    expect(keeper.damaged).toBe("{");
    keeper.addResult(result(3, [1]));
    expect(storage.texts.get("carom-progress-damaged-1")).toBe("older");
    expect(storage.texts.get("carom-progress-damaged-2")).toBe("{");
    expect(new Keeper(storage).progress.results).toHaveLength(1);
  });

  test("has the results of two tabs", () => {
    const storage = box();
    const [one, two] = [new Keeper(storage), new Keeper(storage)];
    one.addResult(result(3, [1]));
    two.addResult(result(4, [2]));
    one.refresh();
    expect(one.progress.results).toHaveLength(2);
    expect(new Keeper(storage).progress.results).toHaveLength(2);
  });

  test("is deleted in every tab, and does not come back with the next result", () => {
    const storage = box();
    const [one, two] = [new Keeper(storage), new Keeper(storage)];
    one.add(SOME);
    two.refresh();
    two.clear();
    expect([two.progress, storage.texts.has("carom-progress")]).toEqual([NOTHING, false]);
    one.refresh();
    expect(one.progress).toEqual(NOTHING);
    two.add(SOME);
    two.clear();
    one.addResult(result(4, [2]));
    expect(new Keeper(storage).progress.results).toEqual([result(4, [2])]);
  });

  test("is deleted where there is no storage", () => {
    const keeper = new Keeper(null);
    keeper.add(SOME);
    keeper.clear();
    expect(keeper.progress).toEqual(NOTHING);
  });
});
