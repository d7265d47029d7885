import { describe, expect, test } from "vitest";
import {
  bestOf,
  DamagedProgress,
  dayOf,
  merged,
  NOTHING,
  progressOfText,
  progressToText,
  streakOf,
} from "../../../src/app/train/progress/practice-progress.ts";
import { drill, ENGINE, result, solved, SOME } from "./some-progress.ts";

describe("a progress file", () => {
  test("has everything that was in the progress", () => {
    expect(progressOfText(progressToText(SOME, ENGINE))).toEqual(SOME);
    expect(JSON.parse(progressToText(NOTHING, ENGINE))).toEqual({
      format: "carom-progress/1",
      engine: ENGINE,
      results: [],
      puzzles: [],
      attempts: [],
      drills: [],
    });
  });

  test("of an earlier version, without attempts and drills, is read", () => {
    const earlier = '{"format":"carom-progress/1","results":[],"puzzles":[]}';
    expect(progressOfText(earlier)).toEqual(NOTHING);
  });

  const text = (change: (file: Record<string, unknown[]>) => void) => {
    const file = JSON.parse(progressToText(SOME, ENGINE)) as Record<string, unknown[]>;
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
    [progressToText(SOME, ENGINE).slice(0, -20), "json", ""],
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
    [set("attempts", 0, { puzzle: 17 }), "value", "attempts[0].puzzle"],
    [set("attempts", 0, { time: "now" }), "value", "attempts[0].time"],
    [set("attempts", 0, { made: 1 }), "value", "attempts[0].made"],
    [set("attempts", 0, { rating: -1 }), "value", "attempts[0].rating"],
    [set("drills", 0, { format: "carom-shot/1" }), "value", "drills[0].format"],
    [set("drills", 0, { name: "" }), "value", "drills[0].name"],
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
    const other = { ...NOTHING, results: [result(1, [4], "of-tomorrow")] };
    expect(progressOfText(progressToText(other, ENGINE))).toEqual(other);
  });
});

describe("two progresses", () => {
  test("are merged without duplicates, in the order of time", () => {
    const other = { ...NOTHING, results: [result(4, [2]), SOME.results[0]!] };
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
      const of = (one: typeof a) => ({ ...NOTHING, puzzles: [one] });
      expect(merged(of(a), of(b)).puzzles).toEqual([best]);
      expect(merged(of(b), of(a)).puzzles).toEqual([best]);
    }
  });
});

test("drills of one name stay beside each other, and the same drill is there once", () => {
  const one = { ...NOTHING, drills: [drill("A")] };
  expect(merged(one, one).drills).toEqual([drill("A")]);
  const both = merged(one, { ...NOTHING, drills: [drill("A", 5)] });
  expect(both.drills).toEqual([drill("A"), drill("A (2)", 5)]);
  expect(merged(both, one)).toEqual(both);
  expect(merged(both, { ...NOTHING, drills: [drill("A", 5)] })).toEqual(both);
});

test("the best score is the largest sum of points", () => {
  expect(bestOf(SOME, "stop")).toBe(6);
  expect(bestOf(SOME, "draw")).toBeNull();
});

test("a streak counts solved days in a row, and is not lost before the day is over", () => {
  const days = ["2026-02-27", "2026-02-28", "2026-03-01", "2026-03-03"];
  const of = { ...NOTHING, puzzles: days.map((date) => solved(date)) };
  expect(streakOf(of, "2026-03-01")).toBe(3);
  expect(streakOf(of, "2026-03-02")).toBe(3);
  expect(streakOf(of, "2026-03-03")).toBe(1);
  expect(streakOf(of, "2026-03-05")).toBe(0);
  expect(streakOf(NOTHING, "2026-03-05")).toBe(0);
});

test("a day is that of universal time", () => {
  expect(dayOf(new Date("2026-11-23T23:59:59-05:00"))).toBe("2026-11-24");
});
