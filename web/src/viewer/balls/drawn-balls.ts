/** The balls: places, orientations and shadows. */

import { type Camera, Group, Matrix4, Quaternion, Vector3 } from "three";
import { STRIDE } from "../../engine/types.ts";
import type { Light } from "../lighting.ts";
import { FLOOR } from "../table/solid.ts";
import { kindOf } from "../theme-colors.ts";
import {
  type BallInfo,
  type Geometry,
  MOTION,
  OFF_TABLE,
  ORIENTATION,
  POCKETED,
  SPIN,
  VELOCITY,
} from "../viewer-types.ts";
import { type Look, look } from "./look.ts";
import { Shadows } from "./shadows.ts";
import { Spheres } from "./spheres.ts";

/** Angle between the number of an unrotated ball and the vertical, towards the viewer, rad. */
const LEAN = 0.3;
/**
 * Speeds of a ball's surface, m/s: from above, the number of a slower ball faces the viewer; a faster
 * ball shows its true orientation. A ball rolls from the second to the first in about a second.
 */
const CALM = [0.02, 0.15] as const;

/** A ball in the scene. */
interface Body {
  info: BallInfo;
  look: Look;
  /** Drawn centre, m. */
  center: Vector3;
  /** From the ball's axes at time 0 to the table's. */
  orientation: Quaternion;
  visible: boolean;
  /** 1 for a ball at rest with a number, 0 for a fast one. */
  calm: number;
}

/** All balls of a shot. */
export class Balls {
  readonly group = new Group();
  readonly #spheres = new Spheres();
  readonly #shadows = new Shadows();
  #bodies: Body[] = [];
  #under: (x: number, y: number) => number | null = () => 0;
  /** Orientations of an unrotated ball, and of one whose number faces a viewer above. */
  readonly #rest = facing(0, LEAN);
  readonly #upright = facing(0, 0);
  #viewer = 0;
  #above = 1;
  readonly #turn = new Quaternion();

  constructor() {
    this.group.add(this.#spheres.mesh, this.#shadows.mesh);
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
    return this.#bodies[ball]!.center;
  }

  visible(ball: number): boolean {
    return this.#bodies[ball]?.visible ?? false;
  }

  /** Replaces the balls. */
  setBalls(balls: readonly BallInfo[], geometry: Geometry): void {
    const carom = kindOf(geometry.physics) === "carom";
    const before = this.#bodies.map((body) => key(body.look)).join();
    this.#bodies = balls.map((info, index) => ({
      info,
      look: look(info.id, index, carom),
      center: new Vector3().fromArray(info.position),
      orientation: new Quaternion(),
      visible: true,
      calm: 1,
    }));
    const looks = this.looks;
    if (looks.map(key).join() !== before) this.#spheres.setLooks(looks);
    const old = this.#shadows.mesh;
    if (this.#shadows.reserve(balls.length)) this.group.remove(old).add(this.#shadows.mesh);
    this.#under = ground(geometry);
    this.#place();
  }

  /** Moves all balls: `STRIDE` numbers each. */
  setStates(states: Float64Array): void {
    this.#bodies.forEach((body, i) => {
      const at = i * STRIDE;
      const motion = states[at + MOTION];
      body.visible = motion !== POCKETED;
      body.center.fromArray(states, at);
      if (motion === OFF_TABLE) body.center.z = body.info.radius - FLOOR;
      body.orientation.fromArray(states, at + ORIENTATION);
      const speed = size(states, at + VELOCITY);
      body.calm = calm(Math.max(speed, body.info.radius * size(states, at + SPIN)));
    });
    this.#place();
  }

  /**
   * Turns the numbers upright for a viewer in the direction `azimuth` (rad).
   *
   * @param above - 1 if the viewer is above the table, 0 if beside it.
   */
  setViewer(azimuth: number, above: number): void {
    if (azimuth === this.#viewer && above === this.#above) return;
    this.#viewer = azimuth;
    this.#above = above;
    this.#rest.copy(facing(azimuth, LEAN));
    this.#upright.copy(facing(azimuth, 0));
    this.#place();
  }

  /** With shadow maps the soft shadow is weaker. */
  setShadows(real: boolean): void {
    this.#shadows.mapped = real;
    this.#spheres.mesh.castShadow = real;
  }

  setLight(light: Light): void {
    this.#spheres.setLight(light);
  }

  /** Pixels per unit of length at distance one from the camera. */
  set pixels(pixels: number) {
    this.#spheres.pixels = pixels;
  }

  /** Height of the surface below a place, m; null over a pocket and beyond the table. */
  floor(x: number, y: number): number | null {
    return this.#under(x, y);
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
    for (const [ball, body] of this.#bodies.entries()) {
      if (!body.visible) continue;
      center.copy(body.center).project(camera);
      if (Math.abs(center.z) > 1) continue;
      edge.copy(body.center).addScaledVector(right, body.info.radius).project(camera);
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
    this.#spheres.dispose();
    this.#shadows.dispose();
  }

  #place(): void {
    this.#bodies.forEach((body, i) => {
      const { center, info, visible } = body;
      this.#turn.copy(body.orientation).multiply(this.#rest);
      const upright = body.look.label === "" ? 0 : body.calm * this.#above;
      if (upright > 0) this.#turn.slerp(this.#upright, upright);
      if (visible) this.#spheres.place(i, center, info.radius, this.#turn);
      else this.#spheres.hide(i);
      const floor = visible ? this.#under(center.x, center.y) : null;
      this.#shadows.place(i, center, info.radius, floor);
    });
    this.#spheres.commit();
    this.#shadows.commit();
  }
}

/**
 * Orientation of a ball whose number leans by `lean` (rad) from up towards a viewer in the direction
 * `azimuth` (rad) from the table, and is upright for that viewer.
 */
function facing(azimuth: number, lean: number): Quaternion {
  // Maps the number's normal to up, and the top of its text away from a viewer in the direction +x.
  const upright = new Matrix4().makeBasis(
    new Vector3(0, 1, 0),
    new Vector3(-1, 0, 0),
    new Vector3(0, 0, 1),
  );
  return new Quaternion()
    .setFromAxisAngle(new Vector3(0, 0, 1), azimuth)
    .multiply(new Quaternion().setFromAxisAngle(new Vector3(0, 1, 0), lean))
    .multiply(new Quaternion().setFromRotationMatrix(upright));
}

/** 1 below the slower speed of `CALM`, 0 above the faster, smooth between. */
export function calm(speed: number): number {
  const t = Math.min(1, Math.max(0, (speed - CALM[0]) / (CALM[1] - CALM[0])));
  return 1 - t * t * (3 - 2 * t);
}

function size(states: Float64Array, at: number): number {
  return Math.hypot(states[at]!, states[at + 1]!, states[at + 2]!);
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
