/** Where the cue ball stops after a recommendation: an ellipse on the cloth, and a small picture of the table. */

import type { BallInfo, Geometry, Point, Recommendation } from "../../engine/index.ts";
import { clothColor, look } from "../../viewer/index.ts";
import { svg } from "../common/dom.ts";

/** Semi-axes of the ellipse in standard deviations: two thirds of the variants stop within it. */
const TWO_THIRDS = Math.sqrt(2 * Math.log(3));

/** Fewest places that have an ellipse. */
const FEWEST = 5;

/** Corners of the polygon that is drawn for an ellipse. */
const CORNERS = 40;

/** Rail around the cloth of the small picture, and radius of its balls, m. */
const MARGIN = 0.06;
const DOT = 0.045;

/** Smallest semi-axis that is drawn, m: a ball's radius. */
const LEAST = 0.028;

/** The ellipse in which the cue ball stops in two thirds of the variants; null if it is not known. */
export function ellipseOf({ leave }: Recommendation): Point[] | null {
  const [x, y] = leave.mean;
  const [[xx, xy], [, yy]] = leave.covariance as readonly [
    readonly [number | null, number | null],
    readonly [number | null, number | null],
  ];
  if (x === null || xx === null || xy === null || yy === null) return null;
  return ellipse([x, y], [xx, xy, yy]);
}

/** The ellipse with two thirds of some places; null if there are too few. */
export function ellipseAround(places: readonly Point[]): Point[] | null {
  const n = places.length;
  if (n < FEWEST) return null;
  const sum = (value: (place: Point) => number) => places.reduce((total, p) => total + value(p), 0);
  const [x, y] = [sum((p) => p[0]) / n, sum((p) => p[1]) / n];
  const mean = (value: (dx: number, dy: number) => number) =>
    sum((p) => value(p[0] - x, p[1] - y)) / (n - 1);
  return ellipse([x, y], [mean((u) => u * u), mean((u, v) => u * v), mean((_, v) => v * v)]);
}

/** The ellipse of a normal distribution that has two thirds of it: mean (m), and variances and covariance (m²). */
export function ellipse([x, y]: Point, [xx, xy, yy]: readonly [number, number, number]): Point[] {
  const turn = 0.5 * Math.atan2(2 * xy, xx - yy);
  const middle = (xx + yy) / 2;
  const away = Math.hypot((xx - yy) / 2, xy);
  const axis = (variance: number) => Math.max(LEAST, TWO_THIRDS * Math.sqrt(Math.max(0, variance)));
  const [long, short] = [axis(middle + away), axis(middle - away)];
  const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
  return Array.from({ length: CORNERS }, (_, k) => {
    const angle = (2 * Math.PI * k) / CORNERS;
    const [u, v] = [long * Math.cos(angle), short * Math.sin(angle)];
    return [x + u * cos - v * sin, y + u * sin + v * cos] as const;
  });
}

/**
 * The table with its balls and the ellipse of a recommendation, as it lies or stands on the screen. Screen readers skip
 * it.
 *
 * @param isLying Whether the length of the table is across the screen.
 */
export function leavePicture(
  { size, pockets, physics }: Geometry,
  balls: readonly BallInfo[],
  cueBall: string,
  recommendation: Recommendation,
  isLying: boolean,
): SVGSVGElement | null {
  if (!size) return null;
  const [width, length] = size;
  const across = (isLying ? length : width) + 2 * MARGIN;
  const down = (isLying ? width : length) + 2 * MARGIN;
  // A lying table is turned clockwise: its bottom left corner is at the top left of the screen.
  const at = ([x, y]: readonly number[]): readonly [number, number] =>
    isLying ? [y!, x!] : [x!, length - y!];
  const points = (ellipseOf(recommendation) ?? []).map((point) =>
    at(point)
      .map((v) => v.toFixed(3))
      .join(),
  );
  const potted = balls.find(({ id }) => id === recommendation.ball);
  const pocket =
    recommendation.kind === "direct" && pockets.find(({ name }) => name === recommendation.pocket);
  const [from, to] = potted && pocket ? [at(potted.position), at(pocket.center)] : [];
  const others = balls.filter(({ id }) => id !== cueBall);
  return svg(
    "svg",
    { class: "leave", viewBox: [-MARGIN, -MARGIN, across, down].join(" "), "aria-hidden": "true" },
    svg("rect", {
      class: "cloth",
      fill: clothColor(physics),
      x: -MARGIN,
      y: -MARGIN,
      width: across,
      height: down,
      rx: MARGIN,
    }),
    from && to
      ? svg("line", { class: "way", x1: from[0], y1: from[1], x2: to[0], y2: to[1] })
      : null,
    points.length === 0 ? null : svg("polygon", { class: "stop", points: points.join(" ") }),
    ...others.map(({ id, position }, index) => {
      const [cx, cy] = at(position);
      return svg("circle", { cx, cy, r: DOT, fill: look(id, index).body });
    }),
  );
}
