/** Ambient light, and a lamp whose slanted shadows show the height of a ball. */

import { Color, DirectionalLight, Group, HemisphereLight, Vector3 } from "three";
import type { Box } from "./camera/pose.ts";
import type { Palette } from "./theme-colors.ts";

/** Direction of the lamp's light. */
const DIRECTION = new Vector3(-0.3, 0.42, -1);
/** Shift of a shadow along x and y, per height of its ball. */
export const SLANT: readonly [number, number] = [
  -DIRECTION.x / DIRECTION.z,
  -DIRECTION.y / DIRECTION.z,
];
/** Distance of the lamp from the centre of the table, m: above everything that casts a shadow. */
const DISTANCE = 4;
/** Side of the shadow map, texels: 2 mm each on a large table. */
const SHADOW_MAP = 2048;

/** The light as shaders need it: irradiance (linear), and the direction to the lamp. */
export interface Light {
  sky: Color;
  ground: Color;
  lamp: Color;
  toLamp: Vector3;
}

export class Lighting {
  readonly group = new Group();
  readonly #sky = new HemisphereLight(0xffffff, 0x6b675f);
  readonly #lamp = new DirectionalLight(0xfff4e2);

  constructor() {
    const { shadow } = this.#lamp;
    shadow.mapSize.set(SHADOW_MAP, SHADOW_MAP);
    shadow.radius = 3;
    shadow.normalBias = 0.002;
    shadow.intensity = 0.75;
    this.#sky.position.set(0, 0, 1);
    for (const light of [this.#sky, this.#lamp]) light.layers.enableAll();
    this.group.add(this.#sky, this.#lamp, this.#lamp.target);
  }

  set shadows(cast: boolean) {
    this.#lamp.castShadow = cast;
  }

  setPalette({ ambient, lamp }: Palette): void {
    this.#sky.intensity = ambient;
    this.#lamp.intensity = lamp;
  }

  get light(): Light {
    const { color, groundColor, intensity } = this.#sky;
    return {
      sky: color.clone().multiplyScalar(intensity),
      ground: groundColor.clone().multiplyScalar(intensity),
      lamp: this.#lamp.color.clone().multiplyScalar(this.#lamp.intensity),
      toLamp: DIRECTION.clone().normalize().negate(),
    };
  }

  /** Fits the shadow map to the table. */
  fit({ min, max }: Box): void {
    const [x, y] = [(min[0] + max[0]) / 2, (min[1] + max[1]) / 2];
    const span = Math.hypot(max[0] - min[0], max[1] - min[1]) / 2;
    const back = DIRECTION.clone().setLength(-DISTANCE);
    this.#lamp.target.position.set(x, y, 0);
    this.#lamp.position.set(x, y, 0).add(back);
    const { camera } = this.#lamp.shadow;
    [camera.left, camera.right, camera.bottom, camera.top] = [-span, span, -span, span];
    [camera.near, camera.far] = [Math.max(0.1, DISTANCE - span), DISTANCE + span];
    camera.updateProjectionMatrix();
  }

  dispose(): void {
    this.#lamp.dispose();
    this.#sky.dispose();
  }
}
