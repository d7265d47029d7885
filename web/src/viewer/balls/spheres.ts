/** All balls in one draw call. */

import {
  Color,
  DynamicDrawUsage,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  Float32BufferAttribute,
  Mesh,
  type Quaternion,
  ShaderMaterial,
  Vector3,
} from "three";
import type { Light } from "../lighting.ts";
import { setCover } from "../render/extent.ts";
import { labelTexture } from "./label-texture.ts";
import type { Look } from "./look.ts";
import { FRAGMENT, SHADOW_FRAGMENT, SHADOW_VERTEX, VERTEX } from "./shader.ts";

/** Numbers per ball in each attribute. */
const SIZE = 4;

export class Spheres {
  readonly mesh: Mesh<InstancedBufferGeometry, ShaderMaterial>;
  readonly #uniforms = {
    pixels: { value: 1 },
    labels: { value: labelTexture([]).texture },
    cells: { value: 1 },
    sky: { value: new Color() },
    ground: { value: new Color() },
    lamp: { value: new Color() },
    toLamp: { value: new Vector3() },
  };

  constructor() {
    const material = new ShaderMaterial({
      uniforms: this.#uniforms,
      vertexShader: VERTEX,
      // The camera's matrices are not declared in fragment shaders.
      fragmentShader: `uniform mat4 projectionMatrix;\n#include <common>\n${FRAGMENT}`,
      transparent: true,
    });
    this.mesh = new Mesh(squares(), material);
    this.mesh.customDepthMaterial = new ShaderMaterial({
      vertexShader: SHADOW_VERTEX,
      fragmentShader: SHADOW_FRAGMENT,
    });
    this.mesh.frustumCulled = false;
    // After the shadows on the cloth, before lines and marks.
    this.mesh.renderOrder = 0.5;
    const center = new Vector3();
    setCover(this.mesh, (add) => {
      const balls = this.#attribute("ball");
      for (let ball = 0; ball < balls.count; ball += 1) {
        const radius = balls.getW(ball);
        if (radius > 0) add(center.fromBufferAttribute(balls, ball), center, radius, 0);
      }
    });
  }

  /** Replaces the looks; all balls are hidden until they are placed. */
  setLooks(looks: readonly Look[]): void {
    const { geometry } = this.mesh;
    if (geometry.instanceCount !== looks.length) {
      geometry.dispose();
      this.mesh.geometry = squares(looks.length);
    }
    const labels = [...new Set(looks.map(({ label }) => label).filter((label) => label !== ""))];
    const color = new Color();
    looks.forEach((look, i) => {
      const cell = look.label === "" ? -1 : labels.indexOf(look.label);
      color.set(look.body);
      this.#attribute("body").setXYZW(i, color.r, color.g, color.b, cell);
      const kind = look.striped ? 1 : look.dots ? 2 : 0;
      color.set(look.dots || look.body);
      this.#attribute("extra").setXYZW(i, color.r, color.g, color.b, kind);
      this.hide(i);
    });
    this.#attribute("body").needsUpdate = true;
    this.#attribute("extra").needsUpdate = true;
    this.#uniforms.labels.value.dispose();
    const { texture, cells } = labelTexture(labels);
    this.#uniforms.labels.value = texture;
    this.#uniforms.cells.value = cells;
  }

  place(ball: number, center: Vector3, radius: number, turn: Quaternion): void {
    this.#attribute("ball").setXYZW(ball, center.x, center.y, center.z, radius);
    this.#attribute("turn").setXYZW(ball, turn.x, turn.y, turn.z, turn.w);
  }

  hide(ball: number): void {
    this.#attribute("ball").setW(ball, 0);
  }

  /** Uploads the places of all balls. */
  commit(): void {
    this.#attribute("ball").needsUpdate = true;
    this.#attribute("turn").needsUpdate = true;
  }

  setLight({ sky, ground, lamp, toLamp }: Light): void {
    this.#uniforms.sky.value.copy(sky);
    this.#uniforms.ground.value.copy(ground);
    this.#uniforms.lamp.value.copy(lamp);
    this.#uniforms.toLamp.value.copy(toLamp);
  }

  /** Pixels per unit of length at distance one from the camera. */
  set pixels(pixels: number) {
    this.#uniforms.pixels.value = pixels;
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
    this.mesh.customDepthMaterial?.dispose();
    this.#uniforms.labels.value.dispose();
  }

  #attribute(name: "ball" | "turn" | "body" | "extra"): InstancedBufferAttribute {
    return this.mesh.geometry.getAttribute(name) as InstancedBufferAttribute;
  }
}

function squares(count = 0): InstancedBufferGeometry {
  const geometry = new InstancedBufferGeometry();
  const corners = [-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0];
  geometry.setAttribute("position", new Float32BufferAttribute(corners, 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  for (const name of ["ball", "turn", "body", "extra"]) {
    const attribute = new InstancedBufferAttribute(new Float32Array(SIZE * count), SIZE);
    geometry.setAttribute(name, attribute.setUsage(DynamicDrawUsage));
  }
  geometry.instanceCount = count;
  return geometry;
}
