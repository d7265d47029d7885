import { expect, test } from "vitest";
import { pocketAt, railAt } from "../../../src/viewer/pointing.ts";
import { LOUPE, loupePlace } from "../../../src/viewer/render/stage.ts";
import { RAILED, UNBOUNDED } from "./tables.ts";

const table = RAILED.find(({ name }) => name === "wpa-9ft")!;
/** A screen with 300 pixels per metre. */
const project = (x: number, y: number) => [300 * x, 300 * y] as const;

test("a pocket is found at its centre and 20 pixels beside its edge, and not 30 pixels beside it", () => {
  for (const { name, center, radius } of table.pockets) {
    const [x, y] = project(...center);
    expect(pocketAt([x, y], table, project)).toBe(name);
    expect(pocketAt([x + 300 * radius + 20, y], table, project)).toBe(name);
    expect(pocketAt([x + 300 * radius + 30, y], table, project)).toBe(null);
  }
});

test("each rail is found on its cushion and its wood", () => {
  for (const depth of [0.02, 0.1]) {
    expect(railAt([0.6, -depth], table)).toBe("bottom");
    expect(railAt([1.27 + depth, 0.6], table)).toBe("right-lower");
    expect(railAt([1.27 + depth, 1.9], table)).toBe("right-upper");
  }
  expect(railAt([0.6, 1], table)).toBe(null);
  expect(railAt([0.6, -0.3], table)).toBe(null);
  expect(railAt([5, 5], UNBOUNDED)).toBe(null);
});

test("the loupe is above the finger, beside it at the upper edge, and inside the canvas", () => {
  const size = [390, 700] as const;
  expect(loupePlace([200, 500], size)[1]).toBeLessThan(500 - LOUPE / 2);
  for (const point of [
    [5, 5],
    [385, 20],
    [385, 690],
    [5, 690],
  ] as const) {
    const [x, y] = loupePlace(point, size);
    expect(x).toBeGreaterThanOrEqual(LOUPE / 2);
    expect(x).toBeLessThanOrEqual(size[0] - LOUPE / 2);
    expect(y).toBeGreaterThanOrEqual(LOUPE / 2);
    // The finger does not cover the disc's centre.
    expect(Math.hypot(x - point[0], y - point[1])).toBeGreaterThan(LOUPE / 2);
  }
});
