/** A photo, or a part of it, as colours. */

export interface Pixels {
  /** Of the part's top left corner in the photo, pixels. */
  readonly left: number;
  readonly top: number;
  readonly width: number;
  readonly height: number;
  /** Red, green, blue and opacity of each pixel, row by row, of 255. */
  readonly data: Uint8ClampedArray;
}

/**
 * The colour at a place of the photo between the centres of its pixels, in `out`; false outside. The
 * centre of the first pixel is at (0.5, 0.5).
 */
export function sample(pixels: Pixels, x: number, y: number, out: Float64Array): boolean {
  const { width, height, data } = pixels;
  const [u, v] = [x - pixels.left - 0.5, y - pixels.top - 0.5];
  const [i, j] = [Math.floor(u), Math.floor(v)];
  if (i < 0 || j < 0 || i + 1 >= width || j + 1 >= height) return false;
  const [a, b] = [u - i, v - j];
  const at = 4 * (j * width + i);
  const below = at + 4 * width;
  for (let c = 0; c < 3; c += 1) {
    const upper = (1 - a) * data[at + c]! + a * data[at + 4 + c]!;
    const lower = (1 - a) * data[below + c]! + a * data[below + 4 + c]!;
    out[c] = (1 - b) * upper + b * lower;
  }
  return true;
}

/** A photo without the finest grain: each pixel is the binomial mean of the nine around it. */
export function smoothed(pixels: Pixels): Pixels {
  const { width, height, data } = pixels;
  const rows = new Uint8ClampedArray(data.length);
  const out = new Uint8ClampedArray(data.length);
  const mean = (from: Uint8ClampedArray, to: Uint8ClampedArray, at: number, by: number[]) => {
    for (let c = at; c < at + 4; c += 1)
      to[c] = (from[c - by[0]!]! + 2 * from[c]! + from[c + by[1]!]!) / 4;
  };
  for (let y = 0; y < height; y += 1)
    for (let x = 0; x < width; x += 1)
      mean(data, rows, 4 * (y * width + x), [x > 0 ? 4 : 0, x + 1 < width ? 4 : 0]);
  const step = 4 * width;
  for (let y = 0; y < height; y += 1)
    for (let x = 0; x < width; x += 1)
      mean(rows, out, 4 * (y * width + x), [y > 0 ? step : 0, y + 1 < height ? step : 0]);
  return { ...pixels, data: out };
}
