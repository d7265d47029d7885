/** Density of points: bins on a grid, smoothed, and their colours. */

import type { Point } from "../viewer-types.ts";

/** Side of a bin, m: a third of a ball's diameter. */
const BIN = 0.02;
/** Standard deviation of the smoothing, bins. */
const SMOOTHING = 1.6;

/** Counts on a grid; `values[row * columns + column]`, rows along y, columns along x. */
export interface Density {
  columns: number;
  rows: number;
  values: Float32Array;
}

/**
 * Points per bin over a rectangle. Points outside it, and NaN, are left out.
 *
 * @param points - x, y (m) per point.
 * @param origin - Lower left corner, m.
 * @param size - Width and length, m.
 */
export function bin(points: ArrayLike<number>, origin: Point, size: Point): Density {
  const columns = Math.max(1, Math.ceil(size[0] / BIN));
  const rows = Math.max(1, Math.ceil(size[1] / BIN));
  const values = new Float32Array(columns * rows);
  for (let i = 0; i + 1 < points.length; i += 2) {
    const column = Math.floor(((points[i]! - origin[0]) / size[0]) * columns);
    const row = Math.floor(((points[i + 1]! - origin[1]) / size[1]) * rows);
    if (column >= 0 && column < columns && row >= 0 && row < rows) {
      values[row * columns + column]! += 1;
    }
  }
  return { columns, rows, values };
}

/** Smooths with a Gaussian. The sum is kept: what would leave the grid goes into its outer bins. */
export function smooth({ columns, rows, values }: Density): Density {
  const reach = Math.ceil(3 * SMOOTHING);
  const kernel = Array.from({ length: 2 * reach + 1 }, (_, i) =>
    Math.exp(-0.5 * ((i - reach) / SMOOTHING) ** 2),
  );
  const sum = kernel.reduce((a, b) => a + b);
  const pass = (from: Float32Array, count: number, step: number, lines: number, skip: number) => {
    const to = new Float32Array(from.length);
    for (let line = 0; line < lines; line += 1) {
      for (let i = 0; i < count; i += 1) {
        const value = from[line * skip + i * step]!;
        if (value === 0) continue;
        kernel.forEach((weight, k) => {
          const at = Math.min(count - 1, Math.max(0, i + k - reach));
          to[line * skip + at * step]! += (value * weight) / sum;
        });
      }
    }
    return to;
  };
  const across = pass(values, columns, 1, rows, columns);
  return { columns, rows, values: pass(across, rows, columns, columns, 1) };
}

/** Colours from few to many. Their lightness increases throughout, so colour-blind users can tell them. */
export const RAMP: readonly (readonly [number, number, number])[] = [
  [40, 16, 94],
  [114, 31, 129],
  [190, 55, 110],
  [241, 96, 63],
  [252, 165, 60],
  [252, 246, 176],
];
/** Share of the peak below which a bin is transparent, and from which it has the full opacity. */
const CLEAR = 0.02;
const FULL = 0.35;
const OPACITY = 0.86;

/** RGBA bytes of a density relative to its peak; transparent if it is empty. */
export function colors({ values }: Density): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(4 * values.length);
  const peak = values.reduce((a, b) => Math.max(a, b), 0);
  if (peak === 0) return bytes;
  values.forEach((value, i) => {
    // The square root makes places with few points visible next to the peak.
    const share = Math.sqrt(value / peak);
    const place = share * (RAMP.length - 1);
    const below = Math.min(RAMP.length - 2, Math.floor(place));
    for (let k = 0; k < 3; k += 1) {
      const [low, high] = [RAMP[below]![k]!, RAMP[below + 1]![k]!];
      bytes[4 * i + k] = low + (high - low) * (place - below);
    }
    const opacity = Math.min(1, Math.max(0, (share - CLEAR) / (FULL - CLEAR)));
    bytes[4 * i + 3] = 255 * OPACITY * opacity;
  });
  return bytes;
}
