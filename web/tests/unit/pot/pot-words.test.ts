import { afterEach, expect, test } from "vitest";
import type { PotLock } from "../../../src/app/document/document.ts";
import { hitText, lockText } from "../../../src/app/pot/pot-words.ts";
import { setLanguage } from "../../../src/app/words/translate.ts";

const lock: PotLock = {
  ball: "9",
  pocket: "top-right",
  solved: true,
  margin: 0.304,
  kind: "direct",
  losesCueBall: false,
};
const half = { fullness: 0.49, cut: 30.7 };

afterEach(() => setLanguage("en"));

test("an aim is a sentence in every language", () => {
  const texts = (["en", "de", "zh"] as const).map((language) => {
    setLanguage(language);
    return lockText(lock, half);
  });
  expect(texts).toEqual([
    "Ball 9 to the top right pocket: half ball, a cut of 31°, ± 0.30°.",
    "Kugel 9 in die Tasche oben rechts: halb voll, Schnittwinkel 31°, ± 0,30°.",
    "9号球打右上袋：半球，切角 31°，± 0.30°。",
  ]);
});

test("a cut of less than half a degree is straight", () => {
  expect(hitText({ fullness: 1, cut: 0.3 })).toBe("Full hit, straight.");
  expect(hitText({ fullness: 0.99, cut: 0.6 })).toBe("Full hit, a cut of 1°.");
});

test("a line that is not direct has the name of its kind", () => {
  expect(lockText({ ...lock, kind: "jump+bank" }, half)).toBe(
    "Ball 9 to the top right pocket: jump and bank, ± 0.30°.",
  );
});

test("a direct line that meets two balls at once has no cut", () => {
  expect(lockText(lock, null)).toBe("Ball 9 to the top right pocket: direct, ± 0.30°.");
});

test("an aim without a line has a remedy", () => {
  expect(lockText({ ...lock, solved: false }, half)).toBe(
    "Ball 9 to the top right pocket: no line with this stroke. Change the speed or the spin.",
  );
});
