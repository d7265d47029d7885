/** Where the numbers of a diagram stand: clear of its circles, lines, balls and other numbers. */

import { length } from "../common/length.ts";

/** A rectangle in the picture, mm on the table. */
export interface Box {
  readonly left: number;
  readonly top: number;
  readonly right: number;
  readonly bottom: number;
}

/** What a number must keep clear of; `stroke` is the width of the line around it or along it. */
export type Obstacle =
  | {
      readonly kind: "disc" | "rim";
      readonly cx: number;
      readonly cy: number;
      readonly r: number;
      readonly stroke: number;
    }
  /** A filled rectangle, or a line along an axis. */
  | { readonly kind: "box"; readonly box: Box; readonly stroke: number };

/**
 * Free space (mm on the table) around a number: 0.3 mm on a sheet at 1 : 50. With less, the number touches what
 * is beside it.
 */
export const FREE = 15;

/** Size of a digit over the size of its font, with room for wide fonts. */
const DIGIT_WIDTH = 0.7;
const DIGIT_HEIGHT = 0.74;

/** The rectangle that a number fills around its middle. */
export function numberBox(x: number, y: number, fontSize: number, digits: number): Box {
  const [width, height] = [DIGIT_WIDTH * fontSize * digits, DIGIT_HEIGHT * fontSize];
  return {
    left: x - width / 2,
    top: y - height / 2,
    right: x + width / 2,
    bottom: y + height / 2,
  };
}

/** The distance between a rectangle and an obstacle; not positive if they touch. */
export function clearance(box: Box, obstacle: Obstacle): number {
  const half = obstacle.stroke / 2;
  if (obstacle.kind === "box") {
    const { left, top, right, bottom } = obstacle.box;
    const [x, y] = [
      Math.max(left - box.right, box.left - right),
      Math.max(top - box.bottom, box.top - bottom),
    ];
    return (x > 0 && y > 0 ? length(x, y) : Math.max(x, y)) - half;
  }
  const { cx, cy, r } = obstacle;
  const [near, far] = [
    length(Math.max(box.left - cx, cx - box.right, 0), Math.max(box.top - cy, cy - box.bottom, 0)),
    length(
      Math.max(Math.abs(box.left - cx), Math.abs(box.right - cx)),
      Math.max(Math.abs(box.top - cy), Math.abs(box.bottom - cy)),
    ),
  ];
  return (obstacle.kind === "disc" ? near - r : Math.max(near - r, r - far)) - half;
}

/** The first of the places that is free; if none is, the one with the most space. */
export function freest<P extends { readonly box: Box }>(
  places: readonly P[],
  obstacles: readonly Obstacle[],
): P {
  const space = ({ box }: P) =>
    Math.min(...obstacles.map((obstacle) => clearance(box, obstacle)), FREE);
  return places.reduce((best, place) => (space(place) > space(best) ? place : best));
}
