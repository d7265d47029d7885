import { describe, expect, test } from "vitest";
import { STRIDE, type Trace } from "../../../src/engine/types.ts";
import { sample } from "../../../src/app/replay/ball-samples.ts";

/** A ball at 2 m/s with spin (3, 0, 4) rad/s, stopped abruptly at 0.5 s of 1 s. */
function suddenStop(): Trace {
  const event = {
    time: 0.5,
    type: "ball-collision",
    balls: ["other", "cue"],
    before: [{}, { velocity: [2, 0, 0], angular_velocity: [3, 0, 4] }],
    after: [{}, { velocity: [0, 0, 0], angular_velocity: [0, 0, -1] }],
  };
  const trace = {
    duration: 1,
    shot: { balls: [{ id: "other" }, { id: "cue" }] },
    events: [event],
    statesAt: (time: number, out: Float64Array) => {
      out.fill(0);
      const moving = time < 0.5;
      out.set(moving ? [2, 0, 0, 3, 0, 4] : [0, 0, 0, 0, 0, -1], STRIDE + 3);
      return out;
    },
  };
  return trace as unknown as Trace;
}

describe("samples of a ball's motion", () => {
  const samples = sample(suddenStop(), 1);

  test("have increasing times from start to end", () => {
    expect(samples.times[0]).toBe(0);
    expect(samples.times.at(-1)).toBe(1);
    expect(samples.times).toStrictEqual([...samples.times].sort((a, b) => a - b));
  });

  test("have the states before and after an impact at its instant", () => {
    const at = samples.times.indexOf(0.5);
    expect(samples.speed.slice(at, at + 2)).toStrictEqual([2, 0]);
    expect(samples.spin.slice(at, at + 2)).toStrictEqual([5, 1]);
    expect(samples.side.slice(at, at + 2)).toStrictEqual([4, -1]);
  });

  test("of a ball without events are on the grid only", () => {
    const other = sample({ ...suddenStop(), events: [] }, 0);
    expect(new Set(other.times).size).toBe(other.times.length);
    expect(Math.max(...other.speed)).toBe(0);
  });
});
