/** Where a dragged ball goes: exactly onto the contact that it nearly has, out of what it would overlap. */

import type { Point } from "../../engine/index.ts";
import type { Bed } from "../../photo/index.ts";

/** A ball that the dragged one may touch. */
export interface Neighbour {
  readonly position: readonly [number, number, ...number[]];
  readonly radius: number;
}

/** What the centre of the dragged ball keeps away from. */
interface Limit {
  /** Distance beyond the limit (m), negative inside it. */
  gap(place: Point): number;
  /** The nearest place on the limit. */
  nearest(place: Point): Point;
}

interface Circle extends Limit {
  readonly center: Point;
  readonly radius: number;
}

interface Line extends Limit {
  readonly axis: 0 | 1;
  readonly at: number;
}

/** Overlap (m) that the engine does not count (TOUCH_TOLERANCE in crates/carom/src/table/place.rs). */
const TOUCHING = 1e-9;

/**
 * The place nearest to `wanted` at which a ball overlaps nothing; on the contacts that are within `reach`
 * (m) of it, two if there are two. `wanted` itself if no contact is near.
 *
 * @param touches Whether the ball may touch other balls; if not, contacts with them do not attract it.
 */
export function snapped(
  wanted: Point,
  bed: Bed,
  others: readonly Neighbour[],
  reach: number,
  touches = true,
): Point {
  const lines = bed.noses.map((nose) => line(bed, nose));
  const circles = others.map((other) => circle(other, bed.radius));
  const limits: Limit[] = [...lines, ...circles];
  const attracting: Limit[] = touches ? limits : lines;
  const near = attracting.filter((limit) => limit.gap(wanted) < reach);
  const overlaps = limits.some((limit) => limit.gap(wanted) < -TOUCHING);
  if (near.length === 0 && !overlaps) return wanted;
  const isFree = (place: Point) => limits.every((limit) => limit.gap(place) > -TOUCHING);
  const off = (place: Point) => Math.hypot(place[0] - wanted[0], place[1] - wanted[1]);
  const best = (places: readonly Point[], most: number) =>
    places
      .filter((place) => isFree(place) && off(place) <= most)
      .sort((a, b) => off(a) - off(b))[0];
  const corners = near.flatMap((one, k) =>
    near.slice(k + 1).flatMap((other) => crossings(one as Line | Circle, other as Line | Circle)),
  );
  const edges = near.map((limit) => limit.nearest(wanted));
  // Out of an overlap a ball goes as far as it must.
  return best(corners, reach) ?? best([...edges, ...corners], Infinity) ?? wanted;
}

function line({ reach }: Bed, nose: Bed["noses"][number]): Line {
  const { axis, inward, from, to } = nose;
  const at = nose.at + inward * reach;
  const along = axis === 0 ? 1 : 0;
  return {
    axis,
    at,
    gap: (place) =>
      place[along] < from || place[along] > to ? Infinity : inward * (place[axis] - at),
    nearest: (place) => (axis === 0 ? [at, place[1]] : [place[0], at]),
  };
}

function circle({ position, radius: other }: Neighbour, own: number): Circle {
  const center: Point = [position[0], position[1]];
  const radius = own + other;
  const from = ([x, y]: Point) => [x - center[0], y - center[1]] as const;
  return {
    center,
    radius,
    gap: (place) => Math.hypot(...from(place)) - radius,
    nearest: (place) => {
      const [x, y] = from(place);
      const away = Math.hypot(x, y);
      // From the very centre a ball goes along the table.
      const [u, v] = away > 0 ? [x / away, y / away] : [0, 1];
      return [center[0] + radius * u, center[1] + radius * v];
    },
  };
}

function crossings(one: Line | Circle, other: Line | Circle): Point[] {
  if ("axis" in one && "axis" in other) {
    if (one.axis === other.axis) return [];
    return [one.axis === 0 ? [one.at, other.at] : [other.at, one.at]];
  }
  if ("axis" in one) return onLine(other as Circle, one);
  if ("axis" in other) return onLine(one, other);
  return onCircle(one, other);
}

function onLine({ center, radius }: Circle, { axis, at }: Line): Point[] {
  const along = axis === 0 ? 1 : 0;
  const half = Math.sqrt(radius ** 2 - (at - center[axis]) ** 2);
  if (Number.isNaN(half)) return [];
  return [center[along] + half, center[along] - half].map((s) => (axis === 0 ? [at, s] : [s, at]));
}

function onCircle(one: Circle, other: Circle): Point[] {
  const [x, y] = [other.center[0] - one.center[0], other.center[1] - one.center[1]];
  const apart = Math.hypot(x, y);
  const along = (apart ** 2 + one.radius ** 2 - other.radius ** 2) / (2 * apart);
  const across = Math.sqrt(one.radius ** 2 - along ** 2);
  if (!Number.isFinite(across)) return [];
  const [u, v] = [x / apart, y / apart];
  return [across, -across].map((s) => [
    one.center[0] + along * u - s * v,
    one.center[1] + along * v + s * u,
  ]);
}
