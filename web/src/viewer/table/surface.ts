/** Triangles from filled outlines and from bands between lines. */

import { BufferGeometry, Float32BufferAttribute, ShapeUtils, Vector2 } from "three";
import type { Point } from "../viewer-types.ts";

/** A line in space: x, y, z (m) per point. */
export type Line = readonly (readonly [number, number, number])[];

/** Brightness relative to the material's colour, 0 to 1, and optionally opacity. */
export type Shade = number | readonly [brightness: number, opacity: number];

/** Collects triangles. Vertices are shared along a band but not between bands, which keeps edges sharp. */
export class Surface {
  readonly #positions: number[] = [];
  readonly #normals: number[] = [];
  readonly #colors: number[] = [];
  readonly #indices: number[] = [];

  /** Adds a horizontal polygon with holes that faces up, of either orientation. */
  fill(
    contour: readonly Point[],
    holes: readonly (readonly Point[])[],
    z: number,
    shade: Shade = 1,
  ) {
    const rings = [contour, ...holes].map((ring) => ring.map(([x, y]) => new Vector2(x, y)));
    if (ShapeUtils.isClockWise(rings[0]!)) rings[0]!.reverse();
    for (const hole of rings.slice(1)) if (!ShapeUtils.isClockWise(hole)) hole.reverse();
    const first = this.#count;
    for (const { x, y } of rings.flat()) this.#vertex(x, y, z, shade, 1);
    for (const triangle of ShapeUtils.triangulateShape(rings[0]!, rings.slice(1))) {
      this.#indices.push(...triangle.map((corner) => first + corner));
    }
    return this;
  }

  /**
   * Adds bands between lines with the same number of points. If the first line is above the second, the
   * bands face to the left of the direction of the lines.
   *
   * @param shades - One per line, or one for all.
   */
  bands(lines: readonly Line[], shades: readonly Shade[] = [1]) {
    for (let row = 0; row + 1 < lines.length; row += 1) {
      const [above, below] = [lines[row]!, lines[row + 1]!];
      const first = this.#count;
      [above, below].forEach((line, side) => {
        const shade = shades[row + side] ?? shades[0]!;
        line.forEach(([x, y, z]) => this.#vertex(x, y, z, shade, 0));
      });
      const width = above.length;
      for (let i = 0; i + 1 < width; i += 1) {
        const a = first + i;
        this.#triangle(a, a + 1, a + width);
        this.#triangle(a + 1, a + width + 1, a + width);
      }
    }
    return this;
  }

  geometry(): BufferGeometry {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new Float32BufferAttribute(this.#positions, 3));
    geometry.setAttribute("color", new Float32BufferAttribute(this.#colors, 4));
    geometry.setAttribute("normal", new Float32BufferAttribute(this.#normals, 3));
    geometry.setIndex(this.#indices);
    geometry.normalizeNormals();
    return geometry;
  }

  /** Adds a triangle of a band. At each vertex the normals of its triangles add up, weighted by their areas. */
  #triangle(...corners: [number, number, number]): void {
    this.#indices.push(...corners);
    const at = (corner: number, axis: number): number => this.#positions[3 * corner + axis]!;
    const [a, b, c] = corners;
    const [ux, uy, uz] = [at(b, 0) - at(a, 0), at(b, 1) - at(a, 1), at(b, 2) - at(a, 2)];
    const [vx, vy, vz] = [at(c, 0) - at(a, 0), at(c, 1) - at(a, 1), at(c, 2) - at(a, 2)];
    for (const corner of corners) {
      this.#normals[3 * corner]! += uy * vz - uz * vy;
      this.#normals[3 * corner + 1]! += uz * vx - ux * vz;
      this.#normals[3 * corner + 2]! += ux * vy - uy * vx;
    }
  }

  get #count(): number {
    return this.#positions.length / 3;
  }

  /** @param up - The vertical component of its normal, to which those of triangles are added. */
  #vertex(x: number, y: number, z: number, shade: Shade, up: 0 | 1): void {
    const [brightness, opacity] = typeof shade === "number" ? [shade, 1] : shade;
    // As the geometry stores them: a triangle whose corners fall together there has no normal.
    this.#positions.push(Math.fround(x), Math.fround(y), Math.fround(z));
    this.#normals.push(0, 0, up);
    this.#colors.push(brightness, brightness, brightness, opacity);
  }
}

/** Points at the height `z` (m). */
export function raised(points: readonly Point[], z: number): Line {
  return points.map(([x, y]) => [x, y, z]);
}

/** A circle as a closed ring of points; the last one repeats the first. */
export function ring(center: Point, radius: number, sides = 48): Point[] {
  return Array.from({ length: sides + 1 }, (_, i): Point => {
    const angle = (2 * Math.PI * (i % sides)) / sides;
    return [center[0] + radius * Math.cos(angle), center[1] + radius * Math.sin(angle)];
  });
}

/** A rectangle `margin` (m) outside the playing area with round corners: counter-clockwise, closed. */
export function roundedRectangle([width, length]: Point, margin: number, radius: number): Point[] {
  const corners = [
    [width + margin - radius, length + margin - radius],
    [radius - margin, length + margin - radius],
    [radius - margin, radius - margin],
    [width + margin - radius, radius - margin],
  ] as const;
  const steps = 10;
  const points = corners.flatMap(([x, y], quarter) =>
    Array.from({ length: steps + 1 }, (_, i): Point => {
      const angle = (quarter + i / steps) * (Math.PI / 2);
      return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
    }),
  );
  return [...points, points[0]!];
}

/** An open line whose points are moved to its right by `distance` (m). */
export function offset(line: readonly Point[], distance: number): Point[] {
  return line.map(([x, y], i): Point => {
    const [before, after] = [line[Math.max(0, i - 1)]!, line[Math.min(line.length - 1, i + 1)]!];
    const [dx, dy] = [after[0] - before[0], after[1] - before[1]];
    const length = Math.hypot(dx, dy);
    return [x + (dy / length) * distance, y - (dx / length) * distance];
  });
}
