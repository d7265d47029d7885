/** Why the solution of a puzzle is the best way: chances of the levels, the other ways, the tolerance. */

import type { Engine, Strike } from "../../../engine/index.ts";
import { percent, strikeText } from "../../analyse/analyse-words.ts";
import { toRadians } from "../../common/angles.ts";
import { h, svg } from "../../common/dom.ts";
import { levelName } from "../../common/preset-names.ts";
import { decimal, t } from "../../words/translate.ts";
import { button } from "../train-parts.ts";
import type { PuzzleTask } from "./puzzle-task.ts";

/** The level for which ways are compared, as in the engine. */
const LEVEL = "club";

/** Errors of the direction that are tried, degrees. */
const ERRORS = [0.02, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.5, 0.7, 1, 1.5, 2] as const;

/** @param show Plays a strike to be watched. */
export function whyPuzzle(
  engine: Engine,
  task: PuzzleTask,
  show: (strike: Strike) => void,
): HTMLElement[] {
  const { ways, chances } = task.puzzle;
  const [best, ...others] = ways;
  const level = levelName(LEVEL);
  const said = (way: (typeof ways)[number]) => ({
    strike: strikeText(way.strike),
    chance: percent(way.chances[LEVEL]!),
    level,
  });
  const most = tolerance(engine, task, best!.strike);
  return [
    h("h2", {}, t("puzzle.why")),
    h("p", {}, t("puzzle.why-best", said(best!))),
    most > 0 && h("p", {}, t("puzzle.why-tolerance", { angle: decimal(most, 2) })),
    others.length > 0 && h("p", {}, t("puzzle.why-others")),
    others.length > 0 &&
      h(
        "ul",
        { class: "puzzle-ways" },
        ...others.map((way, k) =>
          h(
            "li",
            {},
            t("puzzle.why-other", said(way)),
            " ",
            button(`show-way-${k + 2}`, t("puzzle.show-other", { number: k + 2 }), () =>
              show(way.strike),
            ),
          ),
        ),
      ),
    h("h2", {}, t("train.levels")),
    h("ul", { class: "levels" }, ...Object.entries(chances).map(([name, one]) => bar(name, one))),
    h("p", { class: "hint" }, t("train.levels-hint")),
  ].filter((part) => part !== false);
}

function bar(name: string, chance: number): HTMLElement {
  return h(
    "li",
    { class: "level" },
    h("span", { class: "level-name" }, levelName(name)),
    svg(
      "svg",
      { viewBox: "0 0 100 10", preserveAspectRatio: "none", "aria-hidden": "true" },
      svg("path", { class: "level-all", d: "M0 5H100" }),
      svg("path", { class: "level-range", d: `M0 5H${100 * chance}` }),
    ),
    h("span", { class: "level-mean-text" }, percent(chance)),
  );
}

/** By how much the direction of a strike may be off on either side, degrees. */
function tolerance(engine: Engine, { puzzle }: PuzzleTask, strike: Strike): number {
  const shot = engine.shot(puzzle.shot);
  const solves = (azimuth: number) => {
    const struck = shot.withStrike({ ...strike, azimuth });
    const { fault } = struck.judge(puzzle.goal);
    struck.free();
    return fault === null;
  };
  let most = 0;
  for (const error of ERRORS) {
    const turn = toRadians(error);
    if (!solves(strike.azimuth - turn) || !solves(strike.azimuth + turn)) break;
    most = error;
  }
  shot.free();
  return most;
}
