/** Lines of constant width in pixels. Their buffers are reused for every picture. */

import {
  Color,
  DynamicDrawUsage,
  InstancedInterleavedBuffer,
  InterleavedBufferAttribute,
  Vector3,
} from "three";
import { LineMaterial } from "three/addons/lines/LineMaterial.js";
import { LineSegments2 } from "three/addons/lines/LineSegments2.js";
import { LineSegmentsGeometry } from "three/addons/lines/LineSegmentsGeometry.js";
import { setCover } from "../render/extent.ts";

/** Initial capacity, segments. */
const CAPACITY = 512;

export interface LineStyle {
  /** Width, CSS pixels. */
  width: number;
  opacity: number;
  /** Length of a dash and of a gap, m; left out: a solid line. */
  dash?: readonly [number, number];
  /** Whether nothing hides the line. Default false. */
  onTop?: boolean;
}

/** Polylines of one style, each in its own colour. */
export class Lines {
  readonly object: LineSegments2;
  readonly #material: LineMaterial;
  #geometry!: LineSegmentsGeometry;
  #positions!: InstancedInterleavedBuffer;
  #colors!: InstancedInterleavedBuffer;
  #distances!: InstancedInterleavedBuffer;
  #capacity = 0;
  #count = 0;
  readonly #color = new Color();

  constructor({ width, opacity, dash, onTop = false }: LineStyle) {
    this.#material = new LineMaterial({
      linewidth: width,
      vertexColors: true,
      transparent: true,
      opacity,
      depthWrite: false,
      depthTest: !onTop,
      dashed: dash !== undefined,
      ...(dash && { dashSize: dash[0], gapSize: dash[1] }),
    });
    this.#reserve(CAPACITY);
    this.object = new LineSegments2(this.#geometry, this.#material);
    this.object.frustumCulled = false;
    this.object.visible = false;
    // Drawn after the heat map.
    this.object.renderOrder = 2;
    const [from, to] = [new Vector3(), new Vector3()];
    setCover(this.object, (add) => {
      const positions = this.#positions.array as Float32Array;
      for (let at = 0; at < 6 * this.#count; at += 6) {
        add(from.fromArray(positions, at), to.fromArray(positions, at + 3), 0, width);
      }
    });
  }

  /** Removes all lines. */
  clear(): this {
    this.#count = 0;
    return this;
  }

  /**
   * Adds a polyline.
   *
   * @param points - `stride` numbers per point, the first three of them x, y, z (m).
   */
  add(points: ArrayLike<number>, stride: number, color: string): this {
    const vertices = Math.floor(points.length / stride);
    this.#reserve(this.#count + vertices);
    const { r, g, b } = this.#color.set(color);
    const positions = this.#positions.array;
    const colors = this.#colors.array;
    const distances = this.#distances.array;
    let along = 0;
    for (let i = 0; i + 1 < vertices; i += 1) {
      const at = i * stride;
      let squared = 0;
      for (let k = 0; k < 3; k += 1) {
        const [from, to] = [points[at + k]!, points[at + stride + k]!];
        positions[6 * this.#count + k] = from;
        positions[6 * this.#count + 3 + k] = to;
        squared += (to - from) ** 2;
      }
      if (squared === 0) continue;
      distances[2 * this.#count] = along;
      along += Math.sqrt(squared);
      distances[2 * this.#count + 1] = along;
      for (let k = 0; k < 6; k += 3) {
        colors[6 * this.#count + k] = r;
        colors[6 * this.#count + k + 1] = g;
        colors[6 * this.#count + k + 2] = b;
      }
      this.#count += 1;
    }
    return this;
  }

  /** Uploads the lines to the GPU. */
  commit(): void {
    for (const [buffer, size] of [
      [this.#positions, 6],
      [this.#colors, 6],
      [this.#distances, 2],
    ] as const) {
      buffer.clearUpdateRanges();
      buffer.addUpdateRange(0, size * this.#count);
      buffer.needsUpdate = true;
    }
    this.#geometry.instanceCount = this.#count;
    this.object.visible = this.#count > 0;
  }

  dispose(): void {
    this.#geometry.dispose();
    this.#material.dispose();
  }

  #reserve(segments: number): void {
    if (segments <= this.#capacity) return;
    const capacity = Math.max(segments, 2 * this.#capacity);
    const [positions, colors, distances] = [6, 6, 2].map((size, i) => {
      const buffer = new InstancedInterleavedBuffer(new Float32Array(size * capacity), size, 1);
      buffer.setUsage(DynamicDrawUsage);
      const old = [this.#positions, this.#colors, this.#distances][i];
      if (old) buffer.array.set(old.array);
      return buffer;
    });
    this.#positions = positions!;
    this.#colors = colors!;
    this.#distances = distances!;
    this.#capacity = capacity;
    const geometry = new LineSegmentsGeometry();
    const part = (buffer: InstancedInterleavedBuffer, size: number, at: number) =>
      new InterleavedBufferAttribute(buffer, size, at);
    geometry.setAttribute("instanceStart", part(this.#positions, 3, 0));
    geometry.setAttribute("instanceEnd", part(this.#positions, 3, 3));
    geometry.setAttribute("instanceColorStart", part(this.#colors, 3, 0));
    geometry.setAttribute("instanceColorEnd", part(this.#colors, 3, 3));
    geometry.setAttribute("instanceDistanceStart", part(this.#distances, 1, 0));
    geometry.setAttribute("instanceDistanceEnd", part(this.#distances, 1, 1));
    const old = this.#geometry as LineSegmentsGeometry | undefined;
    this.#geometry = geometry;
    if (old) {
      this.object.geometry = geometry;
      old.dispose();
    }
  }
}
