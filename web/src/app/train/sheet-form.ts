/** The choice of drills for a printed sheet. */

import { h } from "../common/dom.ts";
import { t } from "../words/translate.ts";
import { DRILLS } from "./drills/index.ts";
import { ownDrills } from "./own/own-drills.ts";
import { button, heading, type Trainer } from "./train-parts.ts";
import { MOST_ON_SHEET, type Paper, printSheet, sheetOf } from "./sheet.ts";
import { drillName } from "./train-words.ts";

/** Kept while the page is open. */
const chosen = new Set<string>(["stop", "follow", "draw", "cuts"]);
let paper: Paper = "a4";

export function mountSheetForm(root: HTMLElement, { store, context, keeper, go }: Trainer): void {
  const all = [...ownDrills({ context, keeper }), ...DRILLS];
  const boxes = all.map((drill) => {
    const { id } = drill;
    const box = h("input", {
      type: "checkbox",
      id: `sheet-${id.replace(/\s/g, "-")}`,
      checked: chosen.has(id),
    });
    box.addEventListener("change", () => {
      if (box.checked && chosen.size === MOST_ON_SHEET) {
        box.checked = false;
        store.refuse(t("sheet.full"));
      } else if (box.checked) chosen.add(id);
      else chosen.delete(id);
    });
    return h("label", {}, box, drillName(drill));
  });
  const papers = h(
    "select",
    { id: "sheet-paper" },
    h("option", { value: "a4" }, t("sheet.a4")),
    h("option", { value: "letter" }, t("sheet.letter")),
  );
  papers.value = paper;
  papers.addEventListener("change", () => {
    paper = papers.value as Paper;
  });
  const print = () => {
    const drills = all.filter(({ id }) => chosen.has(id));
    if (drills.length === 0) store.refuse(t("sheet.none"));
    else printSheet(sheetOf(context.engine, drills), paper);
  };
  root.append(
    h(
      "div",
      { class: "row" },
      button("all-drills", t("train.all"), () => go({ kind: "overview" })),
    ),
    heading(t("sheet.title")),
    h("p", { class: "hint" }, t("sheet.intro")),
    h("fieldset", { class: "sheet-choice" }, h("legend", {}, t("sheet.choose")), ...boxes),
    h("div", { class: "labelled" }, h("label", { for: papers.id }, t("sheet.paper")), papers),
    h("div", { class: "row end pinned" }, button("print-sheet", t("sheet.print"), print, true)),
  );
}
