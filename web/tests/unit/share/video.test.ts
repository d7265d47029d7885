import { expect, test } from "vitest";
import { frameCount } from "../../../src/app/share/video.ts";

test("a film has a frame at both ends, and lasts as long as its speed says", () => {
  expect(frameCount(2, 1, 30)).toBe(61);
  expect(frameCount(2, 0.25, 30)).toBe(241);
  expect(frameCount(2.01, 1, 30)).toBe(62);
  expect(frameCount(0, 1, 30)).toBe(1);
});
