/** The first steps ask for something that the shot does not do yet, and that can be done. */

import { beforeAll, describe, expect, test } from "vitest";
import { isDone, LESSONS } from "../../../src/app/help/lessons.ts";
import { azimuthOfAim } from "../../../src/app/document/pot-lock.ts";
import { changed } from "../../../src/app/document/strike-angles.ts";
import { type Engine, load, type ShotFile, type StrikeEntry } from "../../../src/engine/index.ts";

let engine: Engine;
beforeAll(async () => {
  engine = await load();
});

const played = (step: number, change: Partial<StrikeEntry>) => {
  const { shot } = LESSONS[step]!;
  const file: ShotFile = { ...shot, strike: changed(shot.strike, change) };
  return engine.shot(file).simulate();
};

describe.each(LESSONS.map((lesson, step) => [lesson.text, step] as const))("%s", (_, step) => {
  test("is not done by the shot as it is", () => {
    expect(isDone(LESSONS[step]!, played(step, {}))).toBe(false);
  });
});

test("the first one is done by an aim that is turned by little", () => {
  const { shot, ball, pocket } = LESSONS[0]!;
  const aim = engine.shot(shot).potAim(ball, pocket)!;
  const degrees = azimuthOfAim(aim);
  expect(Math.abs(degrees - (shot.strike.azimuth_deg ?? 0))).toBeLessThan(4);
  expect(isDone(LESSONS[0]!, played(0, { azimuth_deg: degrees }))).toBe(true);
});

test("the second one is done by a lower and harder strike", () => {
  expect(isDone(LESSONS[1]!, played(1, { speed: 2.5, height: -0.2 }))).toBe(true);
});
