/** Balls moved by hand: they stop at rails and at other balls, and leave the table for the tray. */

import type { Point } from "../../engine/index.ts";
import { bed } from "../../photo/index.ts";
import type { Context } from "../common/context.ts";
import { addBallAt, placeBall, type Placing } from "../document/layout-changes.ts";
import type { Store } from "../document/store.ts";
import { snapped } from "./ball-snap.ts";

/** Gap (m) at which a dragged ball goes onto a contact: a fifth of a ball's radius. */
const REACH = 0.006;

export interface Dragging extends Pick<Placing, "target"> {
  /** Whether the ball stays where the pointer is, for gaps of a millimetre. */
  readonly free?: boolean;
}

/** Moves a ball towards a place. Near a rail or another ball it goes exactly onto the contact. */
export function dragBall(
  store: Store,
  id: string,
  wanted: Point,
  group: string,
  { free = false, target }: Dragging = {},
): boolean {
  const place = placeOf(store, id, wanted, free);
  return placeBall(store, id, place, group, { exact: place !== wanted, target });
}

/** Puts a ball of the tray on the table. */
export function dropBall(store: Store, id: string, wanted: Point, group: string): boolean {
  return addBallAt(store, id, placeOf(store, id, wanted), group);
}

function placeOf(store: Store, id: string, wanted: Point, free = false): Point {
  const { geometry, balls } = store.shot;
  const radius = (balls.find((ball) => ball.id === id) ?? balls[0]!).radius;
  const others = balls.filter((ball) => ball.id !== id);
  // The rules of games place a ball in hand clear of the others.
  const touches = store.document.game === null;
  return snapped(wanted, bed(geometry, radius), others, free ? 0 : REACH, touches);
}

/** Whether a point is beyond the outer edge of the table. */
export function isBeside(store: Store, [x, y]: Point): boolean {
  const { size, rail_width: rail = 0 } = store.shot.geometry;
  if (!size) return false;
  return x < -rail || y < -rail || x > size[0] + rail || y > size[1] + rail;
}

/** The place (m) in the middle of the part of the table that no sheet covers; null above the horizon. */
export function middleInView({ viewer }: Pick<Context, "viewer">): Point | null {
  const [table, sheet] = ["table", "drawer"].map((id) =>
    document.getElementById(id)!.getBoundingClientRect(),
  ) as [DOMRect, DOMRect];
  const isCovered = sheet.height > 0 && sheet.left < table.right && sheet.top < table.bottom;
  const bottom = isCovered ? sheet.top : table.bottom;
  return viewer.pick((table.left + table.right) / 2, (table.top + bottom) / 2).point;
}
