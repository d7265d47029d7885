/** Camera poses, and the pose from which a table fills the picture. */

import { MathUtils, type PerspectiveCamera, Vector3 } from "three";

/** A camera that looks at a point. */
export interface Pose {
  target: Vector3;
  /** Direction from the target to the camera: counter-clockwise from +x, and from straight up, rad. */
  azimuth: number;
  polar: number;
  /** From the target, m. */
  distance: number;
  /** Vertical field of view, rad. */
  fov: number;
}

/** A box, m. */
export interface Box {
  min: readonly [number, number, number];
  max: readonly [number, number, number];
}

/** Field of view from above, rad: so narrow that the perspective is hardly visible. */
export const TOP_FOV = 0.14;
/** Field of view of the other cameras, rad. */
export const WIDE_FOV = 0.62;
/** Margin on each side, as a share of the picture's width and height. */
const MARGIN = 0.02;
/** Depth below the slate that the oblique view includes, m. */
const APRON = 0.12;
/** Least angle of the camera behind the cue above the horizontal, and above the cue, rad. */
const SHOULDER = 0.37;
const OVER_CUE = 0.2;

/** The table lies only where it is then larger than upright by this factor; on a square it is upright. */
const LYING = 1.05;

/** From above; the long axis is vertical, unless a wide picture shows a lying table larger. */
export function top(box: Box, aspect: number): Pose {
  const across = fit(box, { azimuth: 0, polar: 0, fov: TOP_FOV }, aspect);
  const upright = fit(box, { azimuth: -Math.PI / 2, polar: 0, fov: TOP_FOV }, aspect);
  return LYING * across.distance < upright.distance ? across : upright;
}

/** From the side, turned a little; on upright screens from the head of the table. */
export function oblique(box: Box, aspect: number): Pose {
  // Include a part of the body below the rails.
  const { min, max } = box;
  const body: Box = { min: [min[0], min[1], min[2] - APRON], max };
  const across = top(box, aspect).azimuth === 0;
  return across
    ? fit(body, { azimuth: -0.3, polar: 0.86, fov: WIDE_FOV }, aspect)
    : fit(body, { azimuth: -Math.PI / 2, polar: 0.55, fov: WIDE_FOV }, aspect);
}

/**
 * The shooter's view: behind the ball at `center` (m), along the cue's direction, above the cue.
 *
 * @param azimuth - The cue's direction, rad; `elevation`: the elevation of its butt, rad.
 */
export function behind(
  center: Vector3,
  { azimuth, elevation }: { azimuth: number; elevation: number },
  aspect: number,
): Pose {
  const above = Math.max(SHOULDER, elevation + OVER_CUE);
  const polar = Math.max(0.1, Math.PI / 2 - above);
  const ahead = 0.42 * Math.sin(polar);
  return {
    target: new Vector3(Math.cos(azimuth), Math.sin(azimuth), 0).multiplyScalar(ahead).add(center),
    azimuth: azimuth + Math.PI,
    polar,
    distance: aspect < 1 ? 1.9 : 1.35,
    fov: 0.8,
  };
}

/** The nearest pose from a direction that shows the whole box, centred. */
export function fit(box: Box, view: Pick<Pose, "azimuth" | "polar" | "fov">, aspect: number): Pose {
  const { azimuth, polar, fov } = view;
  const out = outward(azimuth, polar);
  const up = upward(azimuth, polar);
  const right = new Vector3().crossVectors(up, out);
  const middle = new Vector3(...box.min).add(new Vector3(...box.max)).multiplyScalar(0.5);
  const tangent = Math.tan(fov / 2) * (1 - 2 * MARGIN);
  // A corner at `depth` towards the camera and `aside` in the picture is inside if the distance is at
  // least depth ± (aside − shift) / tangent. The best shift makes the two worst corners equal.
  let distance = 0;
  for (const [axis, slope] of [
    [right, tangent * aspect],
    [up, tangent],
  ] as const) {
    let [plus, minus] = [-Infinity, -Infinity];
    for (const corner of corners(box)) {
      corner.sub(middle);
      const depth = corner.dot(out);
      const aside = corner.dot(axis);
      plus = Math.max(plus, depth + aside / slope);
      minus = Math.max(minus, depth - aside / slope);
    }
    distance = Math.max(distance, (plus + minus) / 2);
    axis.multiplyScalar(((plus - minus) * slope) / 2);
  }
  return { target: middle.add(right).add(up), azimuth, polar, distance, fov };
}

/** Applies a pose to a camera. Nothing within `radius` (m) of the target is clipped. */
export function apply(pose: Pose, camera: PerspectiveCamera, radius: number): void {
  const { target, azimuth, polar, distance, fov } = pose;
  camera.up.copy(upward(azimuth, polar));
  camera.position.copy(target).addScaledVector(outward(azimuth, polar), distance);
  camera.lookAt(target);
  camera.fov = MathUtils.radToDeg(fov);
  camera.near = Math.max(0.04, distance - radius);
  // The user may move further away.
  camera.far = 3 * distance + radius;
  camera.updateProjectionMatrix();
  camera.updateMatrixWorld();
}

/** Interpolates two poses, `t` from 0 to 1, so that sizes in the picture change at a constant rate. */
export function between(a: Pose, b: Pose, t: number): Pose {
  const mix = (from: number, to: number): number => from + (to - from) * t;
  const turn = Math.atan2(Math.sin(b.azimuth - a.azimuth), Math.cos(b.azimuth - a.azimuth));
  const fov = mix(a.fov, b.fov);
  const height = (pose: Pose): number => Math.log(pose.distance * Math.tan(pose.fov / 2));
  return {
    target: a.target.clone().lerp(b.target, t),
    azimuth: a.azimuth + turn * t,
    polar: mix(a.polar, b.polar),
    distance: Math.exp(mix(height(a), height(b))) / Math.tan(fov / 2),
    fov,
  };
}

/** The pose of a camera that looks at `target`. */
export function poseOf(camera: PerspectiveCamera, target: Vector3): Pose {
  const away = camera.position.clone().sub(target);
  const distance = away.length();
  return {
    target: target.clone(),
    azimuth: Math.atan2(away.y, away.x),
    polar: Math.acos(Math.min(1, Math.max(-1, away.z / distance))),
    distance,
    fov: MathUtils.degToRad(camera.fov),
  };
}

function outward(azimuth: number, polar: number): Vector3 {
  const level = Math.sin(polar);
  return new Vector3(level * Math.cos(azimuth), level * Math.sin(azimuth), Math.cos(polar));
}

/** The up direction of the picture, defined even if the camera looks straight down. */
function upward(azimuth: number, polar: number): Vector3 {
  const level = Math.cos(polar);
  return new Vector3(-level * Math.cos(azimuth), -level * Math.sin(azimuth), Math.sin(polar));
}

function corners({ min, max }: Box): Vector3[] {
  return [min[0], max[0]].flatMap((x) =>
    [min[1], max[1]].flatMap((y) => [min[2], max[2]].map((z) => new Vector3(x, y, z))),
  );
}
