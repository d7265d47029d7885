/** What the picture of a drill's layout consists of, in mm on the table: x is along the table, y across it. */

import type { Engine, PocketName, Point } from "../../engine/index.ts";
import { clothColor, look } from "../../viewer/index.ts";
import type { Area, Step } from "./drills/index.ts";
import { type Box, freest, numberBox, type Obstacle } from "./diagram-labels.ts";
import { layoutOf, type Setting } from "./drill-layout.ts";
import { type Cloth, clothOf, pointOf, type Region, regionOf } from "./drill-places.ts";

/** An element of the picture: its tag, its attributes, and the number that it shows. */
export type Mark = readonly [
  tag: "circle" | "rect" | "path" | "text",
  attributes: Readonly<Record<string, string | number>>,
  number?: string,
];

/** Length of a numeral beside the diamonds, mm on the table. */
export const NUMERAL = 95;

/** Size of the numbers of balls and areas, mm on the table. */
const BALL_NUMBER = 85;
const POINTS = 75;

/** Widths of lines in train.css, and the distance of a pocket from the ring around it, mm on the table. */
const AREA_LINE = 9;
const BALL_LINE = 5;
const MARKING_LINE = 7;
const GOAL_LINE = 26;
const GOAL = 22;

/** Radius of a spot, mm on the table. */
const SPOT = 10;

/** Everything in the picture, from the lowest to the highest. */
export function marksOf(
  engine: Engine,
  setting: Setting,
  { enlarged, numbered }: { readonly enlarged: number; readonly numbered: boolean },
): readonly Mark[] {
  const { drill, step } = setting;
  const cloth = clothOf(engine, drill.table);
  const [width, length] = cloth.size.map((metres) => 1000 * metres) as [number, number];
  const rail = 1000 * (cloth.geometry.rail_width ?? 0.15);
  const goals = goalPockets(step);
  const found = areas(cloth, step);
  const shown = balls(engine, setting, enlarged);
  const obstacles: Obstacle[] = [
    // Numbers stand on the cloth.
    ...edgesOf({ left: 0, top: 0, right: length, bottom: width }, 0),
    ...cloth.geometry.pockets.map(({ center, radius }): Obstacle => {
      const r = 1000 * radius + (goals.length > 0 ? GOAL : 0);
      return { kind: "disc", ...middle(center), r, stroke: GOAL_LINE };
    }),
    ...lines(cloth),
    ...found.flatMap(({ region }) => outlineOf(region)),
    ...shown.map(({ cx, cy, r }): Obstacle => ({ kind: "disc", cx, cy, r, stroke: BALL_LINE })),
  ];
  return [
    [
      "rect",
      {
        class: "diagram-frame",
        x: -rail,
        y: -rail,
        width: length + 2 * rail,
        height: width + 2 * rail,
        rx: 0.6 * rail,
      },
    ],
    [
      "rect",
      {
        class: "diagram-cloth",
        fill: clothColor(cloth.geometry.physics),
        x: 0,
        y: 0,
        width: length,
        height: width,
      },
    ],
    ...cloth.geometry.pockets.map(({ center, radius }): Mark => [
      "circle",
      { class: "diagram-pocket", ...middle(center), r: 1000 * radius },
    ]),
    ...goals.map((name): Mark => {
      const { center, radius } = cloth.geometry.pockets.find((pocket) => pocket.name === name)!;
      return ["circle", { class: "diagram-goal", ...middle(center), r: 1000 * radius + GOAL }];
    }),
    ...diamonds(cloth, numbered),
    ...markings(cloth),
    ...found.map(({ region, name }) => shape(region, name)),
    ...shown.map(({ mark }) => mark),
    ...numbers(found, shown, obstacles),
  ];
}

/** The middle of a circle, in the picture. */
function middle([x, y]: Point): { readonly cx: number; readonly cy: number } {
  return { cx: Math.round(1e4 * y) / 10, cy: Math.round(1e4 * x) / 10 };
}

