/**
 * Printing: the diagrams of the position, of all shots of the analysis, or of the chapters of the study that is open,
 * and never the interface.
 */

import "./print-diagram.css";
import type { Context } from "../common/context.ts";
import { h } from "../common/dom.ts";
import type { ShotFile, StudyFile } from "../../engine/index.ts";
import { markOf } from "../common/area-outline.ts";
import { areasOf } from "../document/lesson.ts";
import { marksOf } from "../document/marks.ts";
import type { Store } from "../document/store.ts";
import { t } from "../words/translate.ts";
import { paperDiagram } from "./paper-diagram.ts";

/** How diagrams are printed; kept while the page is open. */
export const printing = {
  paper: "a4" as "a4" | "letter",
  perPage: 1 as 1 | 2 | 4,
  /** Whether all shots of the analysis are printed, and not the present position alone. */
  all: false,
  /** Whether the tasks of a study are printed with their solutions. */
  solutions: false,
};

/** The diagram of the present shot; null on cloth without edges. */
export function presentDiagram(store: Store): SVGSVGElement | null {
  const trace = store.session.replay.trace ?? store.ghost.trace;
  const marks = marksOf(store.document.shot);
  return paperDiagram(trace?.shot ?? store.shot, trace, t("diagram.label"), marks);
}

/** Every print of the page prints diagrams, unless a part of the page prints a sheet of its own. */
export function mountPrint(store: Store, context: Context): void {
  let pages: HTMLElement | null = null;
  addEventListener("beforeprint", () => {
    if (document.body.dataset.printing !== undefined) return;
    pages = pagesOf(store, context);
    if (!pages) return;
    document.body.append(pages);
    document.body.dataset.printing = "diagram";
  });
  addEventListener("afterprint", () => {
    if (!pages) return;
    pages.remove();
    pages = null;
    delete document.body.dataset.printing;
  });
}

function pagesOf(store: Store, context: Context): HTMLElement | null {
  const { paper, perPage } = printing;
  const { lesson } = store.session;
  const ofTree = printing.all ? diagramsOfTree(store, context) : [];
  const diagrams = lesson ? diagramsOfStudy(lesson.study, context) : ofTree;
  const present = diagrams.length > 0 ? null : presentDiagram(store);
  const figures = present ? [h("figure", {}, present)] : diagrams;
  if (figures.length === 0) return null;
  const pages: HTMLElement[] = [];
  for (let k = 0; k < figures.length; k += perPage) {
    pages.push(h("div", { class: "print-page" }, ...figures.slice(k, k + perPage)));
  }
  // Two diagrams share an upright page; one or four lie on it.
  const page = `diagram-${paper}-${perPage === 2 ? "upright" : "lying"}`;
  return h(
    "section",
    { class: "print-diagrams", "data-page": page, "data-count": perPage },
    ...pages,
  );
}

/** The chapters of a study, each with its title and text. */
function diagramsOfStudy({ chapters, language: lang }: StudyFile, { engine }: Context) {
  return chapters.flatMap(({ title, text = "", shot: file, task }, index) => {
    const shown = printing.solutions ? (task?.solution ?? file.strike) : file.strike;
    const whole: ShotFile = { ...file, ...(shown && { strike: shown }) };
    const shot = engine.shot(whole);
    const trace = shown ? shot.simulate() : null;
    const drawn = [
      ...areasOf(task?.goal).map((area) => markOf(area, shot.geometry)),
      ...(file.marks ?? []),
    ];
    const picture = paperDiagram(shot, trace, title, drawn);
    trace?.free();
    shot.free();
    const heading = h("strong", {}, t("lesson.numbered", { number: index + 1, title }));
    const said = h("p", { class: "print-text" }, text);
    return picture ? [h("figure", { lang }, h("figcaption", {}, heading), picture, said)] : [];
  });
}

/** The shots of the analysis in their order, each with its number and comment. */
function diagramsOfTree(store: Store, { engine }: Context): HTMLElement[] {
  const nodes = store.document.tree?.nodes ?? [];
  return nodes.flatMap(({ shot: file, comment }, index) => {
    const shot = engine.shot(file);
    const trace = shot.simulate();
    const picture = paperDiagram(shot, trace, t("diagram.label"), file.marks);
    trace.free();
    shot.free();
    const text = t("diagram.caption", { number: index + 1, comment });
    return picture ? [h("figure", {}, h("figcaption", {}, text), picture)] : [];
  });
}
