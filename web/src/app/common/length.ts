/** Lengths of vectors. */

/** Of a vector. Unlike `Math.hypot` its bits are the same in every browser. */
export function length(x: number, y: number): number {
  return Math.sqrt(x * x + y * y);
}
