import { expect, test } from "vitest";
import { assign, total } from "../../../src/photo/picture/assign.ts";
import { generator } from "../../photo/random.ts";

/** The least sum over all assignments, by trying them. */
function least(costs: readonly (readonly number[])[], used: readonly number[] = []): number {
  const row = costs[used.length];
  if (!row) return 0;
  return Math.min(
    ...row.map((cost, k) => (used.includes(k) ? Infinity : cost + least(costs, [...used, k]))),
  );
}

test("names differ, and the sum is near the least one", () => {
  const random = generator(3);
  for (let k = 0; k < 50; k += 1) {
    const costs = Array.from({ length: 5 }, () =>
      Array.from({ length: 6 }, () => random.uniform(0, 1)),
    );
    const chosen = assign(costs);
    expect(new Set(chosen).size).toBe(5);
    expect(total(costs, chosen)).toBeLessThanOrEqual(1.3 * least(costs) + 0.1);
  }
});

test("a row gives its favourite to the row that needs it more", () => {
  expect(
    assign([
      [0, 1],
      [0, 5],
    ]),
  ).toEqual([1, 0]);
});
