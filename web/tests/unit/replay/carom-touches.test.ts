import { expect, test } from "vitest";
import { load, type ShotFile } from "../../../src/engine/index.ts";
import { countText, touchesOf, tracedEvent } from "../../../src/app/replay/carom-touches.ts";

const engine = await load();

const BALLS = [
  { id: "cue", position: [1.1, 0.5] },
  { id: "yellow", position: [0.4, 0.6] },
  { id: "red", position: [0.9, 2.2] },
];

function traceOf(table: string) {
  const strike = { ball: "yellow", speed: 4, azimuth_deg: 350.5, side: 0.3, height: 0.3 };
  const file = { format: "carom-shot/1", table, balls: BALLS, strike };
  return engine.shot(file as unknown as ShotFile).simulate();
}

test("a replay counts the balls and cushions of the cue ball up to the second ball", () => {
  const trace = traceOf("carom-10ft");
  const touches = touchesOf(trace);
  expect(touches.map(({ kind }) => kind)).toEqual([
    "first",
    "cushion",
    "cushion",
    "cushion",
    "second",
  ]);
  const words = touches.map(({ event }) => tracedEvent(trace, trace.events[event]!));
  expect(words[0]).toBe("the white and the yellow collide, first ball");
  expect(words[1]).toBe("the yellow hits the right rail, cushion 1");
  expect(words[3]).toBe("the yellow hits the left rail, cushion 3");
  expect(words[4]).toMatch(/, second ball$/);
  const time = trace.events[touches[2]!.event]!.time;
  expect(countText(trace, time)).toBe("1 ball, 2 cushions");
  expect(countText(trace, 0)).toBe("");
});

test("cushions of other balls and after the second ball have no number", () => {
  const trace = traceOf("carom-10ft");
  const counted = new Set(touchesOf(trace).map(({ event }) => event));
  const other = trace.events.filter(
    ({ type }, index) => type === "rail-collision" && !counted.has(index),
  );
  expect(other.length).toBeGreaterThan(0);
  for (const event of other) expect(tracedEvent(trace, event)).not.toMatch(/cushion/);
});

test("a table with pockets counts nothing", () => {
  expect(touchesOf(traceOf("wpa-9ft"))).toEqual([]);
});
