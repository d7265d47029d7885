/** A drill in detail: diagram, goal, what the levels make of it, the player's scores, and its start. */

import { h } from "../common/dom.ts";
import { levelName } from "../common/preset-names.ts";
import { t } from "../words/translate.ts";
import { historyCurve, levelCurve } from "./score-curves.ts";
import { diagram } from "./drill-diagram.ts";
import type { Drill } from "./drills/index.ts";
import { levelScores } from "./drill-levels.ts";
import { drillActions } from "./own/own-drills.ts";
import { button, heading, type Trainer } from "./train-parts.ts";
import { bestOf, resultsOf } from "./progress/practice-progress.ts";
import { total } from "./drill-score.ts";
import { drillName, goalText, sourceText, tableText } from "./train-words.ts";

/** Size of the balls over their size on the table. */
const ENLARGED = 1.4;

/** The level whose errors the strikes have at first. */
let chosen: string | null = "club";

export function mountDetail(root: HTMLElement, trainer: Trainer, drill: Drill): void {
  const { context, practice, go } = trainer;
  const setting = { drill, step: drill.steps[0]!, attempt: 0 };
  const name = drillName(drill);
  const source = sourceText(drill);
  root.append(
    h(
      "div",
      { class: "row" },
      button("all-drills", t("train.all"), () => go({ kind: "overview" })),
    ),
    heading(name),
    diagram(context.engine, setting, { label: t("train.diagram", { name }), enlarged: ENLARGED }),
    h("p", {}, goalText(setting)),
    h("p", { class: "hint" }, [tableText(drill), source].filter(Boolean).join(" ")),
    errorsChoice(trainer),
    h(
      "div",
      { class: "row" },
      button("play-drill", t("train.play"), () => practice.start(drill, chosen), true),
      button("table-drill", t("train.at-table"), () => practice.startAtTable(drill)),
    ),
    drillActions(trainer, drill),
    ...scoresOf(trainer, drill),
  );
}

/** The curves of the levels and of the player's own scores. */
export function scoresOf({ keeper }: Trainer, drill: Drill): HTMLElement[] {
  const best = bestOf(keeper.progress, drill.id);
  const scores = resultsOf(keeper.progress, drill.id).map(({ points }) => total(points));
  return [
    ...(levelScores(drill).length === 0
      ? []
      : [
          h("h2", {}, t("train.levels")),
          levelCurve(drill, best),
          h("p", { class: "hint" }, t("train.levels-hint")),
        ]),
    ...(best === null ? [] : [h("p", { class: "hint yours" }, t("train.yours", { score: best }))]),
    ...(best === null
      ? []
      : [
          h("h2", {}, t("train.history")),
          historyCurve(drill, scores) as unknown as HTMLElement,
          h("p", { class: "hint" }, t("train.history-of", { count: scores.length, best })),
        ]),
  ];
}

/** The list of levels whose errors the strikes can have. */
function errorsChoice({ context }: Trainer): HTMLElement {
  const levels = Object.keys(context.engine.noisePresets).filter((name) => name !== "olympiad");
  const select = h(
    "select",
    { id: "drill-errors" },
    h("option", { value: "" }, t("train.no-errors")),
    ...levels.map((level) => h("option", { value: level }, levelName(level))),
  );
  select.value = chosen ?? "";
  select.addEventListener("change", () => {
    chosen = select.value || null;
  });
  return h(
    "div",
    { class: "labelled" },
    h("label", { for: select.id }, t("train.errors")),
    select,
    h("p", { class: "hint" }, t("train.errors-hint")),
  );
}
