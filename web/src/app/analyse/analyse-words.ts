/** Recommendations of the analysis in the words of players. */

import type { Recommendation, Strike } from "../../engine/index.ts";
import { powerWord } from "../aim/power-bar.ts";
import { playedName, pocketName } from "../common/shot-words.ts";
import { estimatedPercent, TIP } from "../common/units.ts";
import { patternText } from "../pot/carom-words.ts";
import { interval } from "./plan-orders.ts";
import { capital, decimal, named, paragraph, t } from "../words/translate.ts";

/** Tip offset of half a tip, ball radii. */
const HALF_TIP = TIP / 2;

/** Elevation from which a player would say that the cue is raised, rad: 10°. */
const RAISED = Math.PI / 18;

/** A recommendation as players say it: "9 into the top left pocket, a tip of right, soft". */
export function recommendationText(recommendation: Recommendation): string {
  return [whatText(recommendation), strikeText(recommendation.play.strike)].join(t("lines.gap"));
}

/** What a recommendation is meant to do. */
export function whatText({ kind, ball, pocket, legs, play, route }: Recommendation): string {
  if (route) return patternText(route);
  if (ball !== null && pocket !== null) {
    const names = { ball: playedName(ball), pocket: pocketName(pocket) };
    const through = legs
      .slice(1)
      .map(([id]) => id)
      .find((id) => id !== ball);
    switch (kind) {
      case "bank":
        return capital(t("lines.bank", names));
      case "kick":
        return capital(t("lines.kick", names));
      case "combination":
        return through === undefined
          ? capital(t("lines.pot", names))
          : capital(t("lines.combination", { ...names, other: playedName(through) }));
      default:
        return capital(t("lines.pot", names));
    }
  }
  const on = play.call?.kind === "on" ? play.call.ball : undefined;
  if (kind === "safety" && on !== undefined) return t("lines.safety-on", { ball: playedName(on) });
  return named("lines", kind) ?? kind;
}

/** Spin and speed of a strike: "a tip of right, soft". */
export function strikeText({ side, height, speed, elevation }: Strike): string {
  const words = [tips(side, "right", "left"), tips(height, "follow", "draw")].filter(
    (word) => word !== null,
  );
  if (words.length === 0) words.push(t("lines.centre"));
  words.push(t(powerWord(speed)));
  if (elevation > RAISED) words.push(t("lines.raised"));
  return words.join(t("lines.gap"));
}

function tips(offset: number, plus: "right" | "follow", minus: "left" | "draw"): string | null {
  const halves = Math.min(6, Math.round(Math.abs(offset) / HALF_TIP)) as 0 | 1 | 2 | 3 | 4 | 5 | 6;
  if (halves === 0) return null;
  const where = t(`lines.tip.${offset > 0 ? plus : minus}`);
  return t(`lines.tips.${halves}`, { where });
}

/** An estimated chance in per cent. */
export function percent(share: number): string {
  return t("chance.percent", { number: estimatedPercent(share) });
}

/** A distance (m) in whole centimetres: a leave is not known better. */
export function centimetres(metres: number): string {
  return t("lines.centimetres", { length: decimal(100 * metres, 0) });
}

/** Where a recommendation leaves the cue ball, for those who do not see the picture. */
export function leaveText({ leave }: Recommendation): string {
  if (leave.spread === null || leave.count === 0) return t("lines.leave-unknown");
  return t("lines.leave", { spread: centimetres(leave.spread) });
}

/** How a difference of the chance to win arises. */
interface Part {
  readonly key: "kept" | "position" | "safety";
  /** Share of the difference, as a probability; positive in favour of the better recommendation. */
  readonly share: number;
}

/** Smallest part of a difference that is worth a sentence. */
const NOTABLE = 0.005;
/** Smallest difference of the chances of a foul that is mentioned. */
const NOTABLE_FOUL = 0.03;
/** Smallest difference of where the cue ball stops that is mentioned, m. */
const NOTABLE_SPREAD = 0.1;
/** Standard errors within which two chances to win count as equal. */
const EQUAL = 2;

