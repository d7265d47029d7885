/** The part of the Share dialog with diagrams for paper. */

import { h, labelled, uniqueId } from "../common/dom.ts";
import { diagramFile, diagramPixels } from "../diagram/paper-diagram.ts";
import { presentDiagram, printing } from "../diagram/print-diagram.ts";
import type { Store } from "../document/store.ts";
import { t } from "../words/translate.ts";
import { download } from "./download.ts";

/** @param say Shows a sentence in the dialog. */
export function diagramSection(store: Store, say: (sentence: string) => void): HTMLElement {
  const draw = (save: (picture: SVGSVGElement) => void): void => {
    const picture = presentDiagram(store);
    if (picture) save(picture);
    else say(t("diagram.none"));
  };
  const button = (label: string, id: string, onclick: () => void) =>
    h("button", { type: "button", class: "button", id, onclick }, label);
  const choice = (values: Readonly<Record<string, string>>, set: (value: string) => void) => {
    const options = Object.entries(values).map(([value, label]) => h("option", { value }, label));
    const select = h("select", { id: uniqueId("diagram") }, ...options);
    select.addEventListener("change", () => set(select.value));
    return select;
  };
  const paper = choice({ a4: t("diagram.a4"), letter: t("diagram.letter") }, (value) => {
    printing.paper = value as typeof printing.paper;
  });
  const count = choice({ 1: "1", 2: "2", 4: "4" }, (value) => {
    printing.perPage = Number(value) as typeof printing.perPage;
  });
  const what = choice({ this: t("diagram.this"), all: t("diagram.all") }, (value) => {
    printing.all = value === "all";
  });
  const print = (): void => {
    // The dialog covers the page, and is not printed.
    document.querySelector<HTMLDialogElement>("#share-dialog")?.close();
    globalThis.print();
  };
  return h(
    "section",
    { id: "share-diagram" },
    h("h3", {}, t("diagram.heading")),
    h(
      "div",
      { class: "row" },
      button(t("diagram.svg"), "diagram-svg", () =>
        draw((picture) => download(diagramFile(picture), "carom.svg")),
      ),
      button(t("diagram.png"), "diagram-png", () =>
        draw(
          (picture) => void diagramPixels(picture).then((file) => download(file, "diagram.png")),
        ),
      ),
      button(t("diagram.print"), "diagram-print", print),
    ),
    labelled(t("diagram.what"), what),
    labelled(t("diagram.paper"), paper),
    labelled(t("diagram.per-page"), count),
  );
}
