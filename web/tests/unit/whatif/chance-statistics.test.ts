import { describe, expect, test } from "vitest";
import { bound, chance, chanceInWords } from "../../../src/app/whatif/chance-statistics.ts";

describe("an estimated chance", () => {
  test("has the binomial standard error", () => {
    const half = chance(50, 100);
    expect(half.value).toBe(0.5);
    expect(half.standardError).toBeCloseTo(0.05, 15);
    expect(chance(100, 1000).standardError).toBeCloseTo(Math.sqrt(0.09 / 1000), 15);
  });

  test("of no hit, or of hits only, has a bound by the rule of three", () => {
    // Of 1000 trials without a hit: 1 − 0.05^(1/1000) = 0.0029912…, against 3/1000.
    expect(bound(1000)).toBeCloseTo(0.00299124, 7);
    expect((1 - bound(50)) ** 50).toBeCloseTo(0.05, 12);
  });

  test("is written with its standard error, or with a bound on the safe side", () => {
    expect(chanceInWords(chance(372, 1000))).toBe("37.2 % ± 1.5 %");
    expect(chanceInWords(chance(0, 1000))).toBe("less than 0.3 %");
    expect(chanceInWords(chance(1000, 1000))).toBe("more than 99.7 %");
    expect(chanceInWords(chance(0, 10))).toBe("less than 25.9 %");
    expect(chanceInWords(chance(0, 0))).toBe("not known yet");
  });
});
