/** One camera for the three views: it flies between their poses; the user turns the orbit view. */

import { PerspectiveCamera, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { CameraMode } from "../viewer-types.ts";
import { apply, behind, between, type Box, oblique, type Pose, poseOf, top } from "./pose.ts";

/** Duration of a flight, ms. */
const FLIGHT = 650;
/** Range of the angle between camera and vertical for the user, rad. */
const POLAR = [0.02, 1.5] as const;
/** Cosines of the angle between the view and the vertical: from the side, and from above. */
const ABOVE = [0.88, 0.98] as const;
/** Least distance of the camera from its target for the user, m. */
const NEAREST = 0.25;

export class Rig {
  readonly camera = new PerspectiveCamera();
  readonly #controls: OrbitControls;
  readonly #reducedMotion: boolean;
  #mode: CameraMode = "top";
  #box: Box = { min: [0, 0, 0], max: [1, 1, 1] };
  #aspect = 1;
  /** Centre of the ball that is aimed at, m, and the cue's direction, rad. */
  #aim: { center: Vector3; azimuth: number; elevation: number } | null = null;
  #flight: { from: Pose; start: number } | null = null;
  #pose: Pose = top(this.#box, 1);
  #enabled = true;
  /** Whether the user has left the standard orbit view. */
  #moved = false;

  /**
   * @param changed - Called when the user has moved the camera.
   */
  constructor(element: HTMLElement, reducedMotion: boolean, changed: () => void) {
    this.#reducedMotion = reducedMotion;
    this.camera.up.set(0, 0, 1);
    this.#controls = new OrbitControls(this.camera, element);
    this.#controls.enabled = false;
    this.#controls.enableDamping = !reducedMotion;
    this.#controls.dampingFactor = 0.12;
    [this.#controls.minPolarAngle, this.#controls.maxPolarAngle] = POLAR;
    this.#controls.minDistance = NEAREST;
    this.#controls.addEventListener("change", changed);
    this.#controls.addEventListener("start", () => (this.#moved = true));
  }

  get mode(): CameraMode {
    return this.#mode;
  }

  /** Whether a flight is in progress. */
  get flying(): boolean {
    return this.#flight !== null;
  }

  /** Whether the user can turn the orbit view. */
  get enabled(): boolean {
    return this.#enabled;
  }

  set enabled(enabled: boolean) {
    this.#enabled = enabled;
    this.#controls.enabled = enabled && this.#mode === "orbit" && !this.#flight;
  }

  /** Side of the table at the bottom of the view from above, rad from +x. */
  get side(): number {
    return top(this.#box, this.#aspect).azimuth;
  }

  /** 1 if the camera looks down on the table, 0 if it looks from the side. */
  get above(): number {
    const cosine = this.camera.matrixWorld.elements[10];
    return Math.min(1, Math.max(0, (cosine - ABOVE[0]) / (ABOVE[1] - ABOVE[0])));
  }

  setMode(mode: CameraMode, instant: boolean, now: number): void {
    this.#mode = mode;
    this.#go(instant, now);
  }

  /** The standard view of the present mode. */
  reset(now: number): void {
    this.#go(false, now);
  }

  setBox(box: Box): void {
    this.#box = box;
    this.#follow();
  }

  setAspect(aspect: number): void {
    this.#aspect = aspect;
    this.camera.aspect = aspect;
    this.camera.updateProjectionMatrix();
    this.#follow();
  }

  /** Sets the cue for the view behind it: its ball's centre (m) and angles (rad). */
  setAim(center: Vector3, { azimuth, elevation }: { azimuth: number; elevation: number }): void {
    this.#aim = { center: center.clone(), azimuth, elevation };
    if (this.#mode === "cue") this.#follow();
  }

  /** Advances a flight; call it before every picture. */
  update(now: number): void {
    if (this.#flight) {
      const t = Math.min(1, (now - this.#flight.start) / FLIGHT);
      const eased = t * t * (3 - 2 * t);
      this.#set(between(this.#flight.from, this.#goal(), eased));
      if (t === 1) this.#land();
    } else if (this.#controls.enabled) {
      this.#controls.update();
    }
  }

  dispose(): void {
    this.#controls.dispose();
  }

  #goal(): Pose {
    if (this.#mode === "cue" && this.#aim) {
      return behind(this.#aim.center, this.#aim, this.#aspect);
    }
    return this.#mode === "top" ? top(this.#box, this.#aspect) : oblique(this.#box, this.#aspect);
  }

  #go(instant: boolean, now: number): void {
    const from = this.#moved ? poseOf(this.camera, this.#controls.target) : this.#pose;
    this.#controls.enabled = false;
    this.#moved = false;
    if (instant || this.#reducedMotion) this.#land();
    else this.#flight = { from, start: now };
  }

  #land(): void {
    this.#flight = null;
    this.#set(this.#goal());
    if (this.#mode !== "orbit") return;
    // From now on the user turns it about the vertical.
    this.camera.up.set(0, 0, 1);
    this.#controls.target.copy(this.#pose.target);
    this.#controls.maxDistance = 2.5 * this.#pose.distance;
    this.#controls.enabled = this.#enabled;
    this.#controls.update();
  }

  /** Updates the pose after a change, unless a flight or the user determines it. */
  #follow(): void {
    if (!this.#flight && !(this.#mode === "orbit" && this.#moved)) this.#land();
  }

  #set(pose: Pose): void {
    this.#pose = pose;
    const { min, max } = this.#box;
    const radius = Math.hypot(max[0] - min[0], max[1] - min[1], 2) + 1;
    apply(pose, this.camera, radius);
  }
}
