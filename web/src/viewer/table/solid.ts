/** The body of a table: cloth, cushions, pockets, wood and apron as surfaces. */

import type { BufferGeometry } from "three";
import type { Geometry, Point } from "../viewer-types.ts";
import { behind, type Outline } from "./table-outline.ts";
import {
  offset,
  raised,
  ring,
  roundedRectangle,
  Surface,
  type Line,
  type Shade,
} from "./surface.ts";

/** Distance of a cushion's foot behind its nose, m; the rubber is a wedge. */
const RECESS = 0.014;
/** Height of the vertical edge at the nose, m. */
const NOSE = 0.006;
/** Width of the shade on the cloth at the foot of a cushion, m. */
const FOOT_SHADE = 0.045;
/**
 * The top of a cushion from the nose to the wood: share of its width, and brightness relative to the bed.
 * The nose catches the light, so that it is visible against the bed; a groove parts cloth and wood.
 */
const CUSHION_TOP = [
  [0, 1.5],
  [0.1, 1.42],
  [0.2, 1.14],
  [0.72, 1.04],
  [0.93, 0.84],
  [1, 0.42],
] as const;
/** Depth of the pockets, and of the cloth that is folded into them, m. */
const HOLE_DEPTH = 0.14;
const FOLD = 0.012;
/** Radius of a pocket's floor as a share of the mouth's: the wall narrows, so that it is seen from above. */
const HOLE_FLOOR = 0.6;
/** Width and height of the leather around a pocket, m. */
const RIM_WIDTH = 0.016;
const RIM_HEIGHT = 0.004;
/** Rounding of the outer edge of the wood, and depth of the rail, m. */
const WOOD_EDGE = 0.016;
const RAIL_DEPTH = 0.05;
/** Inset of the apron below the rails, and depth of its lower edge below the slate, m. */
const APRON_INSET = 0.014;
const APRON_DEPTH = 0.2;
/** Distance of a leg's axis from the nose lines, m. */
const LEG_INSET = 0.1;
/** Radius of the corners as a share of the rail's width. */
const CORNER = 0.45;
/** Height of the playing surface above the floor, m (WPA: 29 1/4 to 31 in). */
export const FLOOR = 0.765;
/** Distance between surfaces that lie on each other, m, so that the right one is visible. */
export const LAYER = 0.0004;

/** The surfaces of a table, one per material. */
export interface Solid {
  cloth: BufferGeometry;
  cushions: BufferGeometry;
  /** Soft shade at the foot of the cushions. */
  shade: BufferGeometry;
  pockets: BufferGeometry;
  wood: BufferGeometry;
  apron: BufferGeometry;
}

/** The surfaces over the ground plan of a table with rails. */
export function solid(geometry: Geometry, plan: Outline): Solid {
  const { cushion_height: height, cushion_width: width = 0, pockets } = geometry;
  const size = geometry.size!;
  const holes = pockets.map((pocket) => ring(pocket.center, pocket.radius));
  // The outer edge is hidden below the wood.
  const bed = open(roundedRectangle(size, plan.reach - 0.01, CORNER * plan.reach));
  const cloth = new Surface().fill(bed, holes.map(open), 0);
  const wells = new Surface();
  pockets.forEach(({ center, radius }, i) => {
    const at = (share: number, z: number): Line => raised(ring(center, share * radius), z);
    const edge = raised(holes[i]!, 0);
    cloth.bands([edge, at(0.97, -0.4 * FOLD), at(0.95, -FOLD)], [0.85, 0.5, 0.22]);
    wells.bands(
      [at(0.95, -FOLD), at(0.86, -0.3 * HOLE_DEPTH), at(HOLE_FLOOR, -HOLE_DEPTH)],
      [0.75, 0.4, 0.06],
    );
    wells.fill(open(ring(center, HOLE_FLOOR * radius)), [], -HOLE_DEPTH, 0.04);
  });
  const cushions = new Surface();
  const shade = new Surface();
  for (const run of plan.runs) {
    if (run.material === "liner") {
      wall(wells, run.points, height);
      continue;
    }
    const rows = CUSHION_TOP.map(([share]) =>
      raised(inset(run.points, size, width, share), height),
    );
    cushions.bands(rows.toReversed(), CUSHION_TOP.map(([, shade]) => shade).toReversed());
    const foot = shifted(run.points, size, width, RECESS);
    cushions.bands(
      [raised(run.points, height), raised(run.points, height - NOSE), raised(foot, 0)],
      [1.25, 0.8, 0.35],
    );
    footShade(shade, run.points);
  }
  return {
    cloth: cloth.geometry(),
    cushions: cushions.geometry(),
    shade: shade.geometry(),
    pockets: wells.geometry(),
    wood: wood(size, plan, height),
    apron: apron(size, plan.reach),
  };
}

/** The line from a cushion's nose to the wood, at a share of the width in between. */
function inset(line: readonly Point[], size: Point, width: number, share: number): Point[] {
  const last = line.length - 1;
  const alongX = Math.abs(line[last]![0] - line[0]![0]) > Math.abs(line[last]![1] - line[0]![1]);
  return line.map((point, i): Point => {
    const back = behind(point, size, width);
    // Only the ends of a rail without a pocket are mitred.
    const middle: Point = alongX ? [point[0], back[1]] : [back[0], point[1]];
    const [x, y] = i === 0 || i === last ? back : middle;
    return [point[0] + share * (x - point[0]), point[1] + share * (y - point[1])];
  });
}

