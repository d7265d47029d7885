import { describe, expect, test } from "vitest";
import { curve, roundUp, xOf, yOf } from "../../../src/app/replay/plot-curves.ts";

describe("a plot", () => {
  const area = { width: 200, height: 50, duration: 4, low: -1, high: 1 };

  test("puts times from left to right and values from bottom to top", () => {
    expect([0, 1, 4].map((t) => xOf(area, t))).toStrictEqual([0, 50, 200]);
    expect([-1, 0, 1].map((v) => yOf(area, v))).toStrictEqual([50, 25, 0]);
  });

  test("draws a line through all samples", () => {
    expect(curve(area, [0, 2, 4], [-1, 0.5, 1])).toBe("M0.0 50.0L100.0 12.5L200.0 0.0");
    expect(curve(area, [], [])).toBe("");
  });

  test("of a shot without motion stays finite", () => {
    const still = { ...area, duration: 0, low: 0, high: 0 };
    expect(curve(still, [0], [0])).toBe("M0.0 50.0");
  });

  test("has an axis that ends at a round number above all values", () => {
    expect([0.013, 1, 1.01, 3.3, 7, 480].map(roundUp)).toStrictEqual([0.015, 1, 1.5, 4, 8, 500]);
    expect(roundUp(0)).toBe(1);
    expect(String(roundUp(0.55))).toBe("0.6");
  });
});
