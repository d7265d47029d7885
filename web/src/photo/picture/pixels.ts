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
