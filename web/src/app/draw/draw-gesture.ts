/** Drawing with a mouse or a finger: a drag draws from one place to another, a tap puts a label or erases. */

import type { DrawnMark, Point } from "../../engine/index.ts";
import { round4 } from "../common/angles.ts";
import type { Context } from "../common/context.ts";
import { distanceTo, LONGEST_LABEL, markBetween, marksOf } from "../document/marks.ts";
import type { Store } from "../document/store.ts";
import { t } from "../words/translate.ts";
import { changeOf, draw } from "./draw-changes.ts";
import { snapAt, type SnapPoint, snapPoints } from "./snap-points.ts";

/** Pixels within which a place snaps, and a mark is erased. */
const SNAP = { mouse: 12, other: 22 };

/** Greatest distance (m) from a mark at which the keyboard erases it. */
const ERASE = 0.06;

interface Pointed {
  readonly clientX: number;
  readonly clientY: number;
  readonly pointerType: string;
}

/** A drag that draws. */
export interface DrawDrag {
  readonly first: Point;
  /** The marks before the drag. */
  readonly before: readonly DrawnMark[];
}

/** The place at a pointer, on a snap point near it; null above the horizon. */
export function placeAt(
  store: Store,
  { viewer }: Pick<Context, "viewer">,
  { clientX, clientY, pointerType }: Pointed,
): Pick<SnapPoint, "at"> | null {
  const reach = pointerType === "mouse" ? SNAP.mouse : SNAP.other;
  const project = (x: number, y: number, z: number) => viewer.project(x, y, z);
  const snap = snapAt([clientX, clientY], snapPoints(store), project, reach);
  if (snap) return snap;
  const { point } = viewer.pick(clientX, clientY, pointerType);
  return point && { at: point };
}

export function beginDraw(store: Store, context: Context, event: Pointed): DrawDrag | null {
  const place = placeAt(store, context, event);
  return place && { first: place.at, before: marksOf(store.document.shot) };
}

/** Shows the mark that a release would leave. @param group The drag is one step of the history. */
export function moveDraw(
  store: Store,
  context: Context,
  drag: DrawDrag,
  event: Pointed,
  group: string,
): void {
  const { drawing } = store.session;
  const place = placeAt(store, context, event);
  if (!drawing || !place || drawing.tool === "label" || drawing.tool === "erase") return;
  const mark = markBetween(drawing.tool, drawing.color, drag.first, place.at);
  if (mark) draw(store, [...drag.before, mark], changeOf(drawing.tool), group);
}

/** What a tap does: a label and the eraser need no drag. */
export function tapDraw(store: Store, context: Context, event: Pointed): void {
  const place = placeAt(store, context, event);
  const { drawing } = store.session;
  if (!place || !drawing) return;
  if (drawing.tool === "label") putLabel(store, place.at);
  else if (drawing.tool === "erase") eraseAt(store, context, event);
  else context.announce(t("draw.drag-hint"));
}

export function putLabel(store: Store, at: Point): boolean {
  const { drawing } = store.session;
  const text = drawing?.text.trim().slice(0, LONGEST_LABEL) ?? "";
  if (!drawing || text === "") {
    store.refuse(t("draw.no-text"));
    return false;
  }
  const place: Point = [round4(at[0]), round4(at[1])];
  const mark: DrawnMark = { kind: "label", color: drawing.color, at: place, text };
  return draw(store, [...marksOf(store.document.shot), mark], changeOf("label"));
}

/** Erases the mark nearest to a pointer. */
function eraseAt(store: Store, { viewer }: Context, event: Pointed): void {
  const { clientX, clientY, pointerType } = event;
  const { point } = viewer.pick(clientX, clientY, pointerType);
  const reach = pointerType === "mouse" ? SNAP.mouse : SNAP.other;
  const beside = viewer.pick(clientX + reach, clientY, pointerType).point;
  if (!point || !beside) return;
  erase(store, point, Math.hypot(beside[0] - point[0], beside[1] - point[1]));
}

/** Erases the mark nearest to a place, if there is one within `reach`, m. */
export function erase(store: Store, place: Point, reach = ERASE): boolean {
  const marks = marksOf(store.document.shot);
  const distances = marks.map((mark) => distanceTo(mark, place));
  const nearest = distances.indexOf(Math.min(...distances));
  if (nearest < 0 || distances[nearest]! > reach) {
    store.refuse(t("draw.nothing-here"));
    return false;
  }
  return draw(
    store,
    marks.filter((_, k) => k !== nearest),
    changeOf("erase"),
  );
}
