/** The table as an object of the scene. */

import {
  type BufferGeometry,
  CanvasTexture,
  Group,
  type Material,
  Mesh,
  MeshBasicMaterial,
  type Object3D,
  PlaneGeometry,
} from "three";
import { DEPTH, STILL } from "../render/layers";
import { clothColor, type Palette } from "../theme";
import type { Geometry, Point } from "../types";
import { markings, sights } from "./fittings";
import { TableMaterials } from "./materials";
import { outline } from "./outline";
import { FLOOR, solid } from "./solid";
import { raised, ring, Surface } from "./surface";

/** Drawn radius of unbounded cloth, m; it fades from half of it. */
const UNBOUNDED = 9;
/** Width of the soft edge of the shadow on the floor, m. */
const PENUMBRA = 0.35;

/** A table with its shadow on the floor, or unbounded cloth. */
export class Table {
  readonly group = new Group();
  readonly #materials = new TableMaterials();
  readonly #floorMaterial = new MeshBasicMaterial({
    map: floorShadow(),
    transparent: true,
    depthWrite: false,
  });
  readonly #depthMaterial = new MeshBasicMaterial({ colorWrite: false });
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
    this.#add(body.frame, materials.frame);
    this.#add(body.pockets, materials.leather);
    for (const part of [body.cloth, body.cushions, body.wood, body.frame, body.pockets]) {
      const mesh = new Mesh(part, this.#depthMaterial);
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
    const floor = new PlaneGeometry(
      width + 2 * (plan.reach + PENUMBRA),
      length + 2 * (plan.reach + PENUMBRA),
    );
    floor.translate(width / 2, length / 2, -FLOOR);
    this.#add(floor, this.#floorMaterial);
  }

  /**
   * An object for each shader of a table with rails. It draws nothing; shaders compile from it before
   * the first table is known.
   */
  samples(): Object3D {
    const { cloth, wood, frame, shade, sights, markings } = this.#materials;
    const coloured = new Surface().geometry();
    const plain = new PlaneGeometry();
    const group = new Group();
    for (const material of [cloth, wood, frame, shade]) group.add(new Mesh(coloured, material));
    for (const material of [sights, markings, this.#floorMaterial, this.#depthMaterial])
      group.add(new Mesh(plain, material));
    for (const mesh of group.children) mesh.receiveShadow = true;
    return group;
  }

  setPalette(palette: Palette): void {
    this.#materials.wood.color.set(palette.wood);
    this.#materials.frame.color.set(palette.frame);
    this.#floorMaterial.opacity = palette.floorShadow;
  }

  dispose(): void {
    this.#clear();
    this.#materials.dispose();
    this.#floorMaterial.map?.dispose();
    this.#floorMaterial.dispose();
    this.#depthMaterial.dispose();
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

/** A dark rectangle with soft edges. */
function floorShadow(): CanvasTexture {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const context = canvas.getContext("2d")!;
  const picture = context.createImageData(64, 64);
  for (let i = 0; i < 64 * 64; i += 1) {
    const fade = (at: number): number => {
      const t = Math.min(1, (0.5 - Math.abs((at + 0.5) / 64 - 0.5)) / 0.22);
      return t * t * (3 - 2 * t);
    };
    picture.data[4 * i + 3] = 255 * fade(i % 64) * fade(Math.floor(i / 64));
  }
  context.putImageData(picture, 0, 0);
  return new CanvasTexture(canvas);
}
