/** Chances from counts of variants. */

import { decimal, t } from "../words/translate.ts";

/** An estimated chance: `hits` of `count` variants. */
export interface Chance {
  hits: number;
  count: number;
  /** hits / count; NaN before the first variant. */
  value: number;
  /** √(p(1 − p)/n), the binomial standard error of `value`; 0 where all or none hit. */
  standardError: number;
}

/** The chance and its standard error from counts. */
export function chance(hits: number, count: number): Chance {
  const value = hits / count;
  return { hits, count, value, standardError: Math.sqrt((value * (1 - value)) / count) };
}

/** Confidence of the one-sided bound that is used if all or none of the variants hit. */
const CONFIDENCE = 0.95;

/**
 * One-sided 95 % bound on the distance of the chance from 0 (or 1) if none (or all) of `count` variants
 * hit: 1 − 0.05^(1/n), about 3/n, the "rule of three".
 */
export function bound(count: number): number {
  return -Math.expm1(Math.log1p(-CONFIDENCE) / count);
}

/** The chance in words: "37.2 % ± 1.5 %", "less than 0.3 %", "more than 99.7 %". */
export function chanceInWords(of: Chance): string {
  if (of.count === 0) return t("chance.unknown");
  if (of.hits === 0) return t("chance.less", { percent: percent(bound(of.count), Math.ceil) });
  if (of.hits === of.count)
    return t("chance.more", { percent: percent(1 - bound(of.count), Math.floor) });
  return t("chance.value", { percent: percent(of.value), error: percent(of.standardError) });
}

/** Percent with one decimal; bounds are rounded away from 0 or 1. */
function percent(share: number, round: (x: number) => number = Math.round): string {
  return t("chance.percent", { number: decimal(round(share * 1000) / 10, 1) });
}
