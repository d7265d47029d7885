/** A soft light on a pocket, a rail or a ball. */

import {
  AdditiveBlending,
  type BufferGeometry,
  DoubleSide,
  Group,
  Mesh,
  MeshBasicMaterial,
  RingGeometry,
  Shape,
  ShapeGeometry,
} from "three";
import type { Balls } from "../balls/drawn-balls.ts";
import { LAYER } from "../table/solid.ts";
import { outline } from "../table/table-outline.ts";
import type { Geometry, Lit } from "../viewer-types.ts";

const COLOR = 0xffe08a;
/** Period of the pulse, s; its least and greatest opacity, and the opacity without a pulse. */
const PERIOD = 1.6;
const OPACITY = [0.25, 0.75] as const;
const STEADY = 0.6;
/** Inner and outer radius of the ring, as shares of the pocket's and the ball's radius. */
const POCKET_RING = [0.82, 1.3] as const;
const BALL_RING = [1.15, 1.75] as const;

export class Highlight {
  readonly group = new Group();
  readonly #material = new MeshBasicMaterial({
    color: COLOR,
    transparent: true,
    blending: AdditiveBlending,
    side: DoubleSide,
    depthTest: false,
    depthWrite: false,
  });

  #meshes: Mesh[] = [];

  /** Whether something is lit. */
  get lit(): boolean {
    return this.#meshes.length > 0;
  }

  /**
   * Lights what is named; null puts the light out.
   *
   * @throws Error for a pocket or a rail that the table does not have.
   */
  set(lit: Lit | null, geometry: Geometry, balls: Balls): void {
    this.dispose();
    if (!lit) return;
    const height = geometry.cushion_height + LAYER;
    if (lit.pocket !== undefined) {
      const pocket = geometry.pockets.find(({ name }) => name === lit.pocket);
      if (!pocket)
        throw new Error(`pocket "${lit.pocket}": the table has none; use its pockets' names.`);
      const [inner, outer] = POCKET_RING.map((share) => share * pocket.radius);
      this.#add(new RingGeometry(inner, outer, 48), [...pocket.center, height]);
    }
    if (lit.rail !== undefined) {
      const plan = geometry.size ? outline(geometry) : null;
      const rails = plan?.runs.filter(({ material }) => material === "cushion") ?? [];
      const at = rails.findIndex(({ rail }) => rail === lit.rail);
      if (at < 0)
        throw new Error(`rail "${lit.rail}": the table has none; use its cushions' rails.`);
      const shape = new Shape();
      plan!.rubbers[at]!.forEach(([x, y], k) =>
        k === 0 ? shape.moveTo(x, y) : shape.lineTo(x, y),
      );
      this.#add(new ShapeGeometry(shape), [0, 0, height]);
    }
    if (lit.ball !== undefined && balls.visible(lit.ball)) {
      const { radius } = balls.info(lit.ball);
      const { x, y, z } = balls.center(lit.ball);
      const [inner, outer] = BALL_RING.map((share) => share * radius);
      this.#add(new RingGeometry(inner, outer, 48), [x, y, Math.max(0, z - radius) + 2 * LAYER]);
    }
  }

  /** @param seconds - Time of the pulse, s; null: steady. */
  pulse(seconds: number | null): void {
    const wave = 0.5 - 0.5 * Math.cos((2 * Math.PI * (seconds ?? 0)) / PERIOD);
    const pulsing = OPACITY[0] + (OPACITY[1] - OPACITY[0]) * wave;
    this.#material.opacity = seconds === null ? STEADY : pulsing;
  }

  dispose(): void {
    for (const mesh of this.#meshes) mesh.geometry.dispose();
    this.#meshes = [];
    this.group.clear();
  }

  #add(geometry: BufferGeometry, position: readonly number[]): void {
    const mesh = new Mesh(geometry, this.#material);
    mesh.position.fromArray(position);
    mesh.renderOrder = 4;
    this.#meshes.push(mesh);
    this.group.add(mesh);
  }
}
