/** A page for a real table, by the browser's print: drills with diagrams to scale, and boxes for attempts. */

import "./sheet.css";
import type { Engine } from "../../engine/index.ts";
import { h } from "../common/dom.ts";
import { t } from "../words/translate.ts";
import { diagram } from "./drill-diagram.ts";
import type { Drill } from "./drills/index.ts";
import { levelCurve } from "./score-curves.ts";
import { drillName, goalText, tableText } from "./train-words.ts";

/** Drills on a page. */
export const MOST_ON_SHEET = 6;

export type Paper = "a4" | "letter";

/** Scales 1 : n of the diagrams by the number of drills: one or two have the page's width. */
const SCALES: Readonly<Record<number, number>> = { 1: 25, 2: 40 };
const SMALL = 50;

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
      ...drills.map((drill) => drillOnSheet(engine, drill, scale)),
    ),
  );
}

function drillOnSheet(engine: Engine, drill: Drill, scale: number): HTMLElement {
  const setting = { drill, step: drill.steps[0]!, attempt: 0 };
  const label = t("train.diagram", { name: drillName(drill.id) });
  const boxes = Array.from({ length: drill.attempts }, (_, k) =>
    h("span", { class: "sheet-box" }, String(k + 1)),
  );
  return h(
    "article",
    { class: "sheet-drill" },
    h("h2", {}, drillName(drill.id)),
    h("p", { class: "sheet-table" }, `${tableText(drill)} ${t("sheet.scale", { scale })}`),
    diagram(engine, setting, { label, scale }),
    h("p", {}, goalText({ ...setting, drill: { ...drill, steps: [setting.step] } })),
    drill.steps.length > 1 && h("p", {}, t("sheet.steps", { steps: drill.steps.length })),
    h(
      "div",
      { class: "sheet-boxes" },
      ...boxes,
      h("span", { class: "sheet-box sheet-sum" }, t("sheet.sum")),
    ),
    scale < SMALL && levelCurve(drill, null),
  );
}

/** Prints a sheet on one page of the paper. The page looks the same afterwards. */
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
