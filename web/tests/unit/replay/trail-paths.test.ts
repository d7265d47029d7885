import { expect, test } from "vitest";
import { load, STRIDE } from "../../../src/engine/index.ts";
import { timedPaths } from "../../../src/app/replay/trail-paths.ts";
import { between } from "../../../src/viewer/overlay/trails.ts";

const engine = await load();

test("at every time the path of a ball ends where the ball is", () => {
  // Seen: the trail of a ball that rolled straight ended up to 20 cm behind it.
  const trace = engine.breakShot("nine-ball", { seed: 3 }).simulate();
  const paths = timedPaths(trace, 0.0005);
  const distances = Array.from({ length: 50 }, (_, k) => {
    const time = ((k + 0.5) / 50) * trace.duration;
    const states = trace.statesAt(time);
    return paths.map((points, ball) => {
      const [x, y] = between(points, 0, time).slice(-4) as [number?, number?];
      // A ball without a path rests or has fallen.
      if (x === undefined || y === undefined || points.at(-1)! < time) return 0;
      return Math.hypot(x - states[ball * STRIDE]!, y - states[ball * STRIDE + 1]!);
    });
  });
  expect(Math.max(...distances.flat())).toBeLessThan(0.004);
});

test("the points of the exact path stay in the path", () => {
  const trace = engine.breakShot("nine-ball", { seed: 3 }).simulate();
  timedPaths(trace, 0.0005).forEach((points, ball) => {
    const exact = [...trace.polyline(ball, 0.0005)];
    const times = new Set([...points].filter((_, k) => k % 4 === 3));
    expect(exact.filter((_, k) => k % 4 === 3).every((time) => times.has(time))).toBe(true);
    const all = [...points].filter((_, k) => k % 4 === 3);
    expect(all).toEqual([...all].sort((a, b) => a - b));
  });
});
