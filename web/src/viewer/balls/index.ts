/** The balls: meshes with their skins, and soft shadows below them. */

import {
  BufferGeometry,
  type Camera,
  CanvasTexture,
  type CubeTexture,
  Group,
  InstancedMesh,
  Matrix4,
  Mesh,
  MeshBasicMaterial,
  MeshPhongMaterial,
  PlaneGeometry,
  Quaternion,
  SphereGeometry,
  Vector3,
} from "three";
import { FLOOR, LAYER } from "../table/solid";
import { kindOf } from "../theme";
import {
  type BallInfo,
  type Geometry,
  MOTION,
  OFF_TABLE,
  ORIENTATION,
  POCKETED,
  STRIDE,
} from "../types";
import { type Look, look } from "./look";
import { skin } from "./skin";

/** Height of a skin's texture, pixels. */
const SKIN = 256;
/** Segments of a sphere around its equator. */
const SEGMENTS = { high: 48, low: 24 };
/** Angle between a ball's number and the vertical, towards the viewer, rad. */
const LEAN = 0.3;

/**
 * Rotation of a skin on a ball whose orientation is the identity. The number faces up, leans towards a
 * viewer in the direction `azimuth` (rad) from the table, and is upright for that viewer.
 */
function facing(azimuth: number): Quaternion {
  // Maps the number's normal to up, and the top of its text away from a viewer in the direction +x.
  const upright = new Matrix4().makeBasis(
    new Vector3(0, 1, 0),
    new Vector3(-1, 0, 0),
    new Vector3(0, 0, 1),
  );
  return new Quaternion()
    .setFromAxisAngle(new Vector3(0, 0, 1), azimuth)
    .multiply(new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), LEAN))
    .multiply(new Quaternion().setFromRotationMatrix(upright));
}

/** Radius of a ball's soft shadow, ball radii, and its darkness. */
const BLOB = 1.55;
const DARKNESS = 0.62;
/** Height of a ball above the cloth at which the area of its shadow has doubled, m. */
const FADE_HEIGHT = 0.25;

/** A ball in the scene. */
interface Body {
  info: BallInfo;
  look: Look;
  mesh: Mesh<BufferGeometry, MeshPhongMaterial>;
}

