/** A drill's layout as a picture, from its data: the table lies, with its head string on the left. */

import type { Engine, PocketName, Point } from "../../engine/index.ts";
import { look } from "../../viewer/index.ts";
import { svg } from "../common/dom.ts";
import type { Area, Step } from "./drills/index.ts";
import { layoutOf, type Setting } from "./layout.ts";
import { type Cloth, clothOf, pointOf, type Region, regionOf } from "./places.ts";

/** Length of a numeral beside the diamonds, mm on the table. */
const NUMERAL = 95;

export interface DiagramOptions {
  /** What the picture shows, for screen readers; without it they skip the picture. */
  readonly label?: string;
  /** Size of the balls over their size on the table. Default 1: exact. */
  readonly enlarged?: number;
  /** Whether the diamonds are numbered, and the picture has its exact size, 1 : `scale`. */
  readonly scale?: number;
}

/** Lengths in mm on the table; the picture's x is along the table, its y across it. */
export function diagram(
  engine: Engine,
  setting: Setting,
  { label, enlarged = 1, scale }: DiagramOptions = {},
): SVGSVGElement {
  const { drill, step } = setting;
  const cloth = clothOf(engine, drill.table);
  const [width, length] = cloth.size.map((metres) => 1000 * metres) as [number, number];
  const rail = 1000 * (cloth.geometry.rail_width ?? 0.15);
  const margin = rail + (scale === undefined ? 0 : NUMERAL);
  const box = [-margin, -margin, length + 2 * margin, width + 2 * margin];
  const size =
    scale === undefined ? {} : { width: `${box[2]! / scale}mm`, height: `${box[3]! / scale}mm` };
  return svg(
    "svg",
    {
      class: "diagram",
      viewBox: box.map((number) => Math.round(number * 10) / 10).join(" "),
      ...size,
      ...(label === undefined ? { "aria-hidden": "true" } : { role: "img", "aria-label": label }),
    },
    svg("rect", {
      class: "diagram-frame",
      x: -rail,
      y: -rail,
      width: length + 2 * rail,
      height: width + 2 * rail,
      rx: 0.6 * rail,
    }),
    svg("rect", { class: "diagram-cloth", x: 0, y: 0, width: length, height: width }),
    ...cloth.geometry.pockets.map(({ center, radius }) =>
      svg("circle", { class: "diagram-pocket", ...middle(center), r: 1000 * radius }),
    ),
    ...goalPockets(step).map((name) => {
      const { center, radius } = cloth.geometry.pockets.find((pocket) => pocket.name === name)!;
      return svg("circle", { class: "diagram-goal", ...middle(center), r: 1000 * radius + 22 });
    }),
    ...diamonds(cloth, scale !== undefined),
    ...markings(cloth),
    ...areas(cloth, step),
    ...balls(engine, setting, enlarged),
  );
}

/** The middle of a circle, in the picture. */
function middle([x, y]: Point): { readonly cx: number; readonly cy: number } {
  return { cx: Math.round(1e4 * y) / 10, cy: Math.round(1e4 * x) / 10 };
}

