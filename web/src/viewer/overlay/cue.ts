/** The cue stick. */

import {
  BufferGeometry,
  Color,
  Float32BufferAttribute,
  LatheGeometry,
  Mesh,
  MeshPhongMaterial,
  Vector2,
  Vector3,
} from "three";
import { reach } from "../table/table-outline.ts";
import type { CuePose, Geometry } from "../viewer-types.ts";

/** Parts from tip to butt: length (m), colour. */
const PARTS: readonly (readonly [number, string])[] = [
  [0.012, "#3d6ea5"],
  [0.024, "#efe9dc"],
  [0.7, "#d9b576"],
  [0.012, "#b8a070"],
  [0.3, "#4a2d1b"],
  [0.28, "#22252a"],
  [0.13, "#4a2d1b"],
  [0.02, "#1a1a1a"],
];
/** Radius at the tip and at the butt, m. */
const TIP_RADIUS = 0.0062;
const BUTT_RADIUS = 0.0145;
const LENGTH = PARTS.reduce((sum, [length]) => sum + length, 0);
/** Gap between the shaft and the rail below, m. */
const CLEARANCE = 0.004;

export class Cue {
  readonly mesh: Mesh<BufferGeometry, MeshPhongMaterial>;
  readonly #direction = new Vector3();

  constructor() {
    this.mesh = new Mesh(
      stick(),
      new MeshPhongMaterial({ vertexColors: true, shininess: 70, specular: 0x33302c }),
    );
    this.mesh.castShadow = true;
    this.mesh.visible = false;
  }

  /**
   * Places the cue: the centre of its tip is `pull` behind the contact point.
   *
   * @param center - Centre of the ball, m.
   * @param radius - Its radius, m.
   */
  place(cue: CuePose, center: Vector3, radius: number, geometry: Geometry): void {
    const contact = contactPoint(cue, radius).add(center);
    const elevation = Math.max(cue.elevation, clearance(cue.azimuth, contact, geometry));
    aim(cue.azimuth, elevation, this.#direction);
    this.mesh.position.copy(contact).addScaledVector(this.#direction, -cue.pull);
    // The mesh extends from the tip along its own −y axis.
    this.mesh.quaternion.setFromUnitVectors(new Vector3(0, 1, 0), this.#direction);
    this.mesh.visible = true;
  }

  hide(): void {
    this.mesh.visible = false;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}

/**
 * The contact point of the tip relative to the ball's centre, m. `side` and `height` are offsets in the
 * plane perpendicular to the cue's axis.
 */
export function contactPoint(cue: CuePose, radius: number): Vector3 {
  const { azimuth, elevation, side, height } = cue;
  const axis = aim(azimuth, elevation, new Vector3());
  const right = new Vector3(Math.sin(azimuth), -Math.cos(azimuth), 0);
  const up = new Vector3().crossVectors(right, axis);
  const depth = Math.sqrt(Math.max(0, 1 - side * side - height * height));
  return right
    .multiplyScalar(side)
    .addScaledVector(up, height)
    .addScaledVector(axis, -depth)
    .multiplyScalar(radius);
}

/**
 * The least elevation, rad, at which the drawn cue clears the rail behind it. The drawing uses it even if
 * the shot file has a lower elevation, so that the cue is not drawn through the wood.
 */
export function clearance(azimuth: number, contact: Vector3, geometry: Geometry): number {
  if (!geometry.size) return 0;
  const toNose = reach(contact, azimuth + Math.PI, geometry.size);
  // The outer edge is further away than the nose, but there the cue is thicker.
  const distances = [toNose, toNose + (geometry.rail_width ?? 0)];
  const needed = distances.map((distance) => {
    if (distance >= LENGTH) return 0;
    const thickness = TIP_RADIUS + ((BUTT_RADIUS - TIP_RADIUS) * distance) / LENGTH;
    const rise = geometry.cushion_height + thickness + CLEARANCE - contact.z;
    return Math.atan2(rise, Math.max(distance, 1e-3));
  });
  return Math.max(0, ...needed);
}

function aim(azimuth: number, elevation: number, out: Vector3): Vector3 {
  const level = Math.cos(elevation);
  return out.set(level * Math.cos(azimuth), level * Math.sin(azimuth), -Math.sin(elevation));
}

function stick(): BufferGeometry {
  const profile: Vector2[] = [new Vector2(0.001, 0), new Vector2(TIP_RADIUS * 0.75, -0.0015)];
  const tints: string[] = [PARTS[0]![1], PARTS[0]![1]];
  let at = 0;
  for (const [length, tint] of PARTS) {
    // Two rings at each joint, so that the colours do not blend.
    for (const end of [at + (at === 0 ? 0.003 : 0), at + length]) {
      profile.push(new Vector2(TIP_RADIUS + ((BUTT_RADIUS - TIP_RADIUS) * end) / LENGTH, -end));
      tints.push(tint);
    }
    at += length;
  }
  profile.push(new Vector2(0.001, -at - 0.004));
  tints.push(PARTS.at(-1)![1]);
  const segments = 20;
  const geometry = new LatheGeometry(profile, segments);
  const color = new Color();
  const colors: number[] = [];
  for (let i = 0; i <= segments; i += 1) {
    for (const tint of tints) colors.push(...color.set(tint).toArray());
  }
  geometry.setAttribute("color", new Float32BufferAttribute(colors, 3));
  return geometry;
}