/** All balls of a shot. */
export class Balls {
  readonly group = new Group();
  readonly #environment: CubeTexture;
  readonly #spheres = {
    high: sphere(SEGMENTS.high),
    low: sphere(SEGMENTS.low),
  };
  readonly #blobMaterial = new MeshBasicMaterial({
    map: blob(),
    transparent: true,
    depthWrite: false,
    polygonOffset: true,
    polygonOffsetFactor: -3,
  });
  readonly #plane = new PlaneGeometry(2, 2);
  #blobs: InstancedMesh | null = null;
  #bodies: Body[] = [];
  #detail: "high" | "low" = "high";
  #viewer = 0;
  readonly #facing = facing(0);
  #under: (x: number, y: number) => number | null = () => 0;
  readonly #matrix = new Matrix4();
  /** Shift of a shadow along x and y, per height of its ball. */
  readonly #slant: readonly [number, number];

  /**
   * @param environment - The environment that balls reflect.
   * @param slant - Shift of a shadow along x and y, per height of its ball.
   */
  constructor(environment: CubeTexture, slant: readonly [number, number]) {
    this.#environment = environment;
    this.#slant = slant;
  }

  /** The looks in the order of the shot. */
  get looks(): readonly Look[] {
    return this.#bodies.map((body) => body.look);
  }

  get count(): number {
    return this.#bodies.length;
  }

  info(ball: number): BallInfo {
    return this.#bodies[ball]!.info;
  }

  /** Drawn centre of a ball, m. */
  center(ball: number): Vector3 {
    return this.#bodies[ball]!.mesh.position;
  }

  visible(ball: number): boolean {
    return this.#bodies[ball]?.mesh.visible ?? false;
  }

  /** Replaces the balls; meshes with the same look are reused. */
  setBalls(balls: readonly BallInfo[], geometry: Geometry): void {
    const carom = kindOf(geometry.physics) === "carom";
    const kept = new Map(this.#bodies.map((body) => [key(body.look), body]));
    const old = new Set(this.#bodies);
    this.#bodies = balls.map((info, index) => {
      const appearance = look(info.id, index, carom);
      const again = kept.get(key(appearance));
      if (again && old.delete(again)) {
        again.mesh.scale.setScalar(info.radius);
        return { ...again, info, look: appearance };
      }
      return this.#create(info, appearance);
    });
    for (const body of old) this.#remove(body);
    this.#under = ground(geometry);
    if (this.#blobs?.count !== balls.length) this.#makeBlobs(balls.length);
    this.#bodies.forEach(({ info, mesh }) => {
      mesh.position.set(...info.position);
      mesh.quaternion.copy(this.#facing);
      mesh.visible = true;
    });
    this.#placeBlobs();
  }

  /** Moves all balls: `STRIDE` numbers each. */
  setStates(states: Float64Array): void {
    for (let i = 0; i < this.#bodies.length; i += 1) {
      const { mesh, info } = this.#bodies[i]!;
      const at = i * STRIDE;
      const motion = states[at + MOTION];
      mesh.visible = motion !== POCKETED;
      mesh.position.set(states[at]!, states[at + 1]!, states[at + 2]);
      if (motion === OFF_TABLE) mesh.position.z = info.radius - FLOOR;
      const q = at + ORIENTATION;
      mesh.quaternion.set(states[q]!, states[q + 1]!, states[q + 2]!, states[q + 3]!);
      mesh.quaternion.multiply(this.#facing);
    }
    this.#placeBlobs();
  }

  /** Turns the numbers of unrotated balls upright for a viewer in the direction `azimuth` (rad). */
  setViewer(azimuth: number): void {
    if (azimuth === this.#viewer) return;
    this.#viewer = azimuth;
    const undo = this.#facing.clone().invert();
    this.#facing.copy(facing(azimuth));
    for (const { mesh } of this.#bodies) mesh.quaternion.multiply(undo).multiply(this.#facing);
  }

  /** With shadow maps the soft shadow is weaker: it only darkens the contact of ball and cloth. */
  setShadows(real: boolean): void {
    this.#blobMaterial.opacity = real ? 0.55 : 1;
    for (const { mesh } of this.#bodies) mesh.castShadow = real;
  }

  setDetail(detail: "high" | "low"): void {
    this.#detail = detail;
    for (const { mesh } of this.#bodies) mesh.geometry = this.#spheres[detail];
  }

  /**
   * The ball at a point of the screen; null if there is none.
   *
   * @param camera - The camera of the picture.
   * @param x - Normalized device coordinate, −1 to 1; `y` likewise.
   * @param reach - Least radius around a ball's centre in which it is found, pixels.
   * @param screen - Width and height, pixels.
   */
  at(
    camera: Camera,
    x: number,
    y: number,
    reach: number,
    screen: readonly [number, number],
  ): number | null {
    let best: number | null = null;
    let least = Infinity;
    const center = new Vector3();
    const edge = new Vector3();
    const right = new Vector3().setFromMatrixColumn(camera.matrixWorld, 0);
    for (const [ball, { mesh, info }] of this.#bodies.entries()) {
      if (!mesh.visible) continue;
      center.copy(mesh.position).project(camera);
      if (Math.abs(center.z) > 1) continue;
      edge.copy(mesh.position).addScaledVector(right, info.radius).project(camera);
      const radius = Math.max(reach, ((edge.x - center.x) * screen[0]) / 2);
      const distance = Math.hypot(
        ((center.x - x) * screen[0]) / 2,
        ((center.y - y) * screen[1]) / 2,
      );
      if (distance <= radius && distance / radius < least) {
        least = distance / radius;
        best = ball;
      }
    }
    return best;
  }

  dispose(): void {
    for (const body of this.#bodies) this.#remove(body);
    this.#bodies = [];
    this.#blobs?.dispose();
    this.#blobMaterial.map?.dispose();
    this.#blobMaterial.dispose();
    this.#plane.dispose();
    this.#spheres.high.dispose();
    this.#spheres.low.dispose();
  }

  #create(info: BallInfo, appearance: Look): Body {
    const material = new MeshPhongMaterial({
      map: skin(appearance, SKIN),
      shininess: 140,
      specular: 0x555555,
      envMap: this.#environment,
      reflectivity: 0.16,
    });
    const mesh = new Mesh(this.#spheres[this.#detail], material);
    mesh.scale.setScalar(info.radius);
    mesh.castShadow = true;
    this.group.add(mesh);
    return { info, look: appearance, mesh };
  }

  #remove({ mesh }: Body): void {
    this.group.remove(mesh);
    mesh.material.map?.dispose();
    mesh.material.dispose();
  }

  #makeBlobs(count: number): void {
    if (this.#blobs) {
      this.group.remove(this.#blobs);
      this.#blobs.dispose();
    }
    this.#blobs = new InstancedMesh(this.#plane, this.#blobMaterial, count);
    this.#blobs.frustumCulled = false;
    this.group.add(this.#blobs);
  }

  #placeBlobs(): void {
    const blobs = this.#blobs;
    if (!blobs) return;
    const [slantX, slantY] = this.#slant;
    this.#bodies.forEach(({ mesh, info }, i) => {
      const { x, y, z } = mesh.position;
      const floor = this.#under(x, y);
      const height = floor === null ? 0 : z - info.radius - floor;
      const hidden = !mesh.visible || floor === null || height < -info.radius;
      // The shadow grows with the height of its ball.
      const size = hidden ? 0 : BLOB * info.radius * (1 + Math.max(0, height) / FADE_HEIGHT) ** 0.5;
      this.#matrix.makeScale(size, size, 1);
      this.#matrix.setPosition(
        x + slantX * (height + info.radius),
        y + slantY * (height + info.radius),
        (floor ?? 0) + LAYER,
      );
      blobs.setMatrixAt(i, this.#matrix);
    });
    blobs.instanceMatrix.needsUpdate = true;
  }
}

/** Height of the surface below a place, m; null over a pocket and beyond the table. */
export function ground(geometry: Geometry): (x: number, y: number) => number | null {
  const { size, pockets, cushion_height: top, rail_width: rail = 0 } = geometry;
  if (!size) return () => 0;
  const [width, length] = size;
  return (x, y) => {
    const beyond = Math.max(-x, x - width, -y, y - length);
    if (beyond > rail) return null;
    for (const { center, radius } of pockets) {
      if (Math.hypot(x - center[0], y - center[1]) < radius) return null;
    }
    return beyond > 0 ? top : 0;
  };
}

function key(appearance: Look): string {
  return Object.values(appearance).join("|");
}

function sphere(segments: number): SphereGeometry {
  return new SphereGeometry(1, segments, segments / 2);
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
