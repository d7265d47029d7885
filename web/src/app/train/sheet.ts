/** Pages for a real table, by the browser's print: drills with a diagram to scale of every step, and boxes for attempts. */

import "./sheet.css";
import type { Engine } from "../../engine/index.ts";
import { h } from "../common/dom.ts";
import { paragraph, sentence, t } from "../words/translate.ts";
import { diagram } from "./drill-diagram.ts";
import type { Drill, Step } from "./drills/index.ts";
import { needsText } from "./goal-words.ts";
import { levelCurve } from "./score-curves.ts";
import { drillName, goalText, tableText } from "./train-words.ts";

/** Drills on a sheet. */
export const MOST_ON_SHEET = 6;

export type Paper = "a4" | "letter";

/** Scales 1 : n of the diagrams by the number of drills: one or two have the page's width. */
const SCALES: Readonly<Record<number, number>> = { 1: 25, 2: 40 };
const SMALL = 50;
/** The largest scale of a drill with several steps, which stand beside each other. */
const STEPS = 40;

/** @param drills At most `MOST_ON_SHEET`. */
export function sheetOf(engine: Engine, drills: readonly Drill[]): HTMLElement {
  const scale = SCALES[drills.length] ?? SMALL;
  const line = (label: string) =>
    h("span", { class: "sheet-line" }, label, h("span", { class: "sheet-rule" }));
  return h(
    "section",
    { class: "sheet", "data-large": scale < SMALL },
    h("header", {}, h("h1", {}, t("train.drills")), line(t("sheet.name")), line(t("sheet.date"))),
    h(
      "div",
      { class: "sheet-drills" },
      ...drills.map((drill) =>
        drillOnSheet(engine, drill, drill.steps.length > 1 ? Math.max(scale, STEPS) : scale),
      ),
    ),
  );
}

function drillOnSheet(engine: Engine, drill: Drill, scale: number): HTMLElement {
  const { steps } = drill;
  const boxes = Array.from({ length: drill.attempts }, (_, k) =>
    h("span", { class: "sheet-box" }, String(k + 1)),
  );
  return h(
    "article",
    { class: "sheet-drill", "data-steps": steps.length > 1 },
    h("h2", {}, drillName(drill)),
    h("p", { class: "sheet-table" }, `${tableText(drill)} ${t("sheet.scale", { scale })}`),
    h("p", {}, goalText({ drill: { ...drill, steps: [steps[0]!] }, step: steps[0]!, attempt: 0 })),
    h(
      "div",
      { class: "sheet-steps" },
      ...steps.map((step) => stepOnSheet(engine, drill, step, scale)),
    ),
    h(
      "div",
      { class: "sheet-boxes" },
      ...boxes,
      h("span", { class: "sheet-box sheet-sum" }, t("sheet.sum")),
    ),
    scale < SMALL && levelCurve(drill, null),
  );
}

/** The diagram of a step, with its number if there are several. */
function stepOnSheet(engine: Engine, drill: Drill, step: Step, scale: number): HTMLElement {
  const { steps, order, name } = drill;
  const number = steps.indexOf(step) + 1;
  const label = t("train.diagram", { name: drillName(drill) });
  // The goals of a built-in drill differ by what the diagram shows, those of a user in any way.
  const goal = name !== undefined && order !== "same" && number > 1 ? needsText(step) : "";
  return h(
    "figure",
    {},
    diagram(engine, { drill, step, attempt: 0 }, { label, scale }),
    steps.length > 1 &&
      h(
        "figcaption",
        {},
        paragraph([sentence(t("train.step", { step: number, steps: steps.length })), goal]),
      ),
  );
}

/** Prints a sheet on the paper. The page looks the same afterwards. */
export function printSheet(sheet: HTMLElement, paper: Paper): void {
  sheet.dataset.paper = paper;
  document.body.append(sheet);
  document.body.dataset.printing = "sheet";
  addEventListener(
    "afterprint",
    () => {
      sheet.remove();
      delete document.body.dataset.printing;
    },
    { once: true },
  );
  print();
}
