// Curves against time, as paths of SVG.

/** Where a plot stands and what it spans. */
export interface Frame {
  /** Pixels. */
  width: number;
  height: number;
  /** The span of time, s, from 0. */
  duration: number;
  /** The span of values, in the curve's unit. */
  low: number;
  high: number;
}

/** x of a time in the frame, pixels from the left. */
export function xOf(frame: Frame, time: number): number {
  return frame.duration > 0 ? (time / frame.duration) * frame.width : 0;
}

/** y of a value in the frame, pixels from the top. */
export function yOf(frame: Frame, value: number): number {
  const span = frame.high - frame.low;
  return span > 0 ? ((frame.high - value) / span) * frame.height : frame.height;
}

/** The `d` of a path through the samples. */
export function curve(frame: Frame, times: ArrayLike<number>, values: ArrayLike<number>): string {
  let d = "";
  for (let i = 0; i < times.length; i++) {
    const x = xOf(frame, times[i]!).toFixed(1);
    const y = yOf(frame, values[i]!).toFixed(1);
    d += `${i === 0 ? "M" : "L"}${x} ${y}`;
  }
  return d;
}

/** Where axes end, times a power of ten. */
const ROUND = [1, 1.5, 2, 3, 4, 5, 6, 8, 10] as const;

/** The least round number that is not below `value`. */
export function roundUp(value: number): number {
  if (!(value > 0)) return 1;
  const power = 10 ** Math.floor(Math.log10(value));
  const step = ROUND.find((s) => s * power >= value) ?? 10;
  return step * power;
}
