/** Materials whose pattern depends on the position, so that surfaces need no texture coordinates. */

import {
  type Material,
  MeshLambertMaterial,
  MeshPhongMaterial,
  type MeshPhongMaterialParameters,
  type Texture,
  Vector4,
} from "three";
import { grain, weave } from "./patterns.ts";

/** Length of a tile of each pattern, m. */
const WEAVE_TILE = 0.11;
const GRAIN_TILE = [0.85, 0.14] as const;

/**
 * Moves the apron back in the depth buffer, by as much as it is steep. From above the sides of the legs are
 * nearly edge-on: their depth between two pixels spans half a metre, and without this single pixels of them
 * came out in front of the cloth, as dark lines near the corners.
 */
export const DEEP = { polygonOffset: true, polygonOffsetFactor: 4, polygonOffsetUnits: 4 } as const;

/** Declarations for both shaders: the place on the table, m, and the playing area. */
const VARYING = "varying vec2 vPlace;";
/** `area`: centre and half size of the playing area, m; the others as in {@link Pattern}. */
const UNIFORMS = `
  uniform sampler2D pattern;
  uniform vec4 area;
  uniform vec2 tile;
  uniform float contrast;
  uniform float fade;
  uniform bool mitred;
  uniform float gloss;`;

/** What distinguishes the materials of one shader. */
interface Pattern {
  readonly pattern: Texture;
  /** Length and width of a tile of the pattern, m. */
  readonly tile: readonly [number, number];
  readonly contrast: number;
  /** 1: darker towards the ends of the table, as under a lamp. */
  readonly fade: number;
  /** Whether the pattern runs along each rail; its change of direction at the corners shows the mitre. */
  readonly mitred: boolean;
  /** 1: the lamp is reflected. */
  readonly gloss: number;
}

const PATTERN_GLSL = `
  vec2 off = vPlace - area.xy;
  vec2 beyond = abs(off) - area.zw;
  vec2 place = mitred && beyond.x > beyond.y ? vPlace.yx : vPlace;
  float thread = texture2D(pattern, place / tile).r - 0.5;
  off /= area.zw;
  diffuseColor.rgb *= (1.0 + contrast * thread) * (1.0 + fade * (0.06 - 0.17 * dot(off, off)));`;

/** Side of the squares on unbounded cloth, m, by which users can judge distances. */
const SQUARE = 0.5;

/** Unbounded cloth: lines one pixel wide, which fade where they would be too dense. */
const UNBOUNDED_GLSL = `${PATTERN_GLSL}
  vec2 square = vPlace / ${SQUARE.toFixed(1)};
  vec2 pixel = fwidth(square);
  vec2 near = abs(fract(square - 0.5) - 0.5) / pixel;
  float crowd = clamp(0.12 / max(pixel.x, pixel.y) - 1.0, 0.0, 1.0);
  diffuseColor.rgb *= 1.0 + 0.16 * crowd * (1.0 - min(min(near.x, near.y), 1.0));`;

/**
 * The materials of the table, kept when its geometry changes. All opaque ones have the same shader: a software
 * renderer takes some fifty milliseconds to compile one.
 */
export class TableMaterials {
  /** Centre and half size of the playing area, m. */
  readonly area = new Vector4(0, 0, 1, 1);
  readonly #weave = weave();
  readonly #grain = grain();
  readonly #cloth: Pattern = {
    pattern: this.#weave,
    tile: [WEAVE_TILE, WEAVE_TILE],
    contrast: 0.9,
    fade: 1,
    mitred: false,
    gloss: 0,
  };
  readonly #plain: Pattern = { ...this.#cloth, contrast: 0, fade: 0 };
  readonly cloth = this.#patterned({}, this.#cloth);
  readonly unbounded = this.#patterned({ transparent: true }, this.#cloth, UNBOUNDED_GLSL);
  readonly wood = this.#patterned(
    { shininess: 60, specular: 0x2a241e },
    {
      pattern: this.#grain,
      tile: GRAIN_TILE,
      contrast: 1.25,
      fade: 0,
      mitred: true,
      gloss: 1,
    },
  );
  readonly apron = this.#patterned(DEEP, this.#plain);
  readonly leather = this.#patterned({ color: 0x3a322c }, this.#plain);
  readonly sights = this.#patterned(
    { color: 0xefe6d2, polygonOffset: true, polygonOffsetFactor: -1 },
    this.#plain,
  );
  /** The shadow on the floor. */
  readonly floor = new MeshLambertMaterial({
    vertexColors: true,
    transparent: true,
    depthWrite: false,
  });
  readonly shade = new MeshLambertMaterial({
    vertexColors: true,
    transparent: true,
    depthWrite: false,
    polygonOffset: true,
    polygonOffsetFactor: -1,
  });
  readonly markings = new MeshLambertMaterial({
    vertexColors: true,
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

  #patterned(
    look: MeshPhongMaterialParameters,
    pattern: Pattern,
    glsl = PATTERN_GLSL,
  ): MeshPhongMaterial {
    const material = new MeshPhongMaterial({ vertexColors: true, ...look });
    material.onBeforeCompile = (shader) => {
      shader.uniforms.area = { value: this.area };
      for (const [name, value] of Object.entries<unknown>({ ...pattern }))
        shader.uniforms[name] = { value };
      shader.vertexShader = `${VARYING}\n${shader.vertexShader}`.replace(
        "#include <begin_vertex>",
        "#include <begin_vertex>\nvPlace = position.xy;",
      );
      shader.fragmentShader = `${VARYING}\n${UNIFORMS}\n${shader.fragmentShader}`
        .replace("#include <map_fragment>", glsl)
        .replace("#include <specularmap_fragment>", "float specularStrength = gloss;");
    };
    material.customProgramCacheKey = () => glsl;
    return material;
  }
}

function isMaterial(value: unknown): value is Material {
  return (value as Partial<Material> | null)?.isMaterial === true;
}
