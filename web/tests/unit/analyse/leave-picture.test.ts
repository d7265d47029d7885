import { expect, test } from "vitest";
import { ellipseOf } from "../../../src/app/analyse/leave-picture.ts";
import { pot } from "./recommendation.ts";

test("two thirds of a Gaussian leave are within the ellipse", () => {
  // Axes of 30 and 10 cm, turned by 30°.
  const [long, short, turn] = [0.3 ** 2, 0.1 ** 2, Math.PI / 6];
  const [c, s] = [Math.cos(turn), Math.sin(turn)];
  const [xx, yy, xy] = [
    long * c * c + short * s * s,
    long * s * s + short * c * c,
    (long - short) * c * s,
  ];
  const leave = {
    count: 400,
    mean: [0.6, 1.2] as const,
    covariance: [
      [xx, xy],
      [xy, yy],
    ] as const,
    spread: Math.sqrt(xx + yy),
  };
  const determinant = xx * yy - xy * xy;
  for (const [x, y] of ellipseOf(pot({ more: { leave } }))!) {
    const [u, v] = [x - 0.6, y - 1.2];
    const squared = (yy * u * u - 2 * xy * u * v + xx * v * v) / determinant;
    expect(1 - Math.exp(-squared / 2)).toBeCloseTo(2 / 3, 9);
  }
});

test("a leave without enough samples has no ellipse", () => {
  const leave = {
    count: 0,
    mean: [null, null],
    covariance: [
      [null, null],
      [null, null],
    ],
    spread: null,
  } as const;
  expect(ellipseOf(pot({ more: { leave } }))).toBeNull();
});
