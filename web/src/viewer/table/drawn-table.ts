/** The table as an object of the scene. */

import {
  type BufferGeometry,
  Group,
  type Material,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
} from "three";
import { DEPTH, STILL } from "../render/layers.ts";
import { clothColor, type Palette } from "../theme-colors.ts";
import type { Geometry, Point } from "../viewer-types.ts";
import { markings, sights } from "./fittings.ts";
import { DEEP, TableMaterials } from "./materials.ts";
import { outline } from "./table-outline.ts";
import { FLOOR, solid } from "./solid.ts";
import { raised, ring, roundedRectangle, Surface } from "./surface.ts";

/** Drawn radius of unbounded cloth, m; it fades from half of it. */
const UNBOUNDED = 9;
/** Width of the soft edge of the shadow on the floor, m. */
const PENUMBRA = 0.35;

/** A table with its shadow on the floor, or unbounded cloth. */
export class Table {
  readonly group = new Group();
  readonly #materials = new TableMaterials();
  readonly #depthMaterial = new MeshBasicMaterial({ colorWrite: false });
  readonly #deepMaterial = new MeshBasicMaterial({ colorWrite: false, ...DEEP });
  #meshes: Mesh[] = [];

  /**
   * Replaces the table.
   *
   * @param middle - Centre of the drawn part of unbounded cloth, m.
   */
  setGeometry(geometry: Geometry, middle: Point): void {
    this.#clear();
    const materials = this.#materials;
    const color = clothColor(geometry.physics);
    materials.cloth.color.set(color);
    materials.unbounded.color.set(color);
    if (!geometry.size) {
      materials.area.set(middle[0], middle[1], UNBOUNDED, UNBOUNDED);
      const cloth = unboundedCloth();
      cloth.translate(middle[0], middle[1], 0);
      this.#add(cloth, materials.unbounded, { receives: true });
      return;
    }
    const [width, length] = geometry.size;
    materials.area.set(width / 2, length / 2, width / 2, length / 2);
    const plan = outline(geometry);
    const body = solid(geometry, plan);
    this.#add(body.cloth, materials.cloth, { receives: true, order: -1 });
    this.#add(body.cushions, materials.cloth, { receives: true, casts: true });
    this.#add(body.wood, materials.wood, { receives: true });
    this.#add(body.apron, materials.apron);
    this.#add(body.pockets, materials.leather);
    for (const part of [body.cloth, body.cushions, body.wood, body.apron, body.pockets]) {
      const mesh = new Mesh(part, part === body.apron ? this.#deepMaterial : this.#depthMaterial);
      mesh.layers.set(DEPTH);
      mesh.renderOrder = -3;
      this.#meshes.push(mesh);
      this.group.add(mesh);
    }
    this.#add(body.shade, materials.shade);
    const diamonds = sights(geometry);
    if (diamonds) this.#add(diamonds, materials.sights);
    const lines = markings(geometry);
    if (lines) this.#add(lines, materials.markings);
    this.#add(floorShadow(geometry.size, plan.reach), materials.floor);
  }

  /**
   * An object for each shader of a table with rails. It draws nothing; shaders compile from it before
   * the first table is known.
   */
  samples(): Object3D {
    const { cloth, shade } = this.#materials;
    const empty = new Surface().geometry();
    const group = new Group();
    for (const material of [cloth, shade, this.#depthMaterial])
      group.add(new Mesh(empty, material));
    for (const mesh of group.children) mesh.receiveShadow = true;
    return group;
  }

  setPalette(palette: Palette): void {
    this.#materials.wood.color.set(palette.wood);
    this.#materials.apron.color.set(palette.apron);
    this.#materials.floor.opacity = palette.floorShadow;
  }

  dispose(): void {
    this.#clear();
    this.#materials.dispose();
    this.#depthMaterial.dispose();
    this.#deepMaterial.dispose();
  }

  /**
   * @param order - The table is drawn before everything on it, including its transparent parts. The bed of
   * cloth is drawn last, so that pixels hidden by cushions and wood cost nothing.
   */
  #add(
    geometry: BufferGeometry,
    material: Material,
    { receives = false, casts = false, order = -2 } = {},
  ): void {
    const mesh = new Mesh(geometry, material);
    mesh.receiveShadow = receives;
    mesh.castShadow = casts;
    mesh.matrixAutoUpdate = false;
    mesh.layers.set(STILL);
    mesh.renderOrder = order;
    this.#meshes.push(mesh);
    this.group.add(mesh);
  }

  #clear(): void {
    for (const mesh of this.#meshes) {
      this.group.remove(mesh);
      mesh.geometry.dispose();
    }
    this.#meshes = [];
  }
}

/** A disc of cloth that fades out, around the origin. */
function unboundedCloth(): BufferGeometry {
  const [inner, outer] = [ring([0, 0], UNBOUNDED / 2, 64), ring([0, 0], UNBOUNDED, 64)];
  const fading = [raised(outer, 0), raised(inner, 0)];
  return new Surface()
    .fill(inner.slice(1), [], 0)
    .bands(fading, [[1, 0], 1])
    .geometry();
}

/** The shadow of a table on the floor: dark, with a soft edge. */
function floorShadow(size: Point, reach: number): BufferGeometry {
  const steps = Array.from({ length: 9 }, (_, k) => k / 8);
  const lines = steps.map((step) => {
    const margin = reach + PENUMBRA * (1 - 2 * step);
    return raised(roundedRectangle(size, margin, PENUMBRA * (2 - step)), -FLOOR);
  });
  const shades = steps.map((step) => [0, step * step * (3 - 2 * step)] as const);
  const inside = roundedRectangle(size, reach - PENUMBRA, PENUMBRA).slice(1);
  return new Surface().bands(lines, shades).fill(inside, [], -FLOOR, [0, 1]).geometry();
}
