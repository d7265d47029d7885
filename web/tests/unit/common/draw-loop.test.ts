import { expect, test, vi } from "vitest";
import { DrawLoop } from "../../../src/app/common/draw-loop.ts";

/** A loop whose frames the test triggers. */
function stepped(draw: () => boolean = () => false) {
  const waiting: FrameRequestCallback[] = [];
  const drawn = vi.fn(draw);
  const loop = new DrawLoop(drawn, (callback) => waiting.push(callback));
  let now = 0;
  const frame = (milliseconds = 16) => {
    now += milliseconds;
    for (const callback of waiting.splice(0)) callback(now);
  };
  return { loop, drawn, frame, waiting };
}

test("all moves of a pointer within a frame are one change and one picture", () => {
  const { loop, drawn, frame } = stepped();
  const seen: number[] = [];
  for (let k = 0; k < 20; k += 1) loop.input("pointer", () => seen.push(k));
  frame();
  expect(seen).toEqual([19]);
  expect(drawn).toHaveBeenCalledTimes(1);
});

test("a handle added by a handle runs before the picture of the same frame", () => {
  const { loop, drawn, frame, waiting } = stepped();
  const follow = vi.fn();
  loop.input("pointer", () => {
    loop.input("words", follow);
  });
  frame();
  expect(follow).toHaveBeenCalledTimes(1);
  expect(drawn).toHaveBeenCalledTimes(1);
  expect(waiting).toHaveLength(0);
});

test("nothing is drawn while nothing changes", () => {
  const { loop, drawn, frame, waiting } = stepped();
  loop.invalidate();
  loop.invalidate();
  expect(waiting).toHaveLength(1);
  frame();
  expect(waiting).toHaveLength(0);
  frame();
  expect(drawn).toHaveBeenCalledTimes(1);
});

test("an animation receives the wall time since its last frame, and 0 after a pause", () => {
  const { loop, frame } = stepped();
  const elapsedTimes: number[] = [];
  loop.animate((elapsed) => elapsedTimes.push(elapsed) < 3);
  frame();
  frame(20);
  frame(30);
  expect(elapsedTimes).toEqual([0, 0.02, 0.03]);
  frame(5000);
  loop.animate((elapsed) => {
    elapsedTimes.push(elapsed);
    return false;
  });
  frame();
  expect(elapsedTimes.at(-1)).toBe(0);
});

test("flush runs the last move of a gesture", () => {
  const { loop } = stepped();
  const last = vi.fn();
  loop.input("pointer", last);
  loop.flush();
  expect(last).toHaveBeenCalledTimes(1);
});
