/** Rings at events, ghost balls, and the ring around the selected ball. */

import {
  type BufferGeometry,
  DoubleSide,
  Group,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  RingGeometry,
  SphereGeometry,
} from "three";
import { LAYER } from "../table/solid.ts";
import type { Mark } from "../viewer-types.ts";
import type { Balls } from "../balls/drawn-balls.ts";

/** Colours of events, by type. */
const EVENT_COLORS: Readonly<Record<string, string>> = {
  "cue-strike": "#ffffff",
  "ball-collision": "#ffb000",
  "rail-collision": "#6fb7ff",
  "pocket-collision": "#ff5ca8",
  "slate-collision": "#c9b8ff",
  "motion-transition": "#d7d2c4",
  "off-table": "#ff5ca8",
};
/** Colour and size of the mark at a place where a ball may not lie; a little larger than the ball. */
const REFUSED = "#ff2a1a";
const REFUSED_SIZE = 1.12;
/** Inner and outer radius of an event's ring, m. */
const EVENT_RING = [0.009, 0.0135] as const;
/** Inner and outer radius of the ring at a filmed ball, ball radii. */
const FILMED_RING = [1, 1.18] as const;
/** Inner and outer radius of the selected ball's ring, ball radii. */
const SELECTION_RING = [1.22, 1.42] as const;

export class Marks {
  readonly group = new Group();
  readonly #ring = new RingGeometry(...EVENT_RING, 28);
  readonly #filmed = new RingGeometry(...FILMED_RING, 48);
  readonly #ball = new SphereGeometry(1, 24, 12);
  readonly #materials = new Map<string, MeshBasicMaterial | MeshLambertMaterial>();
  readonly #selection = new Mesh(
    new RingGeometry(...SELECTION_RING, 48),
    new MeshBasicMaterial({
      color: 0xffffff,
      transparent: true,
      opacity: 0.9,
      side: DoubleSide,
      depthWrite: false,
    }),
  );
  #used: Mesh[] = [];

  constructor() {
    this.#selection.visible = false;
    this.group.add(this.#selection);
  }

  set(marks: readonly Mark[], balls: Balls): void {
    for (const mesh of this.#used) this.group.remove(mesh);
    this.#used = marks.map((mark) => {
      const [x, y, z] = mark.position;
      const filmed = mark.kind === "filmed";
      const refused = mark.kind === "refused";
      const ghost = refused || mark.kind === "ghost-ball";
      const ball = mark.ball ?? 0;
      const color = balls.looks[ball]?.path ?? "#ffffff";
      const radius = ball < balls.count ? balls.info(ball).radius : z;
      const mesh = new Mesh<BufferGeometry>(
        ghost ? this.#ball : filmed ? this.#filmed : this.#ring,
      );
      if (ghost) {
        mesh.material = this.#ghost(refused ? REFUSED : color);
        mesh.scale.setScalar(refused ? REFUSED_SIZE * radius : radius);
      } else if (filmed) {
        mesh.material = this.#flat(color);
        mesh.scale.setScalar(radius);
      } else {
        mesh.material = this.#flat(EVENT_COLORS[mark.kind] ?? "#ffffff");
      }
      mesh.position.set(x, y, z);
      mesh.renderOrder = 3;
      this.group.add(mesh);
      return mesh;
    });
  }

  /** Moves the selection ring to a ball; null hides it. */
  select(ball: number | null, balls: Balls): void {
    this.#selection.visible = ball !== null && balls.visible(ball);
    if (ball === null || !this.#selection.visible) return;
    const { x, y, z } = balls.center(ball);
    const radius = balls.info(ball).radius;
    this.#selection.position.set(x, y, Math.max(LAYER, z - radius) + 2 * LAYER);
    this.#selection.scale.setScalar(radius);
  }

  dispose(): void {
    this.#ring.dispose();
    this.#filmed.dispose();
    this.#ball.dispose();
    for (const material of this.#materials.values()) material.dispose();
    this.#selection.geometry.dispose();
    this.#selection.material.dispose();
  }

  #flat(color: string) {
    return this.#material(
      `flat ${color}`,
      () =>
        new MeshBasicMaterial({
          color,
          transparent: true,
          opacity: 0.95,
          side: DoubleSide,
          depthTest: false,
          depthWrite: false,
        }),
    );
  }

  #ghost(color: string) {
    return this.#material(
      `ghost ${color}`,
      () => new MeshLambertMaterial({ color, transparent: true, opacity: 0.42, depthWrite: false }),
    );
  }

  #material(key: string, make: () => MeshBasicMaterial | MeshLambertMaterial) {
    const known = this.#materials.get(key);
    if (known) return known;
    const material = make();
    this.#materials.set(key, material);
    return material;
  }
}
