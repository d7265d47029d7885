import { describe, expect, test } from "vitest";
import { type Drill, drillOf } from "../../../src/app/train/drills/index.ts";
import {
  counted,
  distribution,
  greatest,
  mean,
  stepAfter,
} from "../../../src/app/train/drill-score.ts";

const step = drillOf("spot")!.steps[0]!;
const ladder: Drill = {
  ...drillOf("spot")!,
  order: "ladder",
  attempts: 3,
  steps: [step, step, step],
};

describe("a ladder", () => {
  test("goes up after success, down after a failure, and not beyond its ends", () => {
    expect(stepAfter(ladder, [])).toBe(0);
    expect(stepAfter(ladder, [1])).toBe(1);
    expect(stepAfter(ladder, [1, 2, 3, 3])).toBe(2);
    expect(stepAfter(ladder, [1, 2, 0])).toBe(1);
    expect(stepAfter(ladder, [0, 0])).toBe(0);
  });

  test("counts the number of the step", () => {
    expect([counted(ladder, 2, 1), counted(ladder, 2, 0)]).toEqual([3, 0]);
    expect(greatest(ladder)).toBe(1 + 2 + 3);
  });

  test("has the distribution of all its courses", () => {
    const chances = [0.5, 0.4, 0.25].map((made) => [1 - made, made]);
    const shares = distribution(ladder, chances);
    // Every course of three attempts, one by one.
    const expected = Array.from({ length: 7 }, () => 0);
    for (let course = 0; course < 8; course += 1) {
      const points: number[] = [];
      let chance = 1;
      for (let k = 0; k < 3; k += 1) {
        const at = stepAfter(ladder, points);
        const made = (course >> k) & 1;
        chance *= chances[at]![made]!;
        points.push(made ? at + 1 : 0);
      }
      expected[points.reduce((sum, one) => sum + one, 0)]! += chance;
    }
    shares.forEach((share, score) => expect(share).toBeCloseTo(expected[score]!, 12));
    expect(mean(shares)).toBeCloseTo(
      expected.reduce((sum, chance, score) => sum + chance * score, 0),
      12,
    );
  });
});

test("makes of ten are distributed binomially", () => {
  const shares = distribution(drillOf("spot")!, [[0.7, 0.3]]);
  expect(shares).toHaveLength(11);
  expect(shares[0]).toBeCloseTo(0.7 ** 10, 12);
  expect(mean(shares)).toBeCloseTo(3, 12);
});

test("a drill in turns takes one step after another", () => {
  const wheel = drillOf("wheel")!;
  expect([0, 1, 5, 9].map((done) => stepAfter(wheel, Array<number>(done).fill(0)))).toEqual([
    0, 1, 0, 4,
  ]);
  const certain = distribution(wheel, [
    [0, 1],
    [0, 1],
    [1, 0],
    [0, 1],
    [0, 1],
  ]);
  expect(certain[8]).toBe(1);
});

test("the greatest score of zones and of runs is that of the best attempt, each time", () => {
  expect(["stun", "ghost", "colours"].map((id) => greatest(drillOf(id)!))).toEqual([30, 15, 18]);
});
