/** What the picture of a drill's layout consists of, in mm on the table: x is along the table, y across it. */

import type { Engine, PocketName, Point } from "../../engine/index.ts";
import { look } from "../../viewer/index.ts";
import type { Area, Step } from "./drills/index.ts";
import { type Box, freest, numberBox, type Obstacle } from "../diagram/diagram-labels.ts";
import {
  BALL_NUMBER,
  bedMarks,
  diamonds,
  DIRECTIONS,
  edgesOf,
  lines,
  type Mark,
  markings,
  middle,
  numeral,
  placesAround,
  turned,
} from "../diagram/table-marks.ts";
import { layoutOf, type Setting } from "./drill-layout.ts";
import { type Cloth, clothOf, pointOf, type Region, regionOf } from "./drill-places.ts";

/** Size of the numbers of areas, mm on the table. */
const POINTS = 75;

/** Widths of lines in train.css, and the distance of a pocket from the ring around it, mm on the table. */
const AREA_LINE = 9;
const BALL_LINE = 5;
const GOAL_LINE = 26;
const GOAL = 22;

/** Everything in the picture, from the lowest to the highest. */
export function marksOf(
  engine: Engine,
  setting: Setting,
  { enlarged, numbered }: { readonly enlarged: number; readonly numbered: boolean },
): readonly Mark[] {
  const { drill, step } = setting;
  const cloth = clothOf(engine, drill.table);
  const [width, length] = cloth.size.map((metres) => 1000 * metres) as [number, number];
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
    ...bedMarks(cloth),
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
  if (region.kind === "outline") {
    const corners = region.corners.map((corner) => middle(corner));
    return [
      "path",
      { class: name, d: `M${corners.map(({ cx, cy }) => `${cx} ${cy}`).join("L")}Z` },
    ];
  }
  const { cx, cy } = middle(region.center);
  const r = 1000 * region.radius;
  return ["path", { class: name, d: `M${cx} ${cy - r}A${r} ${r} 0 0 0 ${cx} ${cy + r}Z` }];
}

/** The line around an area. */
function outlineOf(region: Region): readonly Obstacle[] {
  if (region.kind === "box") return edgesOf(boxOf(region), AREA_LINE);
  if (region.kind === "outline") {
    return region.corners.map((corner, k) => {
      const [a, b] = [middle(corner), middle(region.corners.at(k - 1)!)];
      const [left, right] = [Math.min(a.cx, b.cx), Math.max(a.cx, b.cx)];
      const [top, bottom] = [Math.min(a.cy, b.cy), Math.max(a.cy, b.cy)];
      return { kind: "box", box: { left, top, right, bottom }, stroke: AREA_LINE };
    });
  }
  // A half disc counts as a whole one.
  const r = 1000 * region.radius;
  return [{ kind: "rim", ...middle(region.center), r, stroke: AREA_LINE }];
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
  if (region.kind === "outline") {
    // Between each corner and the middle of all.
    const corners = region.corners.map((corner) => middle(corner));
    const mean = (of: (corner: (typeof corners)[number]) => number) =>
      corners.reduce((sum, corner) => sum + of(corner), 0) / corners.length;
    const [x, y] = [mean(({ cx }) => cx), mean(({ cy }) => cy)];
    return [[x, y], ...corners.map(({ cx, cy }): Point => [(cx + x) / 2, (cy + y) / 2])];
  }
  const { cx, cy } = middle(region.center);
  return turned((x, y) => {
    const r = 1000 * region.radius - INSET;
    return [cx + r * x, cy + r * y];
  });
}
