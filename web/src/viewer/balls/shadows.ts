/** Soft shadows of the balls on cloth and wood. */

import {
  CanvasTexture,
  InstancedMesh,
  Matrix4,
  MeshBasicMaterial,
  PlaneGeometry,
  Vector3,
} from "three";
import { SLANT } from "../lighting.ts";
import { setCover } from "../render/extent.ts";
import { LAYER } from "../table/solid.ts";

/** Radius of a shadow, ball radii, and its darkness. */
const RADIUS = 1.55;
const DARKNESS = 0.62;
/** Opacity beside a shadow map: then it only darkens the contact of ball and cloth. */
const WITH_MAP = 0.55;
/** Height of a ball above the cloth at which the area of its shadow has doubled, m. */
const FADE_HEIGHT = 0.25;

export class Shadows {
  mesh: InstancedMesh<PlaneGeometry, MeshBasicMaterial>;
  readonly #material = new MeshBasicMaterial({
    map: blob(),
    transparent: true,
    depthWrite: false,
    polygonOffset: true,
    polygonOffsetFactor: -3,
  });
  readonly #plane = new PlaneGeometry(2, 2);
  readonly #matrix = new Matrix4();

  constructor() {
    this.mesh = this.#create(0);
  }

  /** Makes room for `count` balls. @returns Whether the mesh has been replaced. */
  reserve(count: number): boolean {
    if (this.mesh.count === count) return false;
    this.mesh.dispose();
    this.mesh = this.#create(count);
    return true;
  }

  /**
   * Places the shadow of a ball.
   *
   * @param floor - Height of the surface below, m; null: no shadow.
   */
  place(ball: number, { x, y, z }: Vector3, radius: number, floor: number | null): void {
    const height = floor === null ? 0 : z - radius - floor;
    const hidden = floor === null || height < -radius;
    // The shadow grows with the height of its ball.
    const size = hidden ? 0 : RADIUS * radius * (1 + Math.max(0, height) / FADE_HEIGHT) ** 0.5;
    this.#matrix.makeScale(size, size, 1);
    const [slantX, slantY] = SLANT;
    this.#matrix.setPosition(
      x + slantX * (height + radius),
      y + slantY * (height + radius),
      (floor ?? 0) + LAYER,
    );
    this.mesh.setMatrixAt(ball, this.#matrix);
  }

  commit(): void {
    this.mesh.instanceMatrix.needsUpdate = true;
  }

  /** Whether a shadow map darkens the cloth as well. */
  set mapped(mapped: boolean) {
    this.#material.opacity = mapped ? WITH_MAP : 1;
  }

  dispose(): void {
    this.mesh.dispose();
    this.#plane.dispose();
    this.#material.map?.dispose();
    this.#material.dispose();
  }

  #create(count: number): InstancedMesh<PlaneGeometry, MeshBasicMaterial> {
    const mesh = new InstancedMesh(this.#plane, this.#material, count);
    mesh.frustumCulled = false;
    const center = new Vector3();
    const matrix = new Matrix4();
    setCover(mesh, (add) => {
      for (let ball = 0; ball < count; ball += 1) {
        mesh.getMatrixAt(ball, matrix);
        const size = matrix.elements[0];
        if (size > 0) add(center.setFromMatrixPosition(matrix), center, Math.SQRT2 * size, 0);
      }
    });
    return mesh;
  }
}

/** A dark disc with a soft edge. */
function blob(): CanvasTexture {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const context = canvas.getContext("2d")!;
  const gradient = context.createRadialGradient(32, 32, 0, 32, 32, 32);
  for (let i = 0; i <= 8; i += 1) {
    const t = i / 8;
    gradient.addColorStop(t, `rgba(0, 0, 0, ${DARKNESS * (1 - t * t) ** 1.6})`);
  }
  context.fillStyle = gradient;
  context.fillRect(0, 0, 64, 64);
  return new CanvasTexture(canvas);
}
