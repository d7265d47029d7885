import { afterEach, expect, test } from "vitest";
import { type BallEntry, load } from "../../../src/engine/index.ts";
import { errorText } from "../../../src/app/common/refusals.ts";
import { setLanguage } from "../../../src/app/words/translate.ts";

const engine = await load();
const CUE: BallEntry = { id: "cue", position: [0.5, 0.6] };

/** The text for a shot that the engine refuses. */
function refusal(balls: readonly BallEntry[], strike: object = {}): string {
  const shot = {
    format: "carom-shot/1",
    table: "wpa-9ft",
    balls,
    strike: { ball: "cue", speed: 2, azimuth_deg: 80, ...strike },
  } as const;
  try {
    engine.shot(shot).simulate();
  } catch (error) {
    return errorText(error, balls);
  }
  throw new Error("the shot was not refused");
}

afterEach(() => setLanguage("en"));

test.each([
  ["an overlap", [CUE, { id: "1", position: [0.5, 0.64] }], {}, /^Ball 1 overlaps the cue ball/],
  [
    "a ball over a pocket",
    [CUE, { id: "3", position: [0, 0] }],
    {},
    /^Ball 3 lies over the bottom/,
  ],
  ["a ball outside", [CUE, { id: "3", position: [-3, 1] }], {}, /^Ball 3 lies outside the table/],
  ["a miscue", [CUE], { side: 0.7 }, /which is a miscue/],
  ["a speed out of range", [CUE], { speed: 60 }, /^Cue speed: 60 is not possible/],
] as const)("%s is a sentence for players", (_, balls, strike, words) => {
  expect(refusal(balls, strike)).toMatch(words);
  expect(refusal(balls, strike)).not.toMatch(/balls\[|physics\.|strike\./);
  setLanguage("de");
  expect(refusal(balls, strike)).not.toMatch(words);
});
