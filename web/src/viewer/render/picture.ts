/** Pictures in memory, and their copy to the screen. */

import {
  GLSL3,
  LinearFilter,
  Mesh,
  NearestFilter,
  OrthographicCamera,
  PlaneGeometry,
  RawShaderMaterial,
  Scene,
  SRGBColorSpace,
  type Texture,
  Vector4,
  type WebGLRenderer,
  WebGLRenderTarget,
} from "three";

/** Samples per pixel, for smooth edges. */
const SAMPLES = 4;

/** A picture in memory, with the colours of the screen. */
export class Picture extends WebGLRenderTarget {
  /** three.js encodes colours as on the screen only for targets with this flag. */
  readonly isXRRenderTarget = true;

  /** @param smooth - Whether edges are smoothed. */
  constructor(smooth: boolean, filter: typeof NearestFilter | typeof LinearFilter = NearestFilter) {
    super(1, 1, {
      samples: smooth ? SAMPLES : 0,
      colorSpace: SRGBColorSpace,
      // The encoded bytes are stored and read as they are.
      internalFormat: "RGBA8",
      minFilter: filter,
      magFilter: filter,
    });
  }
}

/** Draws a picture on the screen, or a disc of it with a border. */
export class Copier {
  readonly #material = new RawShaderMaterial({
    glslVersion: GLSL3,
    uniforms: {
      picture: { value: null as Texture | null },
      border: { value: new Vector4(0, 0, 0, 0) },
    },
    vertexShader: `
      in vec3 position;
      out vec2 place;
      void main() {
        place = position.xy;
        gl_Position = vec4(position.xy, 0.0, 1.0);
      }`,
    fragmentShader: `
      precision highp float;
      uniform sampler2D picture;
      /** Colour, and width as a share of the radius; zero: the whole picture. */
      uniform vec4 border;
      in vec2 place;
      out vec4 color;
      void main() {
        color = vec4(texture(picture, 0.5 + 0.5 * place).rgb, 1.0);
        if (border.w == 0.0) return;
        float radius = length(place);
        float blur = fwidth(radius);
        color.rgb = mix(color.rgb, border.rgb, smoothstep(-blur, 0.0, radius - 1.0 + border.w));
        color.a = 1.0 - smoothstep(-blur, 0.0, radius - 1.0);
      }`,
    depthTest: false,
    depthWrite: false,
  });
  readonly #mesh = new Mesh(new PlaneGeometry(2, 2), this.#material);
  readonly #scene = new Scene();
  readonly #camera = new OrthographicCamera();

  constructor() {
    this.#mesh.frustumCulled = false;
    this.#scene.add(this.#mesh);
  }

  /** Draws the whole picture in the present viewport. */
  copy(renderer: WebGLRenderer, picture: Picture): void {
    this.#draw(renderer, picture, 0);
  }

  /**
   * Draws the picture as a disc in the present viewport.
   *
   * @param width - Width of its white border as a share of the radius.
   */
  disc(renderer: WebGLRenderer, picture: Picture, width: number): void {
    this.#draw(renderer, picture, width);
  }

  dispose(): void {
    this.#mesh.geometry.dispose();
    this.#material.dispose();
  }

  #draw(renderer: WebGLRenderer, picture: Picture, border: number): void {
    const { uniforms } = this.#material;
    uniforms.picture!.value = picture.texture;
    (uniforms.border!.value as Vector4).set(1, 1, 1, border);
    this.#material.transparent = border > 0;
    renderer.render(this.#scene, this.#camera);
  }
}