/** The diamonds of the rails, or the numbers of their places on a table without them. */
function diamonds({ geometry, size, diamond }: Cloth, numbered: boolean): Mark[] {
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
function markings({ geometry, size }: Cloth): Mark[] {
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

/** An area as the picture shows it; `points` is null if it has none. */
interface Shown {
  readonly region: Region;
  readonly name: "diagram-hand" | "diagram-zone";
  readonly points: number | null;
}

/** The areas of a step: where the cue ball may lie, and where it should stop. */
function areas(cloth: Cloth, { balls, goal, hand }: Step): Shown[] {
  const zones = goal.kind === "shot" ? targetsOf(goal) : [];
  const region = (area: Area) => regionOf(cloth, area, balls);
  return [
    ...(hand && !isWhole(hand)
      ? [{ region: region(hand), name: "diagram-hand", points: null } as const]
      : []),
    // The largest first, so that the smaller ones lie above it.
    ...[...zones]
      .reverse()
      .filter(({ area }) => !isWhole(area))
      .map(({ area, points }) => ({ region: region(area), name: "diagram-zone", points }) as const),
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

/** A rectangular area in the picture. */
function boxOf({ from, to }: Extract<Region, { kind: "box" }>): Box {
  const [{ cx: left, cy: top }, { cx: right, cy: bottom }] = [middle(from), middle(to)];
  return { left, top, right, bottom };
}

function shape(region: Region, name: string): Mark {
  if (region.kind === "disc") {
    return ["circle", { class: name, ...middle(region.center), r: 1000 * region.radius }];
  }
  if (region.kind === "box") {
    const { left: x, top: y, right, bottom } = boxOf(region);
    return ["rect", { class: name, x, y, width: right - x, height: bottom - y }];
  }
  const { cx, cy } = middle(region.center);
  const r = 1000 * region.radius;
  return ["path", { class: name, d: `M${cx} ${cy - r}A${r} ${r} 0 0 0 ${cx} ${cy + r}Z` }];
}

/** The line around an area. */
function outlineOf(region: Region): readonly Obstacle[] {
  if (region.kind === "box") return edgesOf(boxOf(region), AREA_LINE);
  // A half disc counts as a whole one.
  const r = 1000 * region.radius;
  return [{ kind: "rim", ...middle(region.center), r, stroke: AREA_LINE }];
}

/** Head string, D and spots as obstacles. */
function lines({ geometry, size }: Cloth): readonly Obstacle[] {
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
function edgesOf(box: Box, stroke: number): readonly Obstacle[] {
  const { left, top, right, bottom } = box;
  return [
    { ...box, right: left },
    { ...box, left: right },
    { ...box, bottom: top },
    { ...box, top: bottom },
  ].map((side) => ({ kind: "box", box: side, stroke }));
}

/** A ball as the picture shows it; `number` is null if it has none. */
interface ShownBall {
  readonly cx: number;
  readonly cy: number;
  readonly r: number;
  readonly number: string | null;
  readonly mark: Mark;
}

function balls(engine: Engine, setting: Setting, enlarged: number): ShownBall[] {
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
  return entries.map(({ id, at }, index) => {
    const { body, striped } = look(id, index);
    const { cx, cy } = middle(at);
    const looks = { fill: body, ...(striped && { "data-striped": "true" }) };
    const mark: Mark = ["circle", { class: "diagram-ball", cx, cy, r, ...looks }];
    const number = /^\d+$/.test(id) && !setting.step.rack ? id : null;
    return { cx, cy, r, number, mark };
  });
}

/** The points of the areas and the numbers of the balls, each at a free place. */
function numbers(
  areas: readonly Shown[],
  balls: readonly ShownBall[],
  obstacles: readonly Obstacle[],
): readonly Mark[] {
  const taken = [...obstacles];
  const put = (name: string, size: number, text: string, places: readonly Point[]): Mark => {
    const found = freest(
      places.map((at) => ({ at, box: numberBox(...at, size, text.length) })),
      taken,
    );
    taken.push({ kind: "box", box: found.box, stroke: 0 });
    return numeral(name, found.at, size, text);
  };
  return [
    ...areas.flatMap(({ region, points }) =>
      points === null ? [] : [put("diagram-points", POINTS, String(points), placesIn(region))],
    ),
    ...balls.flatMap(({ number, ...ball }) =>
      number === null ? [] : [put("diagram-id", BALL_NUMBER, number, placesAround(ball))],
    ),
  ];
}

/** Distance of the points of an area from its line, mm on the table. */
const INSET = 62;

/** Places along the line around an area, inside it, from the upper edge on. */
function placesIn(region: Region): readonly Point[] {
  if (region.kind === "box") {
    const { top, right, bottom } = boxOf(region);
    const x = right - INSET;
    const room = bottom - top - 2 * INSET;
    return Array.from({ length: DIRECTIONS }, (_, k) => [x, top + INSET + (room * k) / DIRECTIONS]);
  }
  const { cx, cy } = middle(region.center);
  return turned((x, y) => {
    const r = 1000 * region.radius - INSET;
    return [cx + r * x, cy + r * y];
  });
}

/** Number of directions in which a free place is searched. */
const DIRECTIONS = 24;

/** Distances of the middle of a number from the edge of its ball, mm on the table. */
const AWAY = [55, 70, 85, 100, 120, 140];

/** Places around a ball: above it, then to the sides, then farther away. */
function placesAround({ cx, cy, r }: Omit<ShownBall, "number">): readonly Point[] {
  return AWAY.flatMap((away) => turned((x, y) => [cx + (r + away) * x, cy + (r + away) * y]));
}

/** A point for every direction: first upwards, then to both sides in turn. */
function turned(at: (x: number, y: number) => Point): readonly Point[] {
  return Array.from({ length: DIRECTIONS }, (_, k) => {
    const angle = (Math.PI * (k % 2 === 0 ? k : -(k + 1))) / DIRECTIONS;
    return at(Math.sin(angle), -Math.cos(angle));
  });
}

/** A number with its middle at a point. */
function numeral(name: string, [x, y]: Point, size: number, text: string): Mark {
  const round = (number: number) => Math.round(10 * number) / 10;
  const attributes = { class: name, x: round(x), y: round(y), "font-size": size };
  return ["text", { ...attributes, "text-anchor": "middle", dy: "0.36em" }, text];
}
