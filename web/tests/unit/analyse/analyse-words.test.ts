import { describe, expect, test } from "vitest";
import {
  recommendationText,
  partsOf,
  planText,
  strikeText,
  whyText,
  zoneText,
} from "../../../src/app/analyse/analyse-words.ts";
import { pot } from "./recommendation.ts";

const strike = { speed: 2, azimuth: 1, elevation: 0.03, side: 0, height: 0 };

describe("a strike in words", () => {
  test.each([
    [{}, "centre ball, lag speed"],
    [{ side: 0.17, speed: 1 }, "a tip of right, soft"],
    [{ side: -0.08, height: -0.34, speed: 3 }, "half a tip of left, two tips of draw, firm"],
    [{ height: 0.5, speed: 6 }, "three tips of follow, hard"],
    [{ side: 0.04, speed: 9, elevation: 0.5 }, "centre ball, break, cue raised"],
  ])("%o is “%s”", (part, text) => {
    expect(strikeText({ ...strike, ...part })).toBe(text);
  });
});

describe("a line in words", () => {
  test("names ball, pocket, spin and speed", () => {
    expect(recommendationText(pot())).toBe(
      "Ball 9 into the top right pocket, centre ball, lag speed",
    );
  });

  test("names the ball between in a combination", () => {
    const legs = [["cue", 0] as const, ["4", 0] as const, ["9", 0] as const];
    const line = pot({ more: { kind: "combination", legs } });
    expect(recommendationText(line)).toMatch(/^Ball 9 by ball 4 into the top right pocket/);
  });

  test("names a safety", () => {
    const safety = pot({ more: { kind: "safety", ball: null, pocket: null } });
    expect(recommendationText(safety)).toMatch(/^Safety, /);
  });
});

describe("the reason why a line is better", () => {
  test("is a split of the whole difference", () => {
    const [a, b] = [pot({ kept: 0.9, ifKept: 0.72, ifMissed: 0.3 }), pot({ kept: 0.6 })];
    const sum = partsOf(a, b).reduce((total, { share }) => total + share, 0);
    expect(sum).toBeCloseTo(a.win_chance - b.win_chance, 12);
  });

  test("names the chance of the pot where that makes the difference", () => {
    expect(whyText(pot({ kept: 0.95 }), pot({ kept: 0.6 }), [1, 2])).toBe(
      "Shot 1 wins more often than shot 2: 69 % to 58 %. " +
        "Shot 1 keeps the turn more often: 95 % to 60 %.",
    );
  });

  test("names the position and the spread of the cue ball, and what speaks against it", () => {
    const [a, b] = [
      pot({ kept: 0.7, ifKept: 0.9, spread: 0.15 }),
      pot({ kept: 0.85, ifKept: 0.6, spread: 0.4 }),
    ];
    expect(whyText(a, b, [1, 3])).toBe(
      "Shot 1 wins more often than shot 3: 75 % to 57 %. Shot 1 leaves a better position: " +
        "with the turn kept, 90 % to win, after shot 3 60 %. Its cue ball stops within 15 cm, not 40 cm. " +
        "But: Shot 3 keeps the turn more often: 85 % to 70 %.",
    );
  });

  test("names what a miss leaves, and a foul", () => {
    const [a, b] = [pot({ kept: 0.2, ifMissed: 0.5 }), pot({ kept: 0.2, foul: 0.1 })];
    expect(whyText(a, b, [2, 4])).toBe(
      "Shot 2 wins more often than shot 4: 54 % to 46 %. " +
        "After a miss, shot 2 leaves less to the opponent: 50 % to win, after shot 4 40 %. " +
        "A foul happens in 2 % with shot 2, in 10 % with shot 4.",
    );
  });

  test("is not given where the difference is within the errors", () => {
    expect(whyText(pot({ kept: 0.81, error: 0.02 }), pot({ error: 0.02 }), [1, 2])).toMatch(
      /^Shots 1 and 2 are too close to tell/,
    );
  });
});

describe("a look ahead in words", () => {
  test("has the best chance of the zone, or says that there is none", () => {
    expect(zoneText("9", 0.42)).toMatch(/ball 9.*42 %/i);
    expect(zoneText("9", 0)).not.toMatch(/%/);
  });

  test("has the chance of a plan between its bounds", () => {
    const [chance, low, high] = planText(3, 30, 100)
      .match(/\d+(?= %)/g)!
      .map(Number);
    expect([chance, low, high]).toEqual([30, 22, 40]);
    expect(planText(3, 30, 100)).toMatch(/100/);
  });
});
