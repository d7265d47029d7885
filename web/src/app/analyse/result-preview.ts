/** Shows one result of the analysis on the table, until another one is shown or the document changes. */

import { type Child, h } from "../common/dom.ts";
import { CaromError, type DrawnMark, type Shot, type Trace } from "../../engine/index.ts";
import type { Area } from "../../viewer/index.ts";
import type { Store } from "../document/store.ts";

/** The trace that is shown; it is freed when another one takes its place. */
let shown: Trace | null = null;

/** Shows the simulation of `shot`, which is freed, with areas on the cloth. */
export function showShot(store: Store, shot: Shot, areas: readonly Area[]): void {
  try {
    replace(store, shot.simulate(), areas);
  } catch (error) {
    if (!(error instanceof CaromError)) throw error;
    replace(store, null, areas);
  } finally {
    shot.free();
  }
}

/** Shows areas on the cloth beside the aimed shot. */
export function showAreas(store: Store, areas: readonly Area[]): void {
  replace(store, null, areas);
}

/** Shows marks in place of the aimed shot. */
export function showMarks(store: Store, marks: readonly DrawnMark[]): void {
  replace(store, null, [], marks);
}

/** Shows the aimed shot alone. */
export function hidePreview(store: Store): void {
  if (store.session.analysis.preview) store.setPart("analysis", { preview: null });
  shown?.free();
  shown = null;
}

/** A button of a result: a press takes the result, and the table shows it while it is pointed at or has the focus. */
export function resultButton(
  store: Store,
  { take, show }: { take: () => void; show: () => void },
  ...children: Child[]
): HTMLButtonElement {
  const hide = () => hidePreview(store);
  const onclick = () => {
    hide();
    take();
  };
  const looks = { onpointerenter: show, onpointerleave: hide, onfocus: show, onblur: hide };
  return h("button", { type: "button", class: "line", onclick, ...looks }, ...children);
}

function replace(
  store: Store,
  trace: Trace | null,
  areas: readonly Area[],
  marks?: readonly DrawnMark[],
): void {
  const before = shown;
  shown = trace;
  store.setPart("analysis", { preview: { trace, areas, ...(marks && { marks }) } });
  before?.free();
}
