/** The scale of the power bar. */

import { describe, expect, test } from "vitest";
import { positionOf, powerWord, speedAt } from "../../../src/app/aim/power-bar.ts";

describe("the power bar", () => {
  test("has its softest and its hardest speed at its ends", () => {
    expect(speedAt(0)).toBe(0.3);
    expect(speedAt(370)).toBe(12);
  });

  test("has equal ratios for equal steps", () => {
    for (const position of [0, 100, 200, 300]) {
      expect(speedAt(position + 70) / speedAt(position)).toBeCloseTo(2.009, 2);
    }
  });

  test("shows each of its speeds at the position that gave it", () => {
    for (let position = 0; position <= 370; position += 1) {
      expect(positionOf(speedAt(position))).toBe(position);
    }
  });

  test("shows a speed beyond its ends at the end", () => {
    expect(positionOf(0.01)).toBe(0);
    expect(positionOf(40)).toBe(370);
  });

  test("names speeds from soft to break", () => {
    expect([0.5, 1.5, 3, 6, 9].map(powerWord)).toEqual([
      "power.soft",
      "power.lag",
      "power.firm",
      "power.hard",
      "power.break",
    ]);
  });
});
