/** What a diamond system says, in a sentence. */

import type { DiamondReading } from "../../engine/index.ts";
import { decimal, t } from "../words/translate.ts";

/** A difference (diamonds) that is none. */
const EQUAL = 0.05;

/** The sum of a system, and where the ball does arrive. */
export function readingInWords({ system, from, over, predicted, actual }: DiamondReading): string {
  const one = (number: number) => decimal(number, 1);
  const numbers = { from: one(from), over: one(over), predicted: one(predicted) };
  const said = t(`diamonds.${system}`, numbers);
  if (actual === null) return t("diamonds.not-there", { said });
  const difference = Math.abs(actual - predicted);
  if (difference < EQUAL) return t("diamonds.equal", { said });
  return t("diamonds.actual", { said, actual: one(actual), difference: one(difference) });
}
