/** Places and areas of drills, in metres on a table. */

import type { Engine, Geometry, Goal, GoalArea, GoalOf, Point } from "../../engine/index.ts";
import { toRadians } from "../common/angles.ts";
import type { Area, Diamonds, Place, Step } from "./drills/index.ts";

/** What places are computed from. */
export interface Cloth {
  readonly geometry: Geometry;
  readonly size: Point;
  /** Of a ball, m. */
  readonly radius: number;
  /** Width and height of a field of diamonds, m. */
  readonly diamond: Point;
}

const known = new Map<string, Cloth>();

/** The table of a preset, with its usual balls. */
export function clothOf(engine: Engine, table: string): Cloth {
  let cloth = known.get(table);
  if (!cloth) {
    const geometry = engine.tables.find(({ name }) => name === table)!;
    const [width, length] = geometry.size!;
    const balls = [{ id: "cue", position: [width / 2, length / 2] as const }];
    const shot = engine.shot({ format: "carom-shot/1", table, balls });
    const { radius } = shot.balls[0]!;
    shot.free();
    cloth = { geometry, size: [width, length], radius, diamond: [width / 4, length / 8] };
    known.set(table, cloth);
  }
  return cloth;
}

/** A place on the cloth, m. `balls` are the places of the layout, to which a place may refer. */
export function pointOf(cloth: Cloth, place: Place, balls: Step["balls"]): Point {
  if (isDiamonds(place)) return metres(cloth, place);
  if ("spot" in place) {
    const spot = cloth.geometry.markings?.spots.find(({ name }) => name === place.spot);
    if (!spot) throw new Error(`${cloth.geometry.name ?? "the table"} has no spot ${place.spot}`);
    return spot.position;
  }
  const { radius, size, diamond } = cloth;
  if ("rail" in place) {
    return [place.rail === "left" ? radius : size[0] - radius, place.y * diamond[1]];
  }
  const ball = pointOf(cloth, balls[place.ball]!, balls);
  const pocket = cloth.geometry.pockets.find(({ name }) => name === place.pocket)!;
  const toPocket = Math.atan2(pocket.center[1] - ball[1], pocket.center[0] - ball[0]);
  const ghost = beyond(ball, toPocket, -2 * radius);
  const aim = toPocket + toRadians(place.cut_deg ?? 0);
  return beyond(ghost, aim, -place.back * diamond[1]);
}

/** The point at a distance (m) from another in a direction (rad). */
function beyond([x, y]: Point, direction: number, distance: number): Point {
  return [x + distance * Math.cos(direction), y + distance * Math.sin(direction)];
}

function isDiamonds(place: Place): place is Diamonds {
  return Array.isArray(place);
}

function metres({ diamond }: Cloth, [x, y]: Diamonds): Point {
  return [x * diamond[0], y * diamond[1]];
}

/** An area on the cloth, in metres. */
export type Region =
  | { readonly kind: "disc"; readonly center: Point; readonly radius: number }
  | { readonly kind: "box"; readonly from: Point; readonly to: Point }
  | { readonly kind: "outline"; readonly corners: readonly Point[] }
  /** The half of a disc below its diameter. */
  | { readonly kind: "half-disc"; readonly center: Point; readonly radius: number };

export function regionOf(cloth: Cloth, area: Area, balls: Step["balls"]): Region {
  if ("center" in area) {
    const center = pointOf(cloth, area.center, balls);
    return { kind: "disc", center, radius: area.radius * cloth.diamond[1] };
  }
  if ("from" in area)
    return { kind: "box", from: metres(cloth, area.from), to: metres(cloth, area.to) };
  if ("outline" in area)
    return { kind: "outline", corners: area.outline.map((corner) => metres(cloth, corner)) };
  const { head_string: line, d_radius: radius } = cloth.geometry.markings!;
  return { kind: "half-disc", center: [cloth.size[0] / 2, line!], radius: radius! };
}

/** The goal of a step with its areas in metres, as the engine judges it. */
export function goalInMetres(cloth: Cloth, { goal, balls }: Step): Goal {
  return withAreas(goal, (area) => areaInMetres(cloth, area, balls));
}

/** A goal with its areas in another form. */
export function withAreas<A, B>(goal: GoalOf<A>, convert: (area: A) => B): GoalOf<B> {
  if (goal.kind === "run") return goal;
  const { zones, needs, ...rest } = goal;
  return {
    ...rest,
    needs: needs.map((need) =>
      need.kind === "stop" ? { ...need, area: convert(need.area) } : need,
    ),
    ...(zones && { zones: zones.map(({ area, points }) => ({ area: convert(area), points })) }),
  };
}

export function areaInMetres(cloth: Cloth, area: Area, balls: Step["balls"]): GoalArea {
  const region = regionOf(cloth, area, balls);
  switch (region.kind) {
    case "disc":
      return { center: region.center, radius: region.radius };
    case "box":
      return { from: region.from, to: region.to };
    case "outline":
      return { outline: region.corners };
    case "half-disc":
      return { marking: "d" };
  }
}
