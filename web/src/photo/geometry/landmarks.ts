/** The places of a table that are tapped in a photo. */

import type { Geometry, Point, PocketName, Vector } from "../../engine/index.ts";

/** The corners and, third and sixth, the middles of the long rails: counter-clockwise from above. */
export const PLACES = [
  "bottom-left",
  "bottom-right",
  "right",
  "top-right",
  "top-left",
  "left",
] as const satisfies readonly PocketName[];

/** Indices of the corners in PLACES. */
export const CORNERS: readonly number[] = [0, 1, 3, 4];

/** Index into PLACES of a middle. */
export const RIGHT = 2;

/** What a table is for a photo. */
export interface Landmarks {
  /** Playing area, m. */
  readonly size: Point;
  /** Height of the noses above the bed, m. */
  readonly nose: number;
  /** Whether the places are pockets; otherwise they lie on the noses of the cushions. */
  readonly pockets: boolean;
  /** In the order of PLACES, m. All have the same height. */
  readonly places: readonly Vector[];
}

/**
 * The landmarks of a table; null without rails. With pockets they are the centres of the holes at the
 * height of the bed. Without, they are the corners and the middles of the nose line.
 */
export function landmarks({ size, pockets, cushion_height: nose }: Geometry): Landmarks | null {
  if (!size) return null;
  const [width, length] = size;
  const corners: readonly Point[] = [
    [0, 0],
    [width, 0],
    [width, length / 2],
    [width, length],
    [0, length],
    [0, length / 2],
  ];
  const places = PLACES.map((name, k): Vector => {
    const pocket = pockets.find((one) => one.name === name);
    return pocket ? [...pocket.center, 0] : [...corners[k]!, nose];
  });
  return { size, nose, pockets: pockets.length === PLACES.length, places };
}
