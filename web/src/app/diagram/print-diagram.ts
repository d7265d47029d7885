/** Printing: the diagrams of the position, or of all shots of the analysis, and never the interface. */

import "./print-diagram.css";
import type { Context } from "../common/context.ts";
import { h } from "../common/dom.ts";
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
  const diagrams = printing.all ? diagramsOfTree(store, context) : [];
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
