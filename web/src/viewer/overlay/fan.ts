/** Many outcomes at once: where the cue ball ends, as a heat map on the cloth, and its ways there. */

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
import { LAYER } from "../table/solid";
import type { Point } from "../types";
import { bin, colors, smooth } from "./density";

/** Opacity of one way out of many; they add up where they meet. */
const WAY_OPACITY = 0.9;
/** Ways drawn at full opacity; of more, each is fainter. */
const FULL_WAYS = 8;

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
  readonly #ways = new LineSegments(
    new BufferGeometry(),
    new LineBasicMaterial({ color: 0xffffff, transparent: true, depthWrite: false }),
  );

  constructor() {
    this.#ways.frustumCulled = false;
    this.#heat.renderOrder = 1;
    this.#ways.renderOrder = 2;
    this.group.add(this.#heat, this.#ways);
    this.clear();
  }

  /**
   * @param points - x, y (m) per outcome; NaN for those without an end on the table.
   * @param ways - x, y, z (m) per point of each way.
   * @param origin - Lower left corner of the cloth, m.
   * @param size - Its width and length, m.
   */
  set(points: Float64Array, ways: readonly Float32Array[], origin: Point, size: Point): void {
    const density = smooth(bin(points, origin, size));
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
    this.#setWays(ways);
  }

  clear(): void {
    this.#heat.visible = false;
    this.#ways.visible = false;
  }

  dispose(): void {
    this.#heat.geometry.dispose();
    this.#heat.material.map?.dispose();
    this.#heat.material.dispose();
    this.#ways.geometry.dispose();
    this.#ways.material.dispose();
  }

  #setWays(ways: readonly Float32Array[]): void {
    const segments = ways.reduce((sum, way) => sum + Math.max(0, way.length / 3 - 1), 0);
    this.#ways.visible = segments > 0;
    if (segments === 0) return;
    const positions = new Float32Array(6 * segments);
    let at = 0;
    for (const way of ways) {
      for (let i = 0; i + 5 < way.length; i += 3) {
        positions.set(way.subarray(i, i + 6), at);
        at += 6;
      }
    }
    this.#ways.geometry.dispose();
    this.#ways.geometry = new BufferGeometry();
    this.#ways.geometry.setAttribute("position", new Float32BufferAttribute(positions, 3));
    this.#ways.material.opacity = Math.min(1, FULL_WAYS / ways.length) ** 0.7 * WAY_OPACITY;
  }
}
