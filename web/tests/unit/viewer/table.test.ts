import type { BufferGeometry } from "three";
import { describe, expect, test } from "vitest";
import { sightPlaces, sights, markings } from "../../../src/viewer/table/fittings.ts";
import { type Outline, outline, signedArea } from "../../../src/viewer/table/table-outline.ts";
import { solid } from "../../../src/viewer/table/solid.ts";
import type { Geometry, Point } from "../../../src/viewer/viewer-types.ts";
import { UNBOUNDED, label, RAILED, tableOf } from "./tables.ts";

/** Rounding of the dimensions, m. */
const ROUNDING = 1e-6;

/** Heights of the horizontal triangles of a surface over a place, found by the signs of three areas. */
function heightsOver(surface: BufferGeometry, [x, y]: Point): number[] {
  const place = surface.getAttribute("position");
  const index = surface.getIndex()!;
  const heights: number[] = [];
  for (let i = 0; i < index.count; i += 3) {
    const corners = [0, 1, 2].map((k) => index.getX(i + k));
    const sides = corners.map((a, k) => {
      const b = corners[(k + 1) % 3]!;
      const [ax, ay] = [place.getX(a), place.getY(a)];
      return (place.getX(b) - ax) * (y - ay) - (place.getY(b) - ay) * (x - ax);
    });
    const flat = corners.every((a) => place.getZ(a) === place.getZ(corners[0]!));
    if (flat && (sides.every((s) => s > 0) || sides.every((s) => s < 0))) {
      heights.push(place.getZ(corners[0]!));
    }
  }
  return heights;
}

function crosses(a: Point, b: Point, c: Point, d: Point): boolean {
  const side = (p: Point, q: Point, r: Point): number =>
    Math.sign((q[0] - p[0]) * (r[1] - p[1]) - (q[1] - p[1]) * (r[0] - p[0]));
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

function isSimple(polygon: readonly Point[]): boolean {
  const n = polygon.length;
  for (let i = 0; i < n; i += 1) {
    for (let j = i + 2; j < n; j += 1) {
      if (i === 0 && j === n - 1) continue;
      if (crosses(polygon[i]!, polygon[i + 1]!, polygon[j]!, polygon[(j + 1) % n]!)) return false;
    }
  }
  return true;
}

describe.each(
  RAILED.map((table): [string, Geometry, Outline] => [label(table), table, outline(table)]),
)("%s", (_, table, plan) => {
  const [width, length] = table.size!;
  const body = solid(table, plan);
  const center: Point = [width / 2, length / 2 + 0.013];

  test("the edge is one closed line, counter-clockwise, without crossings", () => {
    plan.runs.forEach((run, i) => {
      const next = plan.runs[(i + 1) % plan.runs.length]!.points[0]!;
      const end = run.points.at(-1)!;
      expect(Math.hypot(end[0] - next[0], end[1] - next[1])).toBeLessThan(ROUNDING);
    });
    const edge = plan.runs.flatMap((run) => run.points.slice(0, -1));
    expect(isSimple(edge)).toBe(true);
    expect(signedArea(edge)).toBeGreaterThan(width * length - ROUNDING);
  });

  test("there is a cushion for each rail and a wall for each pocket", () => {
    const rails = new Set(table.cushions.map((part) => part.rail));
    expect(plan.rubbers).toHaveLength(rails.size);
    expect(plan.runs.filter((run) => run.material === "liner")).toHaveLength(table.pockets.length);
  });

  test("cushions and wood have simple outlines, and the wood is behind the cushions", () => {
    for (const rubber of [...plan.rubbers, plan.woodInside]) expect(isSimple(rubber)).toBe(true);
    for (const [x, y] of plan.woodInside) {
      const behind = Math.max(-x, x - width, -y, y - length);
      expect(behind).toBeGreaterThan(table.cushion_width! - ROUNDING);
      expect(behind).toBeLessThan(plan.reach);
    }
  });

  test("the cloth covers the centre and has holes at the pockets", () => {
    expect(heightsOver(body.cloth, center)).toEqual([0]);
    for (const pocket of table.pockets) expect(heightsOver(body.cloth, pocket.center)).toEqual([]);
  });

  test("neither cushion nor wood covers a pocket", () => {
    for (const {
      center: [x, y],
    } of table.pockets) {
      const hole: Point = [x + 0.001, y + 0.0007];
      expect(heightsOver(body.cushions, hole)).toEqual([]);
      expect(heightsOver(body.wood, hole)).toEqual([]);
    }
  });

  test("cushions and wood have the height of the nose", () => {
    const h = Math.fround(table.cushion_height);
    const quarter = 0.31 * length;
    expect(heightsOver(body.cushions, [-0.02, quarter])).toEqual([h]);
    expect(heightsOver(body.wood, [-0.08, quarter])).toEqual([h]);
    expect(heightsOver(body.cushions, [0.01, quarter])).toEqual([]);
  });

  test("all positions and normals are finite", () => {
    for (const surface of Object.values(body) as BufferGeometry[]) {
      expect([...surface.getAttribute("position").array].every(Number.isFinite)).toBe(true);
      expect([...surface.getAttribute("normal").array].every(Number.isFinite)).toBe(true);
    }
  });

  test("horizontal surfaces face up", () => {
    for (const surface of [
      body.cloth,
      body.cushions,
      body.wood,
      body.shade,
      markings(table),
      sights(table),
    ]) {
      if (!surface) continue;
      const normal = surface.getAttribute("normal");
      for (let i = 0; i < normal.count; i += 1) {
        if (Math.abs(normal.getZ(i)) > 0.999) expect(normal.getZ(i)).toBeGreaterThan(0);
        if (surface === body.wood) break;
      }
    }
  });

  test("diamonds are at their setback on the wood, and none at a pocket or the end of a rail", () => {
    for (const [[x, y]] of sightPlaces(table)) {
      expect(Math.max(-x, x - width, -y, y - length)).toBeCloseTo(table.sights!.setback, 9);
      for (const { center: hole, radius } of table.pockets) {
        expect(Math.hypot(x - hole[0], y - hole[1])).toBeGreaterThan(radius);
      }
    }
    if (table.physics === "pool" && table.sights) expect(sightPlaces(table)).toHaveLength(18);
    if (table.physics === "carom" && table.sights) expect(sightPlaces(table)).toHaveLength(20);
  });
});

test("with the pocket model mouth-line the far side of the hole closes the edge", () => {
  const table = RAILED.find(({ name }) => name === "wpa-9ft")!;
  const plan = outline(tableOf({ base: "wpa-9ft", pocket_model: "mouth-line" }));
  const walls = plan.runs.filter((run) => run.material === "liner");
  expect(walls).toHaveLength(6);
  const whole = outline(table).runs.filter((run) => run.material === "liner");
  const area = (runs: typeof walls): number =>
    runs.reduce((sum, run) => sum + signedArea(run.points), 0);
  expect(area(walls)).toBeGreaterThan(0.9 * area(whole));
  expect(area(walls)).toBeLessThan(1.1 * area(whole));
});

test("unbounded cloth has no outline", () => {
  expect(() => outline(UNBOUNDED)).toThrow(/Unbounded cloth/);
});
