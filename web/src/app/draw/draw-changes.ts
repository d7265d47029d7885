/** Changes of what is drawn on the table. */

import type { DrawnMark } from "../../engine/index.ts";
import { type DrawTool, MOST_MARKS, withMarks } from "../document/marks.ts";
import type { Store } from "../document/store.ts";
import { t } from "../words/translate.ts";

/** Draws marks in place of the present ones. @param group As for `Store.apply`. */
export function draw(
  store: Store,
  marks: readonly DrawnMark[],
  label: string,
  group: string | null = null,
): boolean {
  if (marks.length > MOST_MARKS) {
    store.refuse(t("draw.too-many", { most: MOST_MARKS }));
    return false;
  }
  return store.apply(({ shot }) => ({ shot: withMarks(shot, marks) }), label, group);
}

/** The name of a change for "Undo: …". */
export function changeOf(tool: DrawTool): string {
  return t(`change.draw-${tool}`);
}
