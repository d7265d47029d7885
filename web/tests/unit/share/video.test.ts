import { expect, test } from "vitest";
import { frameCount } from "../../../src/app/share/video.ts";

test("a film has a first and a last frame, and its length follows from its speed", () => {
  expect(frameCount(2, 1, 30)).toBe(61);
  expect(frameCount(2, 0.25, 30)).toBe(241);
  expect(frameCount(2.01, 1, 30)).toBe(62);
  expect(frameCount(0, 1, 30)).toBe(1);
});
