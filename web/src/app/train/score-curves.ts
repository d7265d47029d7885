/** Small pictures of scores: what the levels make of a drill, and the player's own scores by time. */

import { h, svg } from "../common/dom.ts";
import { levelName } from "../common/preset-names.ts";
import { decimal, t } from "../words/translate.ts";
import type { Drill } from "./drills/index.ts";
import { levelScores } from "./drill-levels.ts";
import { greatest } from "./drill-score.ts";

/** Decimals of a mean score. */
const DIGITS = 1;

/** A row for every level: its name, the range of most scores with the mean, and the mean as a number. */
export function levelCurve(drill: Drill, best: number | null): HTMLElement {
  const most = greatest(drill);
  const percent = (score: number) => (100 * score) / most;
  const rows = levelScores(drill).map(({ level, mean, low, high }) => {
    const values = { level: levelName(level), mean: decimal(mean, DIGITS), low, high };
    return h(
      "li",
      { class: "level" },
      h("span", { class: "unseen" }, t("train.level-score", values)),
      h("span", { class: "level-name", "aria-hidden": "true" }, values.level),
      svg(
        "svg",
        { viewBox: "0 0 100 10", preserveAspectRatio: "none", "aria-hidden": "true" },
        svg("path", { class: "level-all", d: "M0 5H100" }),
        svg("path", { class: "level-range", d: `M${percent(low)} 5H${percent(high)}` }),
        svg("path", { class: "level-mean", d: `M${percent(mean)} 1V9` }),
        best !== null && svg("path", { class: "level-yours", d: `M${percent(best)} 0V10` }),
      ),
      h("span", { class: "level-mean-text", "aria-hidden": "true" }, values.mean),
    );
  });
  return h("ul", { class: "levels" }, ...rows);
}

/** The player's scores in the order of time, between 0 and the greatest score. */
export function historyCurve(drill: Drill, scores: readonly number[]): SVGSVGElement {
  const most = greatest(drill);
  const x = (k: number) => (scores.length === 1 ? 50 : (100 * k) / (scores.length - 1));
  const y = (score: number) => 30 - (30 * score) / most;
  const path = scores.map((score, k) => `${k === 0 ? "M" : "L"}${x(k)} ${y(score)}`).join("");
  return svg(
    "svg",
    {
      class: "history-curve",
      viewBox: "-2 -2 104 34",
      preserveAspectRatio: "none",
      role: "img",
      "aria-label": t("train.history-label", { scores: scores.join(", ") }),
    },
    svg("path", { class: "history-axis", d: "M0 30H100M0 0H100" }),
    svg("path", { class: "history-line", d: path }),
    svg("path", {
      class: "history-dots",
      d: scores.map((score, k) => `M${x(k)} ${y(score)}h0.01`).join(""),
    }),
  );
}
