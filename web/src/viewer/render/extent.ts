/** Where on the screen the objects of a scene are drawn. */

import { Box3, type Camera, Matrix4, type Mesh, type Object3D, Vector3, Vector4 } from "three";
import type { Tiles } from "./tiles.ts";

/**
 * Receives a part of an object: all points within `radius` (m) and `pixels` of the line from `from` to
 * `to` (m).
 */
export type Add = (from: Vector3, to: Vector3, radius: number, pixels: number) => void;

/** Names all parts of an object whose geometry does not tell where it is drawn. */
export type Cover = (add: Add) => void;

/** Sets how an object covers the screen; by default it covers the box around its geometry. */
export function setCover(object: Object3D, cover: Cover): void {
  object.userData.cover = cover;
}

/**
 * A sphere at the edge of a wide view is drawn longer than at its centre: by at most this factor, at the
 * cameras' angles of view.
 */
const STRETCH = 1.4;
/** Smooth edges and rounding, pixels. */
const EDGE = 2;

/** Marks the tiles that the objects of a camera's layers cover. */
export class Extent {
  readonly #view = new Matrix4();
  readonly #tiles: Tiles;
  #width = 1;
  #height = 1;
  /** Pixels per unit of length at distance one. */
  #focal = 1;
  readonly #from = new Vector4();
  readonly #to = new Vector4();
  readonly #box = new Box3();
  readonly #ends = [new Vector3(), new Vector3()] as const;
  readonly #corner = new Vector3();

  constructor(tiles: Tiles) {
    this.#tiles = tiles;
  }

  /** @param size - Width and height of the screen, device pixels. */
  mark(scene: Object3D, camera: Camera, [width, height]: readonly [number, number]): void {
    this.#view.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
    [this.#width, this.#height] = [width, height];
    this.#focal = (height * camera.projectionMatrix.elements[5]) / 2;
    scene.updateMatrixWorld();
    scene.traverseVisible((object) => {
      if (!object.layers.test(camera.layers)) return;
      const cover = object.userData.cover as Cover | undefined;
      if (cover) cover(this.#add);
      else this.#addBox(object);
    });
  }

  readonly #add: Add = (from, to, radius, pixels) => {
    const [a, b] = [this.#from, this.#to];
    a.set(from.x, from.y, from.z, 1).applyMatrix4(this.#view);
    b.set(to.x, to.y, to.z, 1).applyMatrix4(this.#view);
    const nearest = Math.min(a.w, b.w) - radius;
    // Behind the camera there is no place on the screen.
    if (nearest <= 0) {
      this.#tiles.markAll();
      return;
    }
    const margin = (STRETCH * radius * this.#focal) / nearest + pixels + EDGE;
    this.#tiles.markLine(this.#x(a), this.#y(a), this.#x(b), this.#y(b), margin);
  };

  /** Adds the box around a mesh as its longest axis, within the distance of the corners from its ends. */
  #addBox(object: Object3D): void {
    const geometry = (object as Partial<Mesh>).geometry;
    if (!geometry) return;
    if (!geometry.boundingBox) geometry.computeBoundingBox();
    const box = this.#box.copy(geometry.boundingBox!);
    if (box.isEmpty()) return;
    const size = box.getSize(this.#corner).toArray();
    const axis = size.indexOf(Math.max(...size));
    const [from, to] = this.#ends;
    box.getCenter(from);
    box.getCenter(to);
    from.setComponent(axis, box.min.getComponent(axis));
    to.setComponent(axis, box.max.getComponent(axis));
    const { matrixWorld } = object;
    const aside = size.map((length, k) => (k === axis ? 0 : length / 2));
    const radius = Math.hypot(...aside) * matrixWorld.getMaxScaleOnAxis();
    this.#add(from.applyMatrix4(matrixWorld), to.applyMatrix4(matrixWorld), radius, 0);
  }

  #x({ x, w }: Vector4): number {
    return (0.5 + (0.5 * x) / w) * this.#width;
  }

  #y({ y, w }: Vector4): number {
    return (0.5 + (0.5 * y) / w) * this.#height;
  }
}