/** The diamonds of the rails, or the numbers of their places on a table without them. */
function diamonds({ geometry, size, diamond }: Cloth, numbered: boolean): SVGElement[] {
  const [width, length] = [1000 * size[0], 1000 * size[1]];
  const setback = 1000 * (geometry.sights?.setback ?? (geometry.rail_width ?? 0.15) / 2);
  const beyond = 1000 * (geometry.rail_width ?? 0.15) + 0.55 * NUMERAL;
  const found: SVGElement[] = [];
  const mark = (x: number, y: number) => {
    if (!geometry.sights) return;
    found.push(svg("circle", { class: "diagram-sight", cx: x, cy: y, r: 9 }));
  };
  const number = (x: number, y: number, value: number) => {
    if (!numbered) return;
    const text = { class: "diagram-number", x, y, "font-size": NUMERAL };
    found.push(svg("text", { ...text, "text-anchor": "middle", dy: "0.36em" }, String(value)));
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
function markings({ geometry, size }: Cloth): SVGElement[] {
  const { head_string: line = null, d_radius: radius = null, spots = [] } = geometry.markings ?? {};
  const found: SVGElement[] = [];
  const at = (line ?? 0) * 1000;
  const stroke = { class: "diagram-marking" };
  if (line !== null) {
    found.push(svg("path", { ...stroke, d: `M${at} 0V${1000 * size[0]}` }));
  }
  if (radius !== null) {
    const [r, y] = [1000 * radius, 500 * size[0]];
    found.push(svg("path", { ...stroke, d: `M${at} ${y - r}A${r} ${r} 0 0 0 ${at} ${y + r}` }));
  }
  for (const { position } of spots) {
    found.push(svg("circle", { class: "diagram-spot", ...middle(position), r: 10 }));
  }
  return found;
}

/** The areas of a step: where the cue ball may lie, and where it should stop. */
function areas(cloth: Cloth, { balls, goal, hand }: Step): SVGElement[] {
  const zones = goal.kind === "shot" ? targetsOf(goal) : [];
  return [
    ...(hand && !isWhole(hand) ? [shape(regionOf(cloth, hand, balls), "diagram-hand")] : []),
    // The largest first, so that the smaller ones lie above it.
    ...[...zones]
      .reverse()
      .filter(({ area }) => !isWhole(area))
      .flatMap(({ area, points }) => {
        const region = regionOf(cloth, area, balls);
        return [shape(region, "diagram-zone"), ...(points === null ? [] : [worth(region, points)])];
      }),
  ];
}

/** The areas in which the cue ball should stop, the smallest first, with their points if they have any. */
export function targetsOf(
  goal: Extract<Step["goal"], { kind: "shot" }>,
): readonly { readonly area: Area; readonly points: number | null }[] {
  const stops = goal.needs.flatMap((need) =>
    need.kind === "stop" ? [{ area: need.area, points: null }] : [],
  );
  return [...stops, ...(goal.zones ?? [])];
}

/** Whether an area is the whole cloth, which needs no mark. */
export function isWhole(area: Area): boolean {
  return "from" in area && area.to[0] === 4 && area.to[1] === 8;
}

/** The pockets into which a ball must fall. */
export function goalPockets({ goal }: Step): readonly PocketName[] {
  const needs = goal.kind === "shot" ? goal.needs : [];
  return needs.flatMap((need) => (need.kind === "pot" && need.pocket ? [need.pocket] : []));
}

/** The points of a zone, at its upper edge. */
function worth(region: Region, points: number): SVGElement {
  const { cx, cy } = middle(
    region.kind === "box"
      ? [region.to[0] - 0.06, region.to[1] - 0.045]
      : [region.center[0] - region.radius + 0.065, region.center[1]],
  );
  const text = { class: "diagram-points", x: cx, y: cy, "font-size": 75 };
  return svg("text", { ...text, "text-anchor": "middle", dy: "0.36em" }, String(points));
}

function shape(region: Region, name: string): SVGElement {
  if (region.kind === "disc") {
    return svg("circle", { class: name, ...middle(region.center), r: 1000 * region.radius });
  }
  if (region.kind === "box") {
    const { cx: x, cy: y } = middle(region.from);
    const { cx: right, cy: bottom } = middle(region.to);
    return svg("rect", { class: name, x, y, width: right - x, height: bottom - y });
  }
  const { cx, cy } = middle(region.center);
  const r = 1000 * region.radius;
  return svg("path", { class: name, d: `M${cx} ${cy - r}A${r} ${r} 0 0 0 ${cx} ${cy + r}Z` });
}

function balls(engine: Engine, setting: Setting, enlarged: number): SVGElement[] {
  const cloth = clothOf(engine, setting.drill.table);
  const entries = setting.step.rack
    ? layoutOf(engine, setting).balls.map(({ id, position: [x, y] }) => ({
        id,
        at: [x, y] as Point,
      }))
    : Object.entries(setting.step.balls).map(([id, place]) => ({
        id,
        at: pointOf(cloth, place, setting.step.balls),
      }));
  const r = Math.round(1e4 * cloth.radius * (setting.step.rack ? 1 : enlarged)) / 10;
  return entries.flatMap(({ id, at }, index) => {
    const { body, striped } = look(id, index);
    const { cx, cy } = middle(at);
    const circle = svg("circle", {
      class: "diagram-ball",
      cx,
      cy,
      r,
      fill: body,
      ...(striped && { "data-striped": "true" }),
    });
    const text = { class: "diagram-id", x: cx, y: cy - r - 40, "font-size": 85 };
    const isNumber = /^\d+$/.test(id) && !setting.step.rack;
    return isNumber
      ? [circle, svg("text", { ...text, "text-anchor": "middle", dy: "0.3em" }, id)]
      : [circle];
  });
}
