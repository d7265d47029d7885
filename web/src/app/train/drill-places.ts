/** Places and areas of drills, in metres on a table. */

import type { Engine, Geometry, Point } from "../../engine/index.ts";
import { toRadians } from "../common/angles.ts";
import { length } from "../common/length.ts";
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
  /** The half of a disc below its diameter. */
  | { readonly kind: "half-disc"; readonly center: Point; readonly radius: number };

export function regionOf(cloth: Cloth, area: Area, balls: Step["balls"]): Region {
  if ("center" in area) {
    const center = pointOf(cloth, area.center, balls);
    return { kind: "disc", center, radius: area.radius * cloth.diamond[1] };
  }
  if ("from" in area)
    return { kind: "box", from: metres(cloth, area.from), to: metres(cloth, area.to) };
  const { head_string: line, d_radius: radius } = cloth.geometry.markings!;
  return { kind: "half-disc", center: [cloth.size[0] / 2, line!], radius: radius! };
}

/** How far a point is outside a region, m; 0 inside. */
export function distanceTo(region: Region, [x, y]: Point): number {
  if (region.kind === "box") {
    const { from, to } = region;
    return length(Math.max(from[0] - x, 0, x - to[0]), Math.max(from[1] - y, 0, y - to[1]));
  }
  const [cx, cy] = region.center;
  const outside = Math.max(length(x - cx, y - cy) - region.radius, 0);
  return region.kind === "disc" ? outside : Math.max(outside, y - cy);
}
