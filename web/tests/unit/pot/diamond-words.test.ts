import { expect, test } from "vitest";
import type { DiamondReading } from "../../../src/engine/index.ts";
import { readingInWords } from "../../../src/app/pot/diamond-words.ts";

const reading = (system: string, from: number, over: number, predicted: number) =>
  readingInWords({ system, from, over, predicted, actual: null } as DiamondReading);

// Seen: "2 × 4.6 − 6.6 = 2.7".
test("the sum of a diamond system is true with the numbers that are shown", () => {
  expect(reading("two-to-one", 6.62, 4.64, 2.66)).toContain("2 × 4.64 − 6.62 = 2.66.");
  expect(reading("two-to-one", 6.6, 4.6, 2.6)).toContain("2 × 4.6 − 6.6 = 2.6.");
  expect(reading("corner-five", 5, 3, 2)).toContain("5.0 − 3.0 = 2.0.");
});
