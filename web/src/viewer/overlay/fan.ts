/** Many variants at once: final positions of the struck ball as a heat map, and some of its paths. */

import {
  BufferGeometry,
  DataTexture,
  Float32BufferAttribute,
  Group,
  LinearFilter,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshBasicMaterial,
  PlaneGeometry,
  SRGBColorSpace,
} from "three";
import { LAYER } from "../table/solid.ts";
import type { Point } from "../viewer-types.ts";
import { bin, colors, type Density, smooth } from "./density.ts";

/** Opacity of one path; overlapping paths add up. */
const PATH_OPACITY = 0.9;
/** Number of paths with full opacity; more paths are drawn fainter. */
const FULL_PATHS = 8;

export class Fan {
  readonly group = new Group();
  readonly #heat = new Mesh(
    new PlaneGeometry(1, 1),
    new MeshBasicMaterial({
      transparent: true,
      depthWrite: false,
      polygonOffset: true,
      polygonOffsetFactor: -2,
    }),
  );
  readonly #paths = new LineSegments(
    new BufferGeometry(),
    new LineBasicMaterial({ color: 0xffffff, transparent: true, depthWrite: false }),
  );

  constructor() {
    this.#paths.frustumCulled = false;
    this.#heat.renderOrder = 1;
    this.#paths.renderOrder = 2;
    this.group.add(this.#heat, this.#paths);
    this.clear();
  }

  /**
   * @param points - x, y (m) per variant; NaN if the ball ends off the table.
   * @param paths - x, y, z (m) per point of each path.
   * @param origin - Lower left corner of the cloth, m.
   * @param size - Its width and length, m.
   */
  set(points: Float64Array, paths: readonly Float32Array[], origin: Point, size: Point): void {
    this.setHeat(smooth(bin(points, origin, size)), origin, size);
    this.#setPaths(paths);
  }

  /** Shows a density over the cloth, without paths. */
  setHeat(density: Density, origin: Point, size: Point): void {
    const texture = new DataTexture(colors(density), density.columns, density.rows);
    texture.colorSpace = SRGBColorSpace;
    texture.magFilter = LinearFilter;
    texture.needsUpdate = true;
    this.#heat.material.map?.dispose();
    this.#heat.material.map = texture;
    this.#heat.material.needsUpdate = true;
    this.#heat.scale.set(size[0], size[1], 1);
    this.#heat.position.set(origin[0] + size[0] / 2, origin[1] + size[1] / 2, 1.5 * LAYER);
    this.#heat.visible = true;
  }

  clear(): void {
    this.#heat.visible = false;
    this.#paths.visible = false;
  }

  dispose(): void {
    this.#heat.geometry.dispose();
    this.#heat.material.map?.dispose();
    this.#heat.material.dispose();
    this.#paths.geometry.dispose();
    this.#paths.material.dispose();
  }

  #setPaths(paths: readonly Float32Array[]): void {
    const segments = paths.reduce((sum, path) => sum + Math.max(0, path.length / 3 - 1), 0);
    this.#paths.visible = segments > 0;
    if (segments === 0) return;
    const positions = new Float32Array(6 * segments);
    let at = 0;
    for (const path of paths) {
      for (let i = 0; i + 5 < path.length; i += 3) {
        positions.set(path.subarray(i, i + 6), at);
        at += 6;
      }
    }
    this.#paths.geometry.dispose();
    this.#paths.geometry = new BufferGeometry();
    this.#paths.geometry.setAttribute("position", new Float32BufferAttribute(positions, 3));
    this.#paths.material.opacity = Math.min(1, FULL_PATHS / paths.length) ** 0.7 * PATH_OPACITY;
  }
}
