import { expect, test } from "vitest";
import { bin, colors, type Density, smooth } from "../../../src/viewer/overlay/density.ts";

const total = ({ values }: Density): number => values.reduce((a, b) => a + b, 0);

test("a point is counted in its bin", () => {
  const density = bin([0.25, 0.75], [0, 0], [1, 1]);
  const at = density.values.indexOf(1);
  const [column, row] = [at % density.columns, Math.floor(at / density.columns)];
  expect((column + 0.5) / density.columns).toBeCloseTo(0.25, 1);
  expect((row + 0.5) / density.rows).toBeCloseTo(0.75, 1);
});

test("points outside the grid, and NaN, are left out", () => {
  const points = [-0.1, 0.5, 1.1, 0.5, 0.5, -0.1, 0.5, 1.1, NaN, NaN, 0.5, 0.5];
  expect(total(bin(points, [0, 0], [1, 1]))).toBe(1);
});

test("smoothing keeps the sum, also at the edge of the cloth", () => {
  const density = bin([0.001, 0.001, 0.5, 0.5, 0.999, 0.3], [0, 0], [1, 1]);
  expect(total(smooth(density))).toBeCloseTo(3, 4);
});

test("smoothing keeps the peak at the point and is symmetric", () => {
  const { values, columns } = smooth(bin([0.51, 0.51], [0, 0], [1, 1]));
  const peak = values.indexOf(Math.max(...values));
  expect(bin([0.51, 0.51], [0, 0], [1, 1]).values[peak]).toBe(1);
  expect(values[peak + 1]).toBeCloseTo(values[peak + columns]!, 6);
});

test("larger values have lighter colours", () => {
  const values = Float32Array.from({ length: 200 }, (_, i) => (i + 1) / 200);
  const bytes = colors({ columns: 200, rows: 1, values });
  const light = Array.from(values, (_, i) => {
    const [r, g, b] = [0, 1, 2].map((k) => (bytes[4 * i + k]! / 255) ** 2.2);
    return 0.2126 * r! + 0.7152 * g! + 0.0722 * b!;
  });
  for (let i = 20; i < 200; i += 20) expect(light[i]).toBeGreaterThan(light[i - 20]!);
});

test("bins without points are transparent", () => {
  expect(colors({ columns: 2, rows: 1, values: new Float32Array([0, 0]) })).toEqual(
    new Uint8Array(8),
  );
  const bytes = colors({ columns: 2, rows: 1, values: new Float32Array([0, 5]) });
  expect(bytes[3]).toBe(0);
  expect(bytes[7]).toBeGreaterThan(200);
});
