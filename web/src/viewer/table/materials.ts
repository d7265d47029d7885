/** Materials whose pattern depends on the position, so that surfaces need no texture coordinates. */

import {
  type Material,
  MeshLambertMaterial,
  MeshPhongMaterial,
  type Texture,
  Vector4,
} from "three";
import { grain, weave } from "./patterns";

/** Length of a tile of each pattern, m. */
const WEAVE_TILE = 0.11;
const GRAIN_TILE = { along: 0.85, across: 0.14 };

/** Declarations for both shaders: the place on the table, m, and the playing area. */
const VARYING = "varying vec2 vPlace;";
/** `area`: centre and half size of the playing area, m. */
const UNIFORMS = "uniform sampler2D pattern; uniform vec4 area;";

/** Cloth: darker towards the ends of the table, as under a lamp. */
const CLOTH_GLSL = `
  float thread = texture2D(pattern, vPlace / ${WEAVE_TILE.toFixed(3)}).r - 0.5;
  vec2 off = (vPlace - area.xy) / area.zw;
  diffuseColor.rgb *= (1.0 + 0.9 * thread) * (1.06 - 0.17 * dot(off, off));`;

/** Side of the squares on unbounded cloth, m, by which users can judge distances. */
const SQUARE = 0.5;

/** Unbounded cloth: lines one pixel wide, which fade where they would be too dense. */
const UNBOUNDED_GLSL = `${CLOTH_GLSL}
  vec2 square = vPlace / ${SQUARE.toFixed(1)};
  vec2 pixel = fwidth(square);
  vec2 near = abs(fract(square - 0.5) - 0.5) / pixel;
  float crowd = clamp(0.12 / max(pixel.x, pixel.y) - 1.0, 0.0, 1.0);
  diffuseColor.rgb *= 1.0 + 0.16 * crowd * (1.0 - min(min(near.x, near.y), 1.0));`;

/** Wood: the grain runs along each rail; its change of direction at the corners shows the mitre. */
const WOOD_GLSL = `
  vec2 rail = abs(vPlace - area.xy) - area.zw;
  vec2 along = rail.x > rail.y ? vPlace.yx : vPlace.xy;
  float streak = texture2D(pattern, along / vec2(${GRAIN_TILE.along}, ${GRAIN_TILE.across})).r - 0.5;
  diffuseColor.rgb *= 1.0 + 1.25 * streak;`;

/** The materials of the table, kept when its geometry changes. */
export class TableMaterials {
  /** Centre and half size of the playing area, m. */
  readonly area = new Vector4(0, 0, 1, 1);
  readonly #weave = weave();
  readonly #grain = grain();
  readonly cloth = this.#patterned(
    new MeshLambertMaterial({ vertexColors: true }),
    this.#weave,
    CLOTH_GLSL,
  );
  readonly unbounded = this.#patterned(
    new MeshLambertMaterial({ vertexColors: true, transparent: true }),
    this.#weave,
    UNBOUNDED_GLSL,
  );
  readonly wood = this.#patterned(
    new MeshPhongMaterial({ vertexColors: true, shininess: 60, specular: 0x2a241e }),
    this.#grain,
    WOOD_GLSL,
  );
  readonly frame = new MeshLambertMaterial({ vertexColors: true });
  readonly leather = new MeshLambertMaterial({ vertexColors: true, color: 0x3a322c });
  readonly shade = new MeshLambertMaterial({
    vertexColors: true,
    transparent: true,
    depthWrite: false,
    polygonOffset: true,
    polygonOffsetFactor: -1,
  });
  readonly sights = new MeshLambertMaterial({
    color: 0xefe6d2,
    polygonOffset: true,
    polygonOffsetFactor: -1,
  });
  readonly markings = new MeshLambertMaterial({
    color: 0xffffff,
    transparent: true,
    opacity: 0.4,
    depthWrite: false,
    polygonOffset: true,
    polygonOffsetFactor: -2,
  });

  dispose(): void {
    for (const part of Object.values(this)) {
      if (isMaterial(part)) part.dispose();
    }
    this.#weave.dispose();
    this.#grain.dispose();
  }

  #patterned<M extends Material>(material: M, pattern: Texture, glsl: string): M {
    material.onBeforeCompile = (shader) => {
      shader.uniforms.pattern = { value: pattern };
      shader.uniforms.area = { value: this.area };
      shader.vertexShader = `${VARYING}\n${shader.vertexShader}`.replace(
        "#include <begin_vertex>",
        "#include <begin_vertex>\nvPlace = position.xy;",
      );
      shader.fragmentShader = `${VARYING}\n${UNIFORMS}\n${shader.fragmentShader}`.replace(
        "#include <map_fragment>",
        glsl,
      );
    };
    material.customProgramCacheKey = () => glsl;
    return material;
  }
}

function isMaterial(value: unknown): value is Material {
  return (value as Partial<Material> | null)?.isMaterial === true;
}
