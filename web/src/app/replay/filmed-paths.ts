/** The film of a shot beside its simulation: the paths that a camera saw, and where the balls were. */

import type { BallInfo, FilmedBall } from "../../engine/types.ts";
import type { BallPath, Mark } from "../../viewer/index.ts";
import { VERTEX } from "../../viewer/viewer-types.ts";

type Sample = FilmedBall["samples"][number];

/** The filmed paths of the balls of a shot. */
export function filmedPaths(film: readonly FilmedBall[], balls: readonly BallInfo[]): BallPath[] {
  return known(film, balls).map(({ ball, radius, samples }) => {
    const points = new Float64Array(samples.length * VERTEX);
    samples.forEach(([t, x, y], k) => points.set([x, y, radius, t], k * VERTEX));
    return { ball, points, style: "filmed" };
  });
}

/** Where the filmed balls were at a time of the replay, s. */
export function filmedMarks(
  film: readonly FilmedBall[],
  balls: readonly BallInfo[],
  time: number,
): Mark[] {
  return known(film, balls).map(({ ball, radius, samples }) => {
    const [x, y] = placeAt(samples, time);
    return { position: [x, y, radius], kind: "filmed", ball };
  });
}

/** The films of balls that are there, with the index of the ball. */
function known(film: readonly FilmedBall[], balls: readonly BallInfo[]) {
  return film.flatMap(({ ball: id, samples }) => {
    const ball = balls.findIndex((one) => one.id === id);
    return ball < 0 ? [] : [{ ball, radius: balls[ball]!.radius, samples }];
  });
}

/**
 * The place (m) of a ball at a time (s). Between two samples it is taken to move evenly, and before the first
 * and after the last to rest.
 */
export function placeAt(samples: readonly Sample[], time: number): readonly [number, number] {
  const last = samples.at(-1)!;
  if (time >= last[0]) return [last[1], last[2]];
  let [low, high] = [0, samples.length - 1];
  // The last sample at or before the time.
  while (low + 1 < high) {
    const middle = (low + high) >> 1;
    if (samples[middle]![0] <= time) low = middle;
    else high = middle;
  }
  const [from, to] = [samples[low]!, samples[high]!];
  if (time <= from[0]) return [from[1], from[2]];
  const share = (time - from[0]) / (to[0] - from[0]);
  return [from[1] + share * (to[1] - from[1]), from[2] + share * (to[2] - from[2])];
}
