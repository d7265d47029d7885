/** A picture with its depths, kept in memory, from which parts of the screen are restored. */

import {
  AlwaysDepth,
  DepthTexture,
  DynamicDrawUsage,
  GLSL3,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  Float32BufferAttribute,
  Mesh,
  OrthographicCamera,
  RawShaderMaterial,
  Scene,
  type Texture,
  Vector2,
  type WebGLRenderer,
} from "three";
import { Picture } from "./picture.ts";
import { TILE, type Tiles } from "./tiles.ts";

/** The depth at the middle of each pixel, with colours of rough edges, and the colours with smooth edges. */
export class Kept {
  readonly depths = new Picture(false);
  readonly smooth = new Picture(true);
  readonly #material = new RawShaderMaterial({
    glslVersion: GLSL3,
    uniforms: {
      colors: { value: null as Texture | null },
      depths: { value: null as Texture | null },
      size: { value: new Vector2() },
      columns: { value: 1 },
    },
    vertexShader: `
      in vec2 corner;
      in uint tile;
      /** Size of the screen, pixels, and number of tiles in a row. */
      uniform vec2 size;
      uniform uint columns;
      void main() {
        vec2 place = vec2(tile % columns, tile / columns) + corner;
        gl_Position = vec4(2.0 * ${TILE.toFixed(1)} * place / size - 1.0, 0.0, 1.0);
      }`,
    fragmentShader: `
      precision highp float;
      precision highp sampler2D;
      uniform sampler2D colors;
      uniform sampler2D depths;
      out vec4 color;
      void main() {
        ivec2 place = ivec2(gl_FragCoord.xy);
        color = vec4(texelFetch(colors, place, 0).rgb, 1.0);
        gl_FragDepth = texelFetch(depths, place, 0).r;
      }`,
    depthFunc: AlwaysDepth,
  });
  #tiles = instances(0);
  readonly #mesh = new Mesh(this.#tiles, this.#material);
  readonly #scene = new Scene();
  readonly #camera = new OrthographicCamera();

  constructor() {
    this.depths.depthTexture = new DepthTexture(1, 1);
    this.#mesh.frustumCulled = false;
    this.#scene.add(this.#mesh);
  }

  /** Starts to compile the shaders. */
  compile(renderer: WebGLRenderer): void {
    renderer.compile(this.#scene, this.#camera);
  }

  /**
   * Copies the kept pixels of these tiles, by index, to the screen.
   *
   * @param smooth - Whether their edges are smooth.
   */
  restore(renderer: WebGLRenderer, tiles: Tiles, indices: Uint32Array, smooth: boolean): void {
    if (this.#tiles.getAttribute("tile").count !== tiles.count) {
      this.#tiles.dispose();
      this.#mesh.geometry = this.#tiles = instances(tiles.count);
    }
    const attribute = this.#tiles.getAttribute("tile") as InstancedBufferAttribute;
    attribute.array.set(indices);
    attribute.clearUpdateRanges();
    attribute.addUpdateRange(0, indices.length);
    attribute.needsUpdate = true;
    this.#tiles.instanceCount = indices.length;
    const { uniforms } = this.#material;
    uniforms.colors!.value = (smooth ? this.smooth : this.depths).texture;
    uniforms.depths!.value = this.depths.depthTexture;
    (uniforms.size!.value as Vector2).set(this.depths.width, this.depths.height);
    uniforms.columns!.value = tiles.columns;
    renderer.render(this.#scene, this.#camera);
  }

  dispose(): void {
    this.depths.dispose();
    this.smooth.dispose();
    this.#tiles.dispose();
    this.#material.dispose();
  }
}

function instances(count: number): InstancedBufferGeometry {
  const geometry = new InstancedBufferGeometry();
  geometry.setAttribute("corner", new Float32BufferAttribute([0, 0, 1, 0, 1, 1, 0, 1], 2));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  // three.js passes unsigned integers to the shader as such.
  const tile = new InstancedBufferAttribute(new Uint32Array(count), 1);
  geometry.setAttribute("tile", tile.setUsage(DynamicDrawUsage));
  return geometry;
}
