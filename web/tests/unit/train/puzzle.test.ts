import { describe, expect, test } from "vitest";
import { type BallEntry, load } from "../../../src/engine/index.ts";
import { judge } from "../../../src/app/train/drill-judge.ts";
import { layoutOf } from "../../../src/app/train/drill-layout.ts";
import { clothOf } from "../../../src/app/train/drill-places.ts";
import {
  firstAttempts,
  NEW_PLAYER,
  rated,
  ratingOf,
  solvedInARow,
} from "../../../src/app/train/puzzle/player-rating.ts";
import { nextPuzzle, puzzleOfDay, themeOf } from "../../../src/app/train/puzzle/puzzle-choice.ts";
import { HINTS, hintTexts, lineMarks } from "../../../src/app/train/puzzle/puzzle-hints.ts";
import { taskOf } from "../../../src/app/train/puzzle/puzzle-task.ts";
import { randomOf } from "../../../src/app/train/puzzle/seeded-random.ts";
import stored from "../../../../benches/results/puzzles.json";

const engine = await load();
const THEMES = Object.keys(stored.themes) as (keyof typeof stored.themes)[];

test("the random numbers of a seed are the published ones of mulberry32", () => {
  const random = randomOf(1);
  expect([random(), random(), random()].map((number) => number * 2 ** 32)).toEqual([
    2693262067, 11749833, 2265367787,
  ]);
});

test("there are 2000 puzzles or more, of fifteen themes", () => {
  expect(engine.puzzles.length).toBeGreaterThanOrEqual(2000);
  expect(new Set(engine.puzzles.map(([id]) => themeOf(id))).size).toBe(15);
  expect(new Set(engine.puzzles.map(([id]) => id)).size).toBe(engine.puzzles.length);
});

describe.each(THEMES)("a puzzle of the theme %s", (theme) => {
  const [number, rating, ...chances] = stored.themes[theme].puzzles[0]!;
  const puzzle = engine.puzzle(`${theme}-${number}`);
  const task = taskOf(engine, puzzle, null);
  const step = task.drill.steps[0]!;
  const set = layoutOf(engine, { drill: task.drill, step, attempt: 0 });

  test("is made again in WebAssembly with the stored rating and chances", () => {
    expect(puzzle.rating).toBeCloseTo(rating!, 4);
    expect(Object.values(puzzle.chances).map((one) => Math.round(1e4 * one) / 1e4)).toEqual(
      chances,
    );
    expect(engine.puzzles).toContainEqual([puzzle.id, 10 * Math.round(rating! / 10)]);
  });

  test("has the places of its balls to the bit as a drill too", () => {
    const byId = (balls: readonly BallEntry[]) => [...balls].sort((a, b) => (a.id < b.id ? -1 : 1));
    expect(byId(set.balls)).toEqual(byId(puzzle.shot.balls));
  });

  test("is solved by all its ways on the page's table, and not by a shot elsewhere", () => {
    const shot = engine.shot(puzzle.shot);
    const fault = (change: object) => {
      const trace = shot.withStrike({ ...puzzle.ways[0]!.strike, ...change }).simulate();
      return judge(clothOf(engine, task.drill.table), step, trace).fault;
    };
    for (const way of puzzle.ways) expect(fault(way.strike)).toBeNull();
    expect(fault({ speed: 0.05 })).not.toBeNull();
  });

  test("has a hint for the ball, the strike and the line", () => {
    const texts = hintTexts(engine, task, HINTS);
    expect(texts).toHaveLength(HINTS);
    for (const text of texts) expect(text).toMatch(/^[A-Z9].*\.$/);
    const marks = lineMarks(engine, task);
    expect(marks.length).toBeGreaterThan(0);
    // The engine accepts them.
    engine.shot({ ...set, marks }).free();
  });
});

