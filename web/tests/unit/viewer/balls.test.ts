import { expect, test } from "vitest";
import { calm } from "../../../src/viewer/balls/drawn-balls.ts";
import { rounded } from "../../../src/viewer/table/table-outline.ts";
import type { Point } from "../../../src/viewer/viewer-types.ts";

test("numbers of resting balls face the viewer, those of fast balls turn with the ball", () => {
  expect(calm(0)).toBe(1);
  expect(calm(1)).toBe(0);
  expect(calm(0.06)).toBeGreaterThan(calm(0.08));
});

test("a rounded corner touches both sides and has the radius", () => {
  const corner: Point[] = [
    [0, 1],
    [0, 0],
    [1, 0],
  ];
  const line = rounded(corner, 0.1);
  expect([line[0], line.at(-1)]).toEqual([corner[0], corner[2]]);
  for (const [x, y] of line.slice(1, -1)) expect(Math.hypot(x - 0.1, y - 0.1)).toBeCloseTo(0.1, 9);
  expect(line.length).toBeGreaterThan(6);
});

test("a straight line and the ends of a line are not rounded", () => {
  const line: Point[] = [
    [0, 0],
    [1, 0],
    [2, 0],
  ];
  expect(rounded(line, 0.1)).toEqual([line[0], line[2]]);
});
