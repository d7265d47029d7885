/** What a diamond system says, in a sentence. */

import type { DiamondReading } from "../../engine/index.ts";
import { decimal, t } from "../words/translate.ts";

/** A difference (diamonds) that is none. */
const EQUAL = 0.05;

/** What a system computes from its two numbers. */
const SUMS: Readonly<Record<DiamondReading["system"], (from: number, over: number) => number>> = {
  "corner-five": (from, over) => from - over,
  plus: (from, over) => from + over,
  "two-to-one": (from, over) => 2 * over - from,
};

/** Most decimals of a number of diamonds. */
const MOST_DIGITS = 3;

/** As many decimals as make the sum true with the numbers that are shown; one if it can be. */
function digitsOf({ system, from, over, predicted }: DiamondReading): number {
  for (let digits = 1; digits < MOST_DIGITS; digits += 1) {
    const shown = (number: number) => Math.round(number * 10 ** digits);
    if (SUMS[system](shown(from), shown(over)) === shown(predicted)) return digits;
  }
  return MOST_DIGITS;
}

/** The sum of a system, and where the ball does arrive. */
export function readingInWords(reading: DiamondReading): string {
  const { system, from, over, predicted, actual } = reading;
  const one = (number: number) => decimal(number, 1);
  const digits = digitsOf(reading);
  const shown = (number: number) => decimal(number, digits);
  const numbers = { from: shown(from), over: shown(over), predicted: shown(predicted) };
  const said = t(`diamonds.${system}`, numbers);
  if (actual === null) return t("diamonds.not-there", { said });
  const difference = Math.abs(actual - predicted);
  if (difference < EQUAL) return t("diamonds.equal", { said });
  return t("diamonds.actual", { said, actual: one(actual), difference: one(difference) });
}
