/** Diamonds on the rails, and lines and spots on the cloth. */

import type { BufferGeometry } from "three";
import type { Geometry, Point } from "../viewer-types.ts";
import { LAYER } from "./solid.ts";
import { raised, ring, Surface } from "./surface.ts";

/** Half the width and half the length of a diamond, m; typical values. */
const SIGHT: Point = [0.0075, 0.0165];
/** Width of a line on the cloth and radius of a spot, m. */
const LINE_WIDTH = 0.004;
const SPOT_RADIUS = 0.0058;

/** The diamonds; null if the table has none. */
export function sights(geometry: Geometry): BufferGeometry | null {
  const places = sightPlaces(geometry);
  if (places.length === 0) return null;
  const surface = new Surface();
  for (const [[x, y], alongY] of places) {
    const [across, along] = SIGHT;
    const [a, b] = alongY ? [across, along] : [along, across];
    const diamond: Point[] = [
      [x - a, y],
      [x, y - b],
      [x + a, y],
      [x, y + b],
    ];
    surface.fill(diamond, [], geometry.cushion_height + LAYER);
  }
  return surface.geometry();
}

/**
 * Centres of the diamonds, m, and whether they are longer along y. There are none at the ends of a rail
 * and at a pocket.
 */
export function sightPlaces({ size, sights: marks, pockets }: Geometry): [Point, boolean][] {
  if (!size || !marks) return [];
  const [width, length] = size;
  const back = marks.setback;
  const places: [Point, boolean][] = [];
  for (let i = 1; i < marks.along_length; i += 1) {
    if (pockets.length > 0 && 2 * i === marks.along_length) continue;
    const y = (i * length) / marks.along_length;
    places.push([[-back, y], true], [[width + back, y], true]);
  }
  for (let i = 1; i < marks.along_width; i += 1) {
    const x = (i * width) / marks.along_width;
    places.push([[x, -back], false], [[x, length + back], false]);
  }
  return places;
}

/** Head string or baulk line, the D, and the spots; null if the table has no markings. */
export function markings({ size, markings: marks }: Geometry): BufferGeometry | null {
  if (!size || !marks) return null;
  const surface = new Surface();
  const { head_string: string, d_radius: radius, spots } = marks;
  const half = LINE_WIDTH / 2;
  if (string !== null) {
    const [lower, upper] = [string - half, string + half].map((y) =>
      raised(
        [
          [0, y],
          [size[0], y],
        ],
        LAYER,
      ),
    );
    surface.bands([lower!, upper!]);
  }
  if (string !== null && radius !== null) {
    const center: Point = [size[0] / 2, string];
    const [inner, outer] = [radius - half, radius + half].map((r) =>
      raised(ring(center, r, 96).slice(48), LAYER),
    );
    surface.bands([outer!, inner!]);
  }
  for (const spot of spots) surface.fill(ring(spot.position, SPOT_RADIUS, 20).slice(1), [], LAYER);
  return surface.geometry();
}
