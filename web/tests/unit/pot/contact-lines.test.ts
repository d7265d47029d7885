/** The tangent line and the natural angle, beside what the engine's balls do. */

import { beforeAll, expect, test } from "vitest";
import { contactLinesOf, lineFrom } from "../../../src/app/pot/contact-lines.ts";
import { type Engine, load, type ShotFile, type Trace } from "../../../src/engine/index.ts";

let engine: Engine;
beforeAll(async () => {
  engine = await load();
});

/** A cut of ball 1 on a table whose balls are elastic and without friction. */
function cut(height: number, speed: number): Trace {
  const file: ShotFile = {
    format: "carom-shot/1",
    table: "wpa-9ft",
    physics: "ideal",
    balls: [
      { id: "cue", position: [0.6, 0.6] },
      { id: "1", position: [0.63, 0.9] },
    ],
    strike: { ball: "cue", speed, azimuth_deg: 90, elevation_deg: 0, height },
  };
  return engine.shot(file).simulate();
}

const angle = ([x, y]: readonly [number, number, ...number[]]) =>
  (Math.atan2(y, x) * 180) / Math.PI;

/** Velocities of the cue ball behind the contact: at once, and when it rolls. */
function velocities(trace: Trace): readonly (readonly [number, number, number])[] {
  const met = trace.events.findIndex(({ type }) => type === "ball-collision");
  const rolls = trace.events.findIndex(
    ({ balls, after }, k) =>
      k > met && balls.includes("cue") && after[balls.indexOf("cue")]?.motion === "rolling",
  );
  return [met, rolls].map((k) => {
    const event = trace.events[k]!;
    return event.after[event.balls.indexOf("cue")]!.velocity;
  });
}

test("a cue ball that slides without spin leaves along the tangent line", () => {
  const trace = cut(0, 5);
  // The cloth has given the cue ball a little follow, which acts later.
  expect(angle(velocities(trace)[0]!)).toBeCloseTo(angle(contactLinesOf(trace)!.tangent), 6);
});

test("a cue ball that rolls leaves by the natural angle", () => {
  const trace = cut(0.4, 1);
  expect(angle(velocities(trace)[1]!)).toBeCloseTo(angle(contactLinesOf(trace)!.natural), 3);
});

test("a full hit has no tangent line", () => {
  const file: ShotFile = {
    format: "carom-shot/1",
    table: "wpa-9ft",
    balls: [
      { id: "cue", position: [0.6, 0.6] },
      { id: "1", position: [0.6, 1.2] },
    ],
    strike: { ball: "cue", speed: 2, azimuth_deg: 90, elevation_deg: 0 },
  };
  expect(contactLinesOf(engine.shot(file).simulate())).toBeNull();
});

test("a line ends at the edge of the cloth", () => {
  const points = lineFrom([1, 1], [1, 0], [1.27, 2.54], 0.03);
  expect(Array.from(points.subarray(4, 6))).toEqual([1.24, 1]);
  expect(lineFrom([1, 1], [0, 1], [1.27, 2.54], 0.03)[5]).toBeCloseTo(1.7, 12);
});