/**
 * How the difference of two recommendations' chances to win arises. A chance to win is k·w + (1 − k)·m: the chance
 * to keep the turn k, and the chances to win if it is kept (w) and if not (m). The difference is split
 * exactly into the parts of k, w and m, each at the mean of the others.
 */
export function partsOf(a: Recommendation, b: Recommendation): readonly Part[] {
  const of = (recommendation: Recommendation) => {
    const w = recommendation.win_if_kept ?? recommendation.win_chance;
    return {
      k: recommendation.kept.probability,
      w,
      m: recommendation.win_if_missed ?? recommendation.win_chance,
    };
  };
  const [x, y] = [of(a), of(b)];
  const k = (x.k + y.k) / 2;
  return [
    { key: "kept", share: (x.k - y.k) * ((x.w + y.w) / 2 - (x.m + y.m) / 2) },
    { key: "position", share: k * (x.w - y.w) },
    { key: "safety", share: (1 - k) * (x.m - y.m) },
  ];
}

/**
 * Why recommendation `first` is better than recommendation `second`, in one to three sentences.
 *
 * @param names The numbers under which the recommendations are shown.
 */
export function whyText(
  first: Recommendation,
  second: Recommendation,
  [a, b]: readonly [number, number],
): string {
  const difference = first.win_chance - second.win_chance;
  const values = { a, b, winA: percent(first.win_chance), winB: percent(second.win_chance) };
  if (difference < EQUAL * Math.hypot(first.error, second.error)) return t("why.equal", values);
  const parts = partsOf(first, second).toSorted((x, y) => y.share - x.share);
  const said = [t("why.better", values)];
  const [most] = parts;
  if (most && most.share > NOTABLE) said.push(partText(most.key, first, second, a, b));
  const least = parts.at(-1);
  if (least && least.share < -NOTABLE)
    said.push(t("why.but", { text: partText(least.key, second, first, b, a) }));
  const foul = second.foul.probability - first.foul.probability;
  if (Math.abs(foul) >= NOTABLE_FOUL) {
    said.push(
      t("why.foul", {
        a,
        b,
        foulA: percent(first.foul.probability),
        foulB: percent(second.foul.probability),
      }),
    );
  }
  return paragraph(said);
}

function partText(
  key: Part["key"],
  better: Recommendation,
  worse: Recommendation,
  a: number,
  b: number,
): string {
  switch (key) {
    case "kept":
      return t("why.kept", {
        a,
        keptA: percent(better.kept.probability),
        keptB: percent(worse.kept.probability),
      });
    case "safety":
      return t("why.safety", {
        a,
        b,
        missA: percent(better.win_if_missed ?? 0),
        missB: percent(worse.win_if_missed ?? 0),
      });
    case "position": {
      const values = {
        a,
        b,
        nextA: percent(better.win_if_kept ?? 0),
        nextB: percent(worse.win_if_kept ?? 0),
      };
      const [x, y] = [better.leave.spread, worse.leave.spread];
      if (x === null || y === null || y - x < NOTABLE_SPREAD) return t("why.position", values);
      const spreads = { spreadA: centimetres(x), spreadB: centimetres(y) };
      return t("why.position-spread", { ...values, ...spreads });
    }
  }
}

/** The best chance of a zone for the next ball. */
export function zoneText(next: string, best: number): string {
  const ball = playedName(next);
  return best > 0 ? t("next.zone", { ball, best: percent(best) }) : t("next.none", { ball });
}

/** The chance of a plan of `count` balls that was met in some of its runs. */
export function planText(count: number, met: number, runs: number): string {
  const [low, high] = interval(met, runs).map(percent) as [string, string];
  return t("plan.total", { count, chance: percent(met / runs), low, high, runs });
}
