/** Marked areas of the cloth, such as the region for a cue ball in hand. */

import { DoubleSide, Group, Mesh, MeshBasicMaterial, Shape, ShapeGeometry } from "three";
import { LAYER } from "../table/solid.ts";
import type { Area } from "../viewer-types.ts";
import { Lines } from "./pixel-lines.ts";

/** Opacity of the fill. */
const FILLED = 0.16;

/** Height above the cloth and its markings, m. */
const HEIGHT = 2 * LAYER;

export class Areas {
  readonly group = new Group();
  readonly #borders = new Lines({ width: 1.6, opacity: 0.85, dash: [0.03, 0.016] });
  #fills: Mesh<ShapeGeometry, MeshBasicMaterial>[] = [];

  constructor() {
    this.group.add(this.#borders.object);
  }

  set(areas: readonly Area[]): void {
    this.#clear();
    for (const { outline, color } of areas) {
      const [first] = outline;
      if (!first) continue;
      this.#fills.push(fill(outline, color));
      const closed = [...outline, first].flatMap(([x, y]) => [x, y, HEIGHT]);
      this.#borders.add(closed, 3, color);
    }
    if (this.#fills.length > 0) this.group.add(...this.#fills);
    this.#borders.commit();
  }

  dispose(): void {
    this.#clear();
    this.#borders.dispose();
  }

  #clear(): void {
    for (const mesh of this.#fills) {
      this.group.remove(mesh);
      mesh.geometry.dispose();
      mesh.material.dispose();
    }
    this.#fills = [];
    this.#borders.clear();
  }
}

function fill(outline: Area["outline"], color: string): Mesh<ShapeGeometry, MeshBasicMaterial> {
  const shape = new Shape();
  outline.forEach(([x, y], k) => (k === 0 ? shape.moveTo(x, y) : shape.lineTo(x, y)));
  const material = new MeshBasicMaterial({
    color,
    transparent: true,
    opacity: FILLED,
    side: DoubleSide,
    depthWrite: false,
  });
  const mesh = new Mesh(new ShapeGeometry(shape), material);
  mesh.position.z = HEIGHT;
  mesh.renderOrder = 1;
  return mesh;
}
