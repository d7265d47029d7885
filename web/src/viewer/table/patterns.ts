/** Textures that tile, computed once: the weave of the cloth and the grain of the wood. */

import {
  DataTexture,
  LinearFilter,
  LinearMipmapLinearFilter,
  RedFormat,
  RepeatWrapping,
} from "three";

/** Side of a tile, pixels. */
const SIDE = 128;

/** The weave: short crossing fibres. */
export function weave(): DataTexture {
  const random = generator(1);
  const values = new Float32Array(SIDE * SIDE);
  for (let fibre = 0; fibre < 5200; fibre += 1) {
    const strength = random() - 0.5;
    const [x, y] = [Math.floor(random() * SIDE), Math.floor(random() * SIDE)];
    const upright = random() < 0.5;
    for (let i = 0; i < 6; i += 1) {
      const at = (((y + (upright ? i : 0)) % SIDE) * SIDE + ((x + (upright ? 0 : i)) % SIDE)) | 0;
      values[at]! += strength;
    }
  }
  return tile(values, 0.16);
}

/** The grain: slightly wavy streaks along the first axis. */
export function grain(): DataTexture {
  const random = generator(2);
  const noise = Float32Array.from({ length: SIDE }, () => random() - 0.5);
  const at = (v: number): number => {
    const wrapped = ((v % SIDE) + SIDE) % SIDE;
    const i = Math.floor(wrapped);
    const t = wrapped - i;
    return noise[i]! * (1 - t) + noise[(i + 1) % SIDE]! * t;
  };
  const values = new Float32Array(SIDE * SIDE);
  for (let y = 0; y < SIDE; y += 1) {
    for (let x = 0; x < SIDE; x += 1) {
      const along = (2 * Math.PI * x) / SIDE;
      const wander = 2.5 * Math.sin(along + 6 * at(y / 9)) + 1.2 * Math.sin(3 * along);
      values[y * SIDE + x] =
        at(0.25 * (y + wander)) + 0.55 * at(y + wander) + 0.3 * (random() - 0.5);
    }
  }
  return tile(values, 0.42);
}

/** Pseudorandom numbers in [0, 1), the same in every run (Lehmer generator, multiplier 48271). */
function generator(seed: number): () => number {
  let state = 48271 * seed;
  return () => {
    state = (state * 48271) % 2147483647;
    return state / 2147483647;
  };
}

/** A texture with values around one half; `contrast` scales their deviation. */
function tile(values: Float32Array, contrast: number): DataTexture {
  const bytes = Uint8Array.from(values, (value) =>
    Math.round(Math.min(255, Math.max(0, 127.5 + 255 * contrast * value))),
  );
  const texture = new DataTexture(bytes, SIDE, SIDE, RedFormat);
  texture.wrapS = texture.wrapT = RepeatWrapping;
  texture.magFilter = LinearFilter;
  texture.minFilter = LinearMipmapLinearFilter;
  texture.generateMipmaps = true;
  texture.anisotropy = 4;
  texture.needsUpdate = true;
  return texture;
}
