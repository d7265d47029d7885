/**
 * Names of pockets and rails as the picture shows them.
 *
 * The engine names them on an upright table, whose +y axis points up. The page may show the table lying,
 * or from another side. Places are on a grid: column −1 is left and 1 right, row −1 is bottom and 1 top.
 */

import type { PocketName, RailName } from "../../engine/index.ts";

/** Quarter turns clockwise of the picture. */
export type Orientation = 0 | 1 | 2 | 3;

type Place = readonly [column: number, row: number];

const POCKETS: Readonly<Record<PocketName, Place>> = {
  "bottom-left": [-1, -1],
  "bottom-right": [1, -1],
  left: [-1, 0],
  right: [1, 0],
  "top-left": [-1, 1],
  "top-right": [1, 1],
};

/** The halves of a rail that a side pocket divides are half a step from its middle. */
const RAILS: Readonly<Record<RailName, Place>> = {
  bottom: [0, -1],
  top: [0, 1],
  left: [-1, 0],
  right: [1, 0],
  "left-lower": [-1, -0.5],
  "left-upper": [-1, 0.5],
  "right-lower": [1, -0.5],
  "right-upper": [1, 0.5],
};

/** A pocket's name in the picture; of a lying table two side pockets are at the top and bottom. */
export type SeenPocket = PocketName | "top" | "bottom";

export type SeenRail = RailName | "top-left" | "top-right" | "bottom-left" | "bottom-right";

let presentOrientation = (): Orientation => 0;

/** Names follow `present`, the orientation of the picture. Texts that are kept must be made again when it changes. */
export function followOrientation(present: () => Orientation): void {
  presentOrientation = present;
}

/** The quarter turns of a picture in which +y points to (`dx`, `dy`), in pixels; y is down on a screen. */
export function orientationOf(dx: number, dy: number): Orientation {
  if (Math.abs(dx) > Math.abs(dy)) return dx > 0 ? 1 : 3;
  return dy < 0 ? 0 : 2;
}

export function seenPocket(name: PocketName): SeenPocket {
  const [column, row] = turned(POCKETS[name]);
  return [ROWS[row + 1], COLUMNS[column + 1]].filter(Boolean).join("-") as SeenPocket;
}

export function seenRail(name: RailName): SeenRail {
  const [column, row] = turned(RAILS[name]);
  const isAcross = Math.abs(row) === 1;
  const side = isAcross ? ROWS[row + 1]! : COLUMNS[column + 1]!;
  const along = isAcross ? column : row;
  if (along === 0) return side as SeenRail;
  const part = isAcross ? (along < 0 ? "left" : "right") : along < 0 ? "lower" : "upper";
  return `${side}-${part}` as SeenRail;
}

const ROWS = ["bottom", "", "top"];
const COLUMNS = ["left", "", "right"];

function turned([column, row]: Place): Place {
  let place: Place = [column, row];
  for (let k = 0; k < presentOrientation(); k += 1) place = [place[1], -place[0]];
  return place;
}
