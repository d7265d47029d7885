import { describe, expect, test } from "vitest";
import type { TraceEvent } from "../../../src/engine/index.ts";
import {
  latest,
  moments,
  next,
  previous,
  representatives,
} from "../../../src/app/replay/event-moments.ts";

const at = (time: number): TraceEvent => ({
  time,
  type: "slate-collision",
  balls: ["cue"],
  impulses: [],
  points: [],
  before: [],
  after: [],
});

describe("the steps of a replay", () => {
  const steps = moments([0, 0.5, 0.5, 0.5, 1.25].map(at));

  test("group the events of one instant", () => {
    expect(steps).toStrictEqual([
      { time: 0, events: [0] },
      { time: 0.5, events: [1, 2, 3] },
      { time: 1.25, events: [4] },
    ]);
  });

  test("go to the nearest moment before or after, never to the present one", () => {
    expect(next(steps, 0)?.time).toBe(0.5);
    expect(next(steps, 0.49)?.time).toBe(0.5);
    expect(next(steps, 0.5)?.time).toBe(1.25);
    expect(previous(steps, 1.25)?.time).toBe(0.5);
    expect(previous(steps, 0.7)?.time).toBe(0.5);
    expect(previous(steps, 0.5)?.time).toBe(0);
  });

  test("stop at both ends", () => {
    expect(next(steps, 1.25)).toBeUndefined();
    expect(previous(steps, 0)).toBeUndefined();
    expect(next([], 1)).toBeUndefined();
    expect(previous([], 1)).toBeUndefined();
  });

  test("find the latest moment", () => {
    expect(latest(steps, 0.6)?.events).toStrictEqual([1, 2, 3]);
    expect(latest(steps, 0.5)?.time).toBe(0.5);
    expect(latest(steps, -1)).toBeUndefined();
  });

  test("visit every moment once, forwards and backwards", () => {
    const forwards: number[] = [];
    for (let m = next(steps, -1); m; m = next(steps, m.time)) forwards.push(m.time);
    const backwards: number[] = [];
    for (let m = previous(steps, 2); m; m = previous(steps, m.time)) backwards.push(m.time);
    expect(forwards).toStrictEqual([0, 0.5, 1.25]);
    expect(backwards).toStrictEqual([1.25, 0.5, 0]);
  });
});

// Seen: thirteen rows "ball 2 lands" for a ball that hops to rest.
test("the landings of a ball until its next other event are one row of the list", () => {
  const event = (type: string, ...balls: string[]) => ({ type, balls }) as unknown as TraceEvent;
  const land = (ball: string) => event("slate-collision", ball);
  const hops = [
    land("2"),
    land("1"),
    land("2"),
    event("ball-collision", "1", "2"),
    land("2"),
    land("2"),
  ];
  expect(representatives(hops)).toStrictEqual([0, 1, 0, 3, 4, 4]);
});
