/** Drawing with the keyboard, while the table has the focus: a cross moves, Enter sets the places of a mark. */

import type { Point } from "../../engine/index.ts";
import type { Context } from "../common/context.ts";
import { markBetween, marksOf } from "../document/marks.ts";
import type { Store } from "../document/store.ts";
import { t } from "../words/translate.ts";
import { changeOf, draw } from "./draw-changes.ts";
import { erase, putLabel } from "./draw-gesture.ts";
import { endDrawing } from "./draw-mode.ts";
import { snapPoints } from "./snap-points.ts";

/** Step of an arrow key, m; with Shift a tenth of it. */
const STEP = 0.02;

/** Directions of the arrow keys in the picture: right and down. */
const ARROWS: Readonly<Record<string, Point>> = {
  ArrowLeft: [-1, 0],
  ArrowRight: [1, 0],
  ArrowUp: [0, -1],
  ArrowDown: [0, 1],
};

export function mountDrawKeys(table: HTMLElement, store: Store, context: Context): void {
  let snap = -1;
  const put = (cursor: Point) => {
    const { drawing } = store.session;
    if (drawing) store.setSession({ drawing: { ...drawing, cursor } });
  };
  const act = (event: KeyboardEvent): boolean => {
    const arrow = ARROWS[event.key];
    if (arrow) {
      put(stepped(store, context, arrow, event.shiftKey ? STEP / 10 : STEP));
    } else if (event.key === "n" || event.key === "N") {
      const points = snapPoints(store);
      snap = (snap + (event.key === "n" ? 1 : -1) + points.length) % points.length;
      const point = points[snap]!;
      put(point.at);
      context.announce(point.name);
    } else if (event.key === "Enter") setPlace(store, context);
    else if (event.key === "Escape") {
      const { drawing } = store.session;
      if (drawing?.start) store.setSession({ drawing: { ...drawing, start: null } });
      else endDrawing(store);
    } else return false;
    return true;
  };
  table.addEventListener("keydown", (event) => {
    if (!store.session.drawing || event.ctrlKey || event.metaKey || event.altKey) return;
    if (!act(event)) return;
    event.preventDefault();
    event.stopPropagation();
  });
}

/** The cross after a step in the picture. */
function stepped(store: Store, { viewer }: Context, [right, down]: Point, step: number): Point {
  const [x, y] = cursorOf(store);
  // The axis of the table that points most in the wanted direction.
  const axes: readonly Point[] = [
    [1, 0],
    [-1, 0],
    [0, 1],
    [0, -1],
  ];
  const along = ([u, v]: Point) => {
    const seen = viewer.seen([x, y], [x + STEP * u, y + STEP * v]);
    return seen ? seen[0] * right + seen[1] * down : -Infinity;
  };
  const [u, v] = axes.reduce((best, one) => (along(one) > along(best) ? one : best));
  return [x + step * u, y + step * v];
}

/** The cross; at first it is in the middle of the table. */
function cursorOf({ session: { drawing }, shot: { geometry } }: Store): Point {
  const [width, length] = geometry.size ?? [1, 2];
  return drawing?.cursor ?? [width / 2, length / 2];
}

/** Enter: the first place of a mark, then the second; a label and the eraser have one. */
function setPlace(store: Store, context: Context): void {
  const { drawing } = store.session;
  if (!drawing) return;
  const at = cursorOf(store);
  const { tool, color, start } = drawing;
  if (tool === "label") {
    if (putLabel(store, at)) context.announce(t("draw.done"));
  } else if (tool === "erase") {
    if (erase(store, at)) context.announce(t("draw.erased"));
  } else if (!start) {
    store.setSession({ drawing: { ...drawing, cursor: at, start: at } });
    context.announce(t("draw.second-place"));
  } else {
    const mark = markBetween(tool, color, start, at);
    if (mark && draw(store, [...marksOf(store.document.shot), mark], changeOf(tool))) {
      store.setSession({ drawing: { ...drawing, start: null } });
      context.announce(t("draw.done"));
    }
  }
}

/** The mark whose second place is awaited, as it would be at the cross. */
export function awaitedMark({ session: { drawing } }: Store) {
  if (!drawing?.start || !drawing.cursor) return null;
  const { tool, color, start, cursor } = drawing;
  return tool === "label" || tool === "erase" ? null : markBetween(tool, color, start, cursor);
}
