/** Parts of a photo; rendering the rest would take much longer. */

import type { Size } from "../../src/photo/geometry/calibrate.ts";
import { project } from "../../src/photo/geometry/camera.ts";
import type { Pixels } from "../../src/photo/picture/pixels.ts";
import type { Random } from "./random.ts";
import { render, type Scene } from "./render.ts";
import type { Vector } from "../../src/engine/index.ts";

/** How far the rendered parts reach from the places, pixels. */
const REACH = 45;
/** How the parts are rendered. */
interface Way {
  /** Side of the rendered squares, pixels. */
  readonly tile: number;
  /** Samples per pixel along each axis. */
  readonly samples: number;
}
const FINE: Way = { tile: 30, samples: 2 };
/** Larger and quicker: the disturbances are coarser than a pixel. */
const COARSE: Way = { tile: 60, samples: 1 };
/** Points along each side of the bed. */
const POINTS = 60;

/** A photo in which only the surroundings of the rails are rendered. */
export function renderRails(scene: Scene, size: Size, random: Random): Pixels {
  const { size: bed, cushion_height: nose } = scene.table;
  const [across, along] = bed!;
  const places = Array.from({ length: POINTS + 1 }, (_, k): Vector[] => {
    const share = k / POINTS;
    return [
      ...[0, across].map((x): Vector => [x, share * along, nose]),
      ...[0, along].map((y): Vector => [share * across, y, nose]),
    ];
  });
  return renderAround(scene, size, random, places.flat(), FINE);
}

/** A photo in which only the table is rendered. */
export function renderTable(scene: Scene, size: Size, random: Random): Pixels {
  const { size: bed, cushion_height: nose } = scene.table;
  const [across, along] = bed!;
  const places = Array.from({ length: (POINTS + 1) ** 2 }, (_, k): Vector => {
    const [i, j] = [k % (POINTS + 1), Math.floor(k / (POINTS + 1))];
    return [(i / POINTS) * across, (j / POINTS) * along, nose];
  });
  return renderAround(scene, size, random, places, COARSE);
}

function renderAround(
  scene: Scene,
  [width, height]: Size,
  random: Random,
  places: readonly Vector[],
  { tile: side, samples }: Way,
): Pixels {
  const wanted = new Set<number>();
  const columns = Math.ceil(width / side);
  const rows = Math.ceil(height / side);
  for (const place of places) {
    const pixel = project(scene.camera, place);
    if (!pixel) continue;
    const from = pixel.map((at) => Math.floor((at - REACH) / side));
    const to = pixel.map((at) => Math.floor((at + REACH) / side));
    for (let j = Math.max(0, from[1]!); j <= Math.min(rows - 1, to[1]!); j += 1)
      for (let i = Math.max(0, from[0]!); i <= Math.min(columns - 1, to[0]!); i += 1)
        wanted.add(j * columns + i);
  }
  const data = new Uint8ClampedArray(4 * width * height);
  for (const tile of wanted) {
    const [left, top] = [(tile % columns) * side, Math.floor(tile / columns) * side];
    const frame = {
      left,
      top,
      width: Math.min(side, width - left),
      height: Math.min(side, height - top),
    };
    const part = render(scene, frame, random, samples);
    for (let y = 0; y < frame.height; y += 1) {
      const row = part.data.subarray(4 * y * frame.width, 4 * (y + 1) * frame.width);
      data.set(row, 4 * ((top + y) * width + left));
    }
  }
  return { left: 0, top: 0, width, height, data };
}
