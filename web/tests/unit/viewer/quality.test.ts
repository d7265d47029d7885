import { expect, test } from "vitest";
import { Governor, LEVELS, SLOW } from "../../../src/viewer/quality.ts";

/** Runs frames of `ms` each. @returns How often the level changed. */
function run(governor: Governor, ms: number, frames: number, start: { now: number }): number {
  let changes = 0;
  for (let i = 0; i < frames; i += 1) {
    start.now += ms;
    if (governor.pictureAt(start.now, true)) changes += 1;
  }
  return changes;
}

test("slow frames lower the quality step by step to the last level", () => {
  const governor = new Governor(0);
  const clock = { now: 0 };
  run(governor, 60, 20, clock);
  expect(governor.level).toBe(1);
  run(governor, 60, 2000, clock);
  expect(governor.level).toBe(LEVELS.length - 1);
  expect(LEVELS.at(-1)!.pixelRatio).toBeGreaterThan(0.5);
});

test("one slow frame among fast ones changes nothing", () => {
  const governor = new Governor(0);
  const clock = { now: 0 };
  for (let i = 0; i < 20; i += 1) {
    run(governor, 16, 15, clock);
    run(governor, 120, 1, clock);
  }
  expect(governor.level).toBe(0);
});

test("frames of medium speed do not change the level", () => {
  const governor = new Governor(2);
  expect(run(governor, 22, 1000, { now: 0 })).toBe(0);
});

test("a screen that shows only every second of its 60 frames per second lowers the quality", () => {
  const governor = new Governor(2);
  run(governor, 1000 / 30, 40, { now: 0 });
  expect(governor.level).toBeGreaterThan(2);
  expect(1000 / SLOW).toBe(40);
});

test("fast frames over a long time raise the quality", () => {
  const governor = new Governor(2);
  run(governor, 16, 2000, { now: 0 });
  expect(governor.level).toBe(0);
});

test("fast frames do not raise the quality above the best allowed level", () => {
  const governor = new Governor(3, 2);
  run(governor, 16, 4000, { now: 0 });
  expect(governor.level).toBe(2);
});

test("the times between isolated pictures are ignored", () => {
  const governor = new Governor(0);
  for (let i = 0; i < 500; i += 1) governor.pictureAt(120 * i, false);
  expect(governor.level).toBe(0);
  expect(governor.pictureMs).toBe(0);
});

test("a higher level that is too slow is tried less and less often", () => {
  const governor = new Governor(2);
  const clock = { now: 0 };
  const tries = [0, 0];
  for (let half = 0; half < 2; half += 1) {
    for (let i = 0; i < 20_000; i += 1) {
      if (run(governor, governor.level < 2 ? 60 : 16, 1, clock) && governor.level < 2)
        tries[half]! += 1;
    }
  }
  expect(tries[0]).toBeGreaterThan(tries[1]!);
  expect(tries[1]).toBeLessThan(5);
});

test("the reported frame time is the median", () => {
  const governor = new Governor(0);
  expect(governor.pictureMs).toBe(0);
  run(governor, 17, 40, { now: 0 });
  expect(governor.pictureMs).toBe(17);
});
