/** The graph of a whole frame: the first player's chance to win, and a mark for every shot. */

import { svg } from "../../common/dom.ts";
import { percent } from "../machine/machine-explanation.ts";
import { EDGE, HEIGHT, type StepLine, stepLines, WIDTH } from "../recorded/chance-steps.ts";
import { ofFirst } from "../recorded/match-game.ts";
import { t } from "../../words/translate.ts";
import { type Cost, gradeOf } from "./shot-costs.ts";

/** The shapes of the marks, so that they differ without colours; units of the graph. */
const MARKS = {
  good: "M-2.5 0a2.5 2.5 0 1 0 5 0a2.5 2.5 0 1 0-5 0z",
  slip: "M0-4L4 3H-4z",
  mistake: "M0-4.5L4.5 0L0 4.5L-4.5 0z",
} as const;

/** @param play Called when a shot is pressed. */
export function frameGraph(
  names: readonly [string, string],
  costs: readonly Cost[],
  textOf: (cost: Cost) => string,
  play: (cost: Cost) => void,
): SVGSVGElement {
  const steps = costs.map(({ index, player, before, after }) => ({
    index,
    by: "both" as const,
    from: ofFirst(player, before),
    to: ofFirst(player, after),
  }));
  const lines = stepLines(steps);
  const [name] = names;
  const said = { name, from: percent(steps[0]?.from ?? 0), to: percent(steps.at(-1)?.to ?? 0) };
  return svg(
    "svg",
    { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, role: "img", "aria-label": t("costs.graph", said) },
    ...[HEIGHT - EDGE, HEIGHT / 2, EDGE].map((y) =>
      svg("line", { class: "axis", x1: EDGE, y1: y, x2: WIDTH - EDGE, y2: y }),
    ),
    ...lines.map((line, k) => stepOf(line, costs[k]!, textOf, play)),
  );
}

function stepOf(
  { x1, y1, x2, y2 }: StepLine,
  cost: Cost,
  textOf: (cost: Cost) => string,
  play: (cost: Cost) => void,
): SVGElement {
  const grade = gradeOf(cost);
  return svg(
    "g",
    { class: grade, onclick: () => play(cost) },
    svg("title", {}, textOf(cost)),
    svg("rect", { x: x1, y: 0, width: x2 - x1, height: HEIGHT }),
    svg("line", { x1, y1, x2, y2 }),
    svg("path", { class: "mark", d: MARKS[grade], transform: `translate(${x2} ${y2})` }),
  );
}