/** The shade along a cushion, fading on the cloth. At a corner without a pocket the shades meet. */
function footShade(surface: Surface, line: readonly Point[]): void {
  const rows = [-0.2 * FOOT_SHADE, 0, 0.35 * FOOT_SHADE, FOOT_SHADE].map((distance) => {
    const moved = offset(line, -distance);
    const [first, last] = [0, line.length - 1];
    if (line.length === 2 && distance > 0) {
      const length = Math.hypot(line[1]![0] - line[0]![0], line[1]![1] - line[0]![1]);
      const t = distance / length;
      const [a, b] = [moved[first]!, moved[last]!];
      const [dx, dy] = [t * (b[0] - a[0]), t * (b[1] - a[1])];
      moved[first] = [a[0] + dx, a[1] + dy];
      moved[last] = [b[0] - dx, b[1] - dy];
    }
    return raised(moved, LAYER);
  });
  surface.bands(
    rows,
    [0.66, 0.55, 0.2, 0].map((opacity): Shade => [0, opacity]),
  );
}

/** The wall of a pocket, from the leather rim down. */
function wall(surface: Surface, points: readonly Point[], height: number): void {
  const steps = 6;
  const lines: Line[] = [];
  const shades: Shade[] = [];
  for (let i = 0; i <= steps; i += 1) {
    const angle = (Math.PI * i) / steps;
    const out = 0.5 * RIM_WIDTH * (1 + Math.cos(angle));
    lines.push(raised(offset(points, out), height + RIM_HEIGHT * Math.sin(angle)));
    // The top of the leather catches the light.
    shades.push(0.9 + 1.1 * Math.sin(angle));
  }
  // In front of the wall of the hole in the slate.
  const inner = offset(points, -LAYER);
  lines.push(raised(inner, 0), raised(inner, -HOLE_DEPTH));
  shades.push(0.5, 0.08);
  surface.bands(lines, shades);
}

function wood(size: Point, plan: Outline, height: number): BufferGeometry {
  const radius = CORNER * plan.reach;
  const steps = 4;
  const surface = new Surface();
  const lines: Line[] = [];
  for (let i = 0; i <= steps; i += 1) {
    const angle = (Math.PI / 2) * (i / steps);
    const inset = WOOD_EDGE * (1 - Math.sin(angle));
    lines.push(edge(size, plan.reach - inset, radius, height - WOOD_EDGE * (1 - Math.cos(angle))));
  }
  lines.push(edge(size, plan.reach, radius, -RAIL_DEPTH));
  lines.push(edge(size, plan.reach - 0.02, radius, -RAIL_DEPTH));
  surface.fill(
    open(roundedRectangle(size, plan.reach - WOOD_EDGE, radius)),
    [plan.woodInside],
    height,
  );
  return surface.bands(lines, [1, 0.98, 0.94, 0.9, 0.86, 0.6, 0.3]).geometry();
}

/** Apron and legs. */
function apron(size: Point, reach: number): BufferGeometry {
  const surface = new Surface();
  const radius = CORNER * reach;
  surface.bands(
    [
      edge(size, reach - APRON_INSET, radius, -RAIL_DEPTH),
      edge(size, reach - APRON_INSET - 0.01, radius, -APRON_DEPTH),
      edge(size, 0, CORNER * reach, -APRON_DEPTH),
    ],
    [0.6, 1, 0.4],
  );
  const [width, length] = size;
  const places = [LEG_INSET, width - LEG_INSET].flatMap((x) =>
    [LEG_INSET, length - LEG_INSET].map((y): Point => [x, y]),
  );
  for (const [x, y] of places) {
    const at = (half: number, z: number): Line =>
      roundedRectangle([0, 0], half, 0.3 * half)
        .reverse()
        .map((p) => [x + p[0], y + p[1], z]);
    surface.bands([at(0.085, -APRON_DEPTH), at(0.055, -FLOOR)], [0.7, 0.95]);
  }
  return surface.geometry();
}

/** The outer edge, oriented so that its bands face outwards. */
function edge(size: Point, margin: number, radius: number, z: number): Line {
  return raised(roundedRectangle(size, margin, radius).toReversed(), z);
}

/**
 * A cushion's line moved away from the playing area by `distance` (m) at the nose, decreasing to zero at
 * the wood.
 */
function shifted(
  line: readonly Point[],
  [width, length]: Point,
  cushion: number,
  distance: number,
) {
  // The outward direction of the rail.
  const [first, last] = [line[0]!, line.at(-1)!];
  const alongX = Math.abs(last[0] - first[0]) > Math.abs(last[1] - first[1]);
  const middle: Point = [(first[0] + last[0]) / 2, (first[1] + last[1]) / 2];
  const sign = alongX ? Math.sign(middle[1] - length / 2) : Math.sign(middle[0] - width / 2);
  return line.map(([x, y]): Point => {
    const depth = alongX
      ? sign * (y - length / 2) - length / 2
      : sign * (x - width / 2) - width / 2;
    const by = sign * distance * Math.min(1, Math.max(0, 1 - depth / cushion));
    return alongX ? [x, y + by] : [x + by, y];
  });
}

/** A closed ring without its repeated last point. */
function open(points: readonly Point[]): Point[] {
  return points.slice(0, -1);
}
