/** The first page of the Train tab: the puzzle of the day, the cards of the drills, and the progress. */

import { h } from "../common/dom.ts";
import { t } from "../words/translate.ts";
import { diagram } from "./drill-diagram.ts";
import { DRILLS, type Drill } from "./drills/index.ts";
import { button, heading, type Trainer } from "./train-parts.ts";
import { mountOwnDrills } from "./own/own-drills.ts";
import { mountProgress } from "./progress-form.ts";
import { bestOf } from "./progress/practice-progress.ts";
import { mountPuzzles } from "./puzzle-card.ts";
import { greatest } from "./drill-score.ts";
import { drillName } from "./train-words.ts";

/** Size of the balls on a card over their size on the table. */
const ENLARGED = 1.8;

export function mountOverview(root: HTMLElement, trainer: Trainer): void {
  const puzzle = h("section", { class: "puzzle-card", "aria-label": t("puzzle.many") });
  mountPuzzles(puzzle, trainer);
  const progress = h("section", {});
  mountProgress(progress, trainer);
  const own = h("section", { "aria-label": t("own.many") });
  mountOwnDrills(own, trainer, (drill) => card(drill, trainer));
  root.append(
    puzzle,
    heading(t("train.drills")),
    h("p", { class: "hint" }, t("train.intro")),
    h("ul", { class: "drill-list" }, ...DRILLS.map((drill) => h("li", {}, card(drill, trainer)))),
    own,
    h("h2", {}, t("sheet.title")),
    h("p", { class: "hint" }, t("sheet.intro")),
    h(
      "div",
      { class: "row" },
      button("open-sheet", t("sheet.choose"), () => trainer.go({ kind: "sheet" })),
    ),
    progress,
  );
}

/** Drawn cards: the diagrams do not change while the page is open. */
const pictures = new Map<string, SVGSVGElement>();

function card(drill: Drill, { context, keeper, go }: Trainer): HTMLElement {
  const { id } = drill;
  // One's own drills change.
  let picture = drill.name === undefined ? pictures.get(id) : undefined;
  if (!picture) {
    const setting = { drill, step: drill.steps[0]!, attempt: 0 };
    picture = diagram(context.engine, setting, { enlarged: ENLARGED });
    pictures.set(id, picture);
  }
  const best = bestOf(keeper.progress, id);
  const state =
    best === null ? t("train.new") : t("train.best", { score: best, most: greatest(drill) });
  const name = drillName(drill);
  return h(
    "button",
    {
      type: "button",
      class: "drill-card",
      id: `drill-${id.replace(/\s/g, "-")}`,
      onclick: () => go({ kind: "drill", drill }),
    },
    picture,
    h("span", {}, h("strong", {}, name), " ", h("span", { class: "hint" }, state)),
  );
}
