/** The parts of a photo around the rails of its table; rendering the rest would take much longer. */

import type { Size } from "../../src/photo/geometry/calibrate.ts";
import { project } from "../../src/photo/geometry/camera.ts";
import type { Pixels } from "../../src/photo/picture/pixels.ts";
import type { Random } from "./random.ts";
import { render, type Scene } from "./render.ts";

/** Side of the squares that are rendered, and how far they reach from the noses, pixels. */
const TILE = 30;
const REACH = 45;
/** Points along each rail. */
const POINTS = 60;

/** A photo in which only the surroundings of the rails are rendered. */
export function renderRails(scene: Scene, [width, height]: Size, random: Random): Pixels {
  const { size, cushion_height: nose } = scene.table;
  const [across, along] = size!;
  const wanted = new Set<number>();
  const columns = Math.ceil(width / TILE);
  const rows = Math.ceil(height / TILE);
  const mark = (x: number, y: number): void => {
    const pixel = project(scene.camera, [x, y, nose]);
    if (!pixel) return;
    const from = pixel.map((at) => Math.floor((at - REACH) / TILE));
    const to = pixel.map((at) => Math.floor((at + REACH) / TILE));
    for (let j = Math.max(0, from[1]!); j <= Math.min(rows - 1, to[1]!); j += 1)
      for (let i = Math.max(0, from[0]!); i <= Math.min(columns - 1, to[0]!); i += 1)
        wanted.add(j * columns + i);
  };
  for (let k = 0; k <= POINTS; k += 1) {
    const share = k / POINTS;
    for (const x of [0, across]) mark(x, share * along);
    for (const y of [0, along]) mark(share * across, y);
  }
  const data = new Uint8ClampedArray(4 * width * height);
  for (const tile of wanted) {
    const [left, top] = [(tile % columns) * TILE, Math.floor(tile / columns) * TILE];
    const frame = {
      left,
      top,
      width: Math.min(TILE, width - left),
      height: Math.min(TILE, height - top),
    };
    const part = render(scene, frame, random);
    for (let y = 0; y < frame.height; y += 1) {
      const row = part.data.subarray(4 * y * frame.width, 4 * (y + 1) * frame.width);
      data.set(row, 4 * ((top + y) * width + left));
    }
  }
  return { left: 0, top: 0, width, height, data };
}
