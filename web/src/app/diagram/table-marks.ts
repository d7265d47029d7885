/** The table of a diagram, in mm: x is along the table, y across it; and places for the numbers of balls. */

import type { Geometry, Point } from "../../engine/index.ts";
import { clothColor } from "../../viewer/index.ts";
import type { Box, Obstacle } from "./diagram-labels.ts";

/** A table with edges. */
export interface DrawnTable {
  readonly geometry: Geometry;
  readonly size: Point;
  /** Width and height of a field of diamonds, m. */
  readonly diamond: Point;
}

/** An element of the picture: its tag, its attributes, and the number that it shows. */
export type Mark = readonly [
  tag: "circle" | "rect" | "path" | "text",
  attributes: Readonly<Record<string, string | number>>,
  number?: string,
];

/** Length of a numeral beside the diamonds, mm on the table. */
export const NUMERAL = 95;

/** Size of the numbers of balls, mm on the table. */
export const BALL_NUMBER = 85;

/** Width of the lines of the markings in train.css, mm on the table. */
export const MARKING_LINE = 7;

/** Radius of a spot, mm on the table. */
const SPOT = 10;

/** The rails, the cloth and the pockets. */
export function bedMarks({ geometry, size }: DrawnTable): Mark[] {
  const [width, length] = [1000 * size[0], 1000 * size[1]];
  const rail = 1000 * (geometry.rail_width ?? 0.15);
  const frame = { x: -rail, y: -rail, width: length + 2 * rail, height: width + 2 * rail };
  const cloth = { x: 0, y: 0, width: length, height: width, fill: clothColor(geometry.physics) };
  return [
    ["rect", { class: "diagram-frame", ...frame, rx: 0.6 * rail }],
    ["rect", { class: "diagram-cloth", ...cloth }],
    ...geometry.pockets.map(({ center, radius }): Mark => [
      "circle",
      { class: "diagram-pocket", ...middle(center), r: 1000 * radius },
    ]),
  ];
}

/** The middle of a circle, in the picture. */
export function middle([x, y]: Point): { readonly cx: number; readonly cy: number } {
  return { cx: Math.round(1e4 * y) / 10, cy: Math.round(1e4 * x) / 10 };
}

/** The diamonds of the rails, or the numbers of their places on a table without them. */
export function diamonds({ geometry, size, diamond }: DrawnTable, numbered: boolean): Mark[] {
  const [width, length] = [1000 * size[0], 1000 * size[1]];
  const setback = 1000 * (geometry.sights?.setback ?? (geometry.rail_width ?? 0.15) / 2);
  const beyond = 1000 * (geometry.rail_width ?? 0.15) + 0.55 * NUMERAL;
  const found: Mark[] = [];
  const mark = (x: number, y: number) => {
    if (!geometry.sights) return;
    found.push(["circle", { class: "diagram-sight", cx: x, cy: y, r: 9 }]);
  };
  const number = (x: number, y: number, value: number) => {
    if (!numbered) return;
    found.push(numeral("diagram-number", [x, y], NUMERAL, String(value)));
  };
  for (let k = 0; k <= 8; k += 1) {
    const x = 1000 * diamond[1] * k;
    const isPocket = geometry.pockets.length > 0 && k % 4 === 0;
    const isEnd = k % 8 === 0;
    if (!isPocket && !isEnd) [-setback, width + setback].forEach((y) => mark(x, y));
    number(x, -beyond, k);
    number(x, width + beyond, k);
  }
  for (let k = 0; k <= 4; k += 1) {
    const y = 1000 * diamond[0] * k;
    if (k % 4 !== 0) [-setback, length + setback].forEach((x) => mark(x, y));
    number(-beyond, y, k);
    number(length + beyond, y, k);
  }
  return found;
}

/** Head string or baulk line, the D, and the spots. */
export function markings({ geometry, size }: DrawnTable): Mark[] {
  const { head_string: line = null, d_radius: radius = null, spots = [] } = geometry.markings ?? {};
  const found: Mark[] = [];
  const at = (line ?? 0) * 1000;
  const stroke = { class: "diagram-marking" };
  if (line !== null) {
    found.push(["path", { ...stroke, d: `M${at} 0V${1000 * size[0]}` }]);
  }
  if (radius !== null) {
    const [r, y] = [1000 * radius, 500 * size[0]];
    found.push(["path", { ...stroke, d: `M${at} ${y - r}A${r} ${r} 0 0 0 ${at} ${y + r}` }]);
  }
  for (const { position } of spots) {
    found.push(["circle", { class: "diagram-spot", ...middle(position), r: SPOT }]);
  }
  return found;
}

/** Head string, D and spots as obstacles. */
export function lines({ geometry, size }: DrawnTable): readonly Obstacle[] {
  const { head_string: line = null, d_radius: radius = null, spots = [] } = geometry.markings ?? {};
  const x = 1000 * (line ?? 0);
  const box = { left: x, top: 0, right: x, bottom: 1000 * size[0] };
  const d = { cx: x, cy: 500 * size[0], r: 1000 * (radius ?? 0) };
  return [
    ...(line === null ? [] : [{ kind: "box", box, stroke: MARKING_LINE } as const]),
    ...(radius === null ? [] : [{ kind: "rim", ...d, stroke: MARKING_LINE } as const]),
    ...spots.map(
      ({ position }) => ({ kind: "disc", ...middle(position), r: SPOT, stroke: 0 }) as const,
    ),
  ];
}

/** The four sides of a rectangle as lines. */
export function edgesOf(box: Box, stroke: number): readonly Obstacle[] {
  const { left, top, right, bottom } = box;
  return [
    { ...box, right: left },
    { ...box, left: right },
    { ...box, bottom: top },
    { ...box, top: bottom },
  ].map((side) => ({ kind: "box", box: side, stroke }));
}

/** Number of directions in which a free place is searched. */
export const DIRECTIONS = 24;

/** Distances of the middle of a number from the edge of its ball, mm on the table. */
const AWAY = [55, 70, 85, 100, 120, 140];

/** Places around a ball: above it, then to the sides, then farther away. */
export function placesAround({
  cx,
  cy,
  r,
}: {
  cx: number;
  cy: number;
  r: number;
}): readonly Point[] {
  return AWAY.flatMap((away) => turned((x, y) => [cx + (r + away) * x, cy + (r + away) * y]));
}

/** A point for every direction: first upwards, then to both sides in turn. */
export function turned(at: (x: number, y: number) => Point): readonly Point[] {
  return Array.from({ length: DIRECTIONS }, (_, k) => {
    const angle = (Math.PI * (k % 2 === 0 ? k : -(k + 1))) / DIRECTIONS;
    return at(Math.sin(angle), -Math.cos(angle));
  });
}

/** A number with its middle at a point. */
export function numeral(name: string, [x, y]: Point, size: number, text: string): Mark {
  const attributes = { class: name, x: tenth(x), y: tenth(y), "font-size": size };
  return ["text", { ...attributes, "text-anchor": "middle", dy: "0.36em" }, text];
}

/** A length of a picture, rounded to 0.1 mm on the table. */
export function tenth(length: number): number {
  return Math.round(10 * length) / 10;
}