describe("the rating", () => {
  test("follows Glickman's example with one opponent", () => {
    // Glickman (1999), his example: 1500 ± 200 beats 1400 ± 30. Alone: g = 0.9955, E = 0.639, r' = 1564, RD' = 175.
    const q = Math.LN10 / 400;
    const g = 1 / Math.sqrt(1 + (3 * (q * 60) ** 2) / Math.PI ** 2);
    const { rating, deviation } = rated({ rating: 1500, deviation: 200 }, 1400, true);
    const expected = 1 / (1 + 10 ** ((-g * 100) / 400));
    const variance = 1 / (1 / 200 ** 2 + (q * g) ** 2 * expected * (1 - expected));
    expect(rating).toBeCloseTo(1500 + q * variance * g * (1 - expected), 9);
    expect(deviation).toBeCloseTo(Math.sqrt(variance), 9);
    expect(rating).toBeGreaterThan(1555);
    expect(rating).toBeLessThan(1570);
  });

  const attempt = (puzzle: string, made: boolean, rating = 1500) => ({
    puzzle,
    time: "2026-11-28T10:00:00.000Z",
    made,
    rating,
  });

  test("rises with solved puzzles, falls with missed ones, and counts a puzzle once", () => {
    expect(ratingOf([])).toEqual(NEW_PLAYER);
    const up = ratingOf([attempt("a", true)]);
    expect(up.rating).toBeGreaterThan(1500);
    expect(up.deviation).toBeLessThan(350);
    expect(ratingOf([attempt("a", false)]).rating).toBeLessThan(1500);
    expect(ratingOf([attempt("a", true), attempt("a", false)])).toEqual(up);
    expect(firstAttempts([attempt("a", true), attempt("a", false)])).toHaveLength(1);
  });

  test("comes to the difficulty of which a player solves a half", () => {
    const half = Array.from({ length: 400 }, (_, k) => attempt(String(k), k % 2 === 0, 1800));
    expect(Math.abs(ratingOf(half).rating - 1800)).toBeLessThan(40);
  });

  test("has a row of puzzles solved at the first shot", () => {
    const list = [attempt("a", true), attempt("b", false), attempt("c", true), attempt("d", true)];
    expect(solvedInARow(list)).toBe(2);
    expect(solvedInARow(list.slice(0, 2))).toBe(0);
    expect(solvedInARow([])).toBe(0);
  });
});

describe("the choice of the next puzzle", () => {
  const list = engine.puzzles;
  const played = new Set<string>();
  const choose = (choice: Partial<Parameters<typeof nextPuzzle>[1]>, seed = 1) =>
    nextPuzzle(
      list,
      { theme: null, difficulty: "rating", rating: 1500, played, ...choice },
      randomOf(seed),
    );

  test("keeps to the theme, the difficulty and the player's rating", () => {
    for (let seed = 0; seed < 50; seed += 1) {
      expect(themeOf(choose({ theme: "three-cushion" }, seed)[0])).toBe("three-cushion");
      expect(Math.abs(choose({ rating: 1700 }, seed)[1] - 1700)).toBeLessThanOrEqual(150);
      expect(choose({ difficulty: "easy" }, seed)[1]).toBeLessThanOrEqual(1350);
      expect(choose({ difficulty: "hard" }, seed)[1]).toBeGreaterThanOrEqual(1750);
    }
  });

  test("gives a puzzle that was not played, as long as there is one", () => {
    const cuts = list.filter(([id]) => themeOf(id) === "cut").map(([id]) => id);
    const last = cuts.at(-1)!;
    const all = new Set(cuts.slice(0, -1));
    expect(choose({ theme: "cut", played: all })[0]).toBe(last);
    expect(cuts).toContain(choose({ theme: "cut", played: new Set(cuts) })[0]);
  });

  test("gives a day the same puzzle everywhere, and different days different ones", () => {
    expect(puzzleOfDay(list, "2026-11-28")).toEqual(puzzleOfDay(list, "2026-11-28"));
    const days = Array.from({ length: 28 }, (_, k) => `2026-11-${String(k + 1).padStart(2, "0")}`);
    expect(new Set(days.map((date) => puzzleOfDay(list, date)[0])).size).toBeGreaterThan(25);
  });
});
