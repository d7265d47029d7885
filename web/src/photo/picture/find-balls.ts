/** The balls that a photo shows, with their places and ids. */

import type { Camera } from "../geometry/camera.ts";
import { ballColors } from "./ball-colors.ts";
import { ballPlaces, type Searched, type SeenBall } from "./ball-places.ts";
import { clothOf } from "./cloth.ts";
import { smoothed, type Pixels } from "./pixels.ts";

export interface NamedBall extends SeenBall {
  readonly id: string;
}

/** The balls of a set that are seen on a table, the clearest first; empty if the cloth is not seen. */
export function findBalls(
  pixels: Pixels,
  camera: Camera,
  searched: Searched,
  ids: readonly string[],
): NamedBall[] {
  const smooth = smoothed(pixels);
  const cloth = clothOf(smooth, camera, searched.size);
  if (!cloth) return [];
  const balls = ballPlaces(smooth, camera, cloth, searched).slice(0, ids.length);
  const names = ballColors(smooth, camera, cloth, searched.radius, balls, ids);
  return balls.map((ball, k) => ({ ...ball, id: names[k]! }));
}
