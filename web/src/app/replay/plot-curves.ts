/** Curves against time, as SVG paths. */

/** Size and ranges of a plot. */
export interface PlotArea {
  /** Pixels. */
  width: number;
  height: number;
  /** The span of time, s, from 0. */
  duration: number;
  /** The span of values, in the curve's unit. */
  low: number;
  high: number;
}

/** x of a time, pixels from the left. */
export function xOf(area: PlotArea, time: number): number {
  return area.duration > 0 ? (time / area.duration) * area.width : 0;
}

/** y of a value, pixels from the top. */
export function yOf(area: PlotArea, value: number): number {
  const span = area.high - area.low;
  return span > 0 ? ((area.high - value) / span) * area.height : area.height;
}

/** The `d` of a path through the samples. */
export function curve(area: PlotArea, times: ArrayLike<number>, values: ArrayLike<number>): string {
  let d = "";
  for (let i = 0; i < times.length; i++) {
    const x = xOf(area, times[i]!).toFixed(1);
    const y = yOf(area, values[i]!).toFixed(1);
    d += `${i === 0 ? "M" : "L"}${x} ${y}`;
  }
  return d;
}

/** Ends of axes, to be multiplied by a power of ten. */
const ROUND = [1, 1.5, 2, 3, 4, 5, 6, 8, 10] as const;

/** The smallest round number at or above `value`. */
export function roundUp(value: number): number {
  if (!(value > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  const step = ROUND.find((s) => s * power >= value) ?? 10;
  // Without the error of the product, as in 6 · 0.1.
  return Number((step * power).toPrecision(2));
}
