import { describe, expect, test } from "vitest";
import { load } from "../../../src/engine/index.ts";
import { judge } from "../../../src/app/train/drill-judge.ts";
import { layoutOf } from "../../../src/app/train/drill-layout.ts";
import { clothOf } from "../../../src/app/train/drill-places.ts";
import { puzzleOf } from "../../../src/app/train/puzzle/daily-puzzle.ts";
import { randomOf } from "../../../src/app/train/puzzle/seeded-random.ts";
import stored from "./puzzles.json";

const engine = await load();
const DATES = Object.keys(stored);

test("the random numbers of a seed are the published ones of mulberry32", () => {
  const random = randomOf(1);
  expect([random(), random(), random()].map((number) => number * 2 ** 32)).toEqual([
    2693262067, 11749833, 2265367787,
  ]);
});

describe.each(DATES)("the puzzle of %s", (date) => {
  const puzzle = puzzleOf(engine, date);

  test("is the stored one, to the bit", () => {
    expect(JSON.parse(JSON.stringify(puzzle))).toEqual(stored[date as keyof typeof stored]);
  });

  test("is solved by its strike, and by strikes near it", () => {
    const step = puzzle.drill.steps[0]!;
    const cloth = clothOf(engine, puzzle.drill.table);
    const shot = engine.shot(layoutOf(engine, { drill: puzzle.drill, step, attempt: 0 }));
    const solves = (change: object) => {
      const trace = shot.withStrike({ ...puzzle.solution, ...change }).simulate();
      return judge(cloth, puzzle.drill, step, trace).fault === null;
    };
    expect(solves({})).toBe(true);
    const { azimuth, speed } = puzzle.solution;
    for (const sign of [-1, 1]) {
      expect(solves({ azimuth: azimuth + sign * 0.0012 })).toBe(true);
      expect(solves({ speed: speed * (1 + sign * 0.03) })).toBe(true);
    }
    // It is not solved by any strike.
    expect(solves({ azimuth: azimuth + 0.5 })).toBe(false);
  });
});

test("the stored days have every kind of puzzle", () => {
  expect(new Set(DATES.map((date) => puzzleOf(engine, date).kind)).size).toBe(3);
});
