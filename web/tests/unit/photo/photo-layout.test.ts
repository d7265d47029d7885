import { expect, test } from "vitest";
import { load, type Point, type ShotFile } from "../../../src/engine/index.ts";
import { layout, shotFile, tableOf } from "../../../src/photo/geometry/photo-layout.ts";
import { bed, settle } from "../../../src/photo/geometry/settle.ts";
import { generator } from "../../photo/random.ts";
import { randomLayout } from "../../photo/views.ts";

const engine = await load();
const RADIUS = 0.028575;
const NINE_FOOT: ShotFile = {
  format: "carom-shot/1",
  table: "wpa-9ft",
  balls: [{ id: "cue", position: [0.6, 0.6] }],
};
const table = tableOf(engine, NINE_FOOT);
const on = bed(table.geometry, RADIUS);

function gap([a, b]: Point, [x, y]: Point): number {
  return Math.hypot(a - x, b - y) - 2 * RADIUS;
}

test("balls with a small gap touch, and balls with a large one stay", () => {
  const { positions, contacts } = settle(
    [
      [0.5, 0.5],
      [0.5 + 2 * RADIUS + 0.004, 0.5],
      [0.5, 0.5 + 2 * RADIUS + 0.02],
    ],
    on,
  );
  expect(Math.abs(gap(positions[0]!, positions[1]!))).toBeLessThan(1e-9);
  expect(positions[2]).toEqual([0.5, 0.5 + 2 * RADIUS + 0.02]);
  expect(contacts).toEqual([{ ball: 1, other: 0 }]);
});

test("balls that overlap, even at one place, are pushed to contact", () => {
  const { positions } = settle(
    [
      [0.5, 0.5],
      [0.51, 0.5],
      [0.8, 0.9],
      [0.8, 0.9],
    ],
    on,
  );
  expect(Math.abs(gap(positions[0]!, positions[1]!))).toBeLessThan(1e-9);
  expect(Math.abs(gap(positions[2]!, positions[3]!))).toBeLessThan(1e-9);
});

test("a ball near a rail is frozen to it for the engine, on all four sides", () => {
  const [width, length] = table.geometry.size!;
  const near = RADIUS + 0.003;
  for (const position of [
    [near, 0.6],
    [width - near, 0.6],
    [0.4, near],
    [0.4, length - near],
  ] as const) {
    const found = layout(engine, table, [{ id: "cue", position }])!;
    expect(found.contacts).toHaveLength(1);
    // A ball one nanometre deeper would still be accepted, and one a micrometre deeper not.
    const [x, y] = found.balls[0]!.position;
    const [dx, dy] = [x - position[0], y - position[1]].map((v) => Math.sign(v) * 1e-6);
    const deeper = { id: "cue", position: [x + dx!, y + dy!] as const };
    expect(() => engine.shot(shotFile(table.equipment, [deeper]))).toThrow("cushion");
  }
});

test("a rack of fifteen balls, each off by millimetres, touches everywhere", () => {
  const random = generator(5);
  const rack: Point[] = [];
  for (let row = 0; row < 5; row += 1) {
    for (let k = 0; k <= row; k += 1) {
      const x = 0.635 + (2 * k - row) * RADIUS;
      rack.push([x, 1.9 + row * Math.sqrt(3) * RADIUS]);
    }
  }
  const seen = rack.map(([x, y]): Point => [x + random.gaussian(7e-4), y + random.gaussian(7e-4)]);
  const { positions, contacts } = settle(seen, on);
  expect(contacts).toHaveLength(30);
  positions.forEach(([x, y], k) => {
    expect(Math.hypot(x - rack[k]![0], y - rack[k]![1])).toBeLessThan(0.004);
  });
});

test("the engine accepts the layout of random, partly overlapping taps", () => {
  for (let seed = 0; seed < 60; seed += 1) {
    const random = generator(seed);
    const size = table.geometry.size!;
    const cluster = random.uniform(0.1, 0.9);
    const found = Array.from({ length: 15 }, (_, k) => ({
      id: k === 0 ? "cue" : String(k),
      position: [0, 1].map((i) =>
        k < 6 ? cluster * size[i]! + random.gaussian(0.04) : random.uniform(-0.02, size[i]! + 0.02),
      ) as unknown as Point,
    }));
    const result = layout(engine, table, found);
    expect(result, `seed ${seed}`).not.toBeNull();
    engine.shot(shotFile(table.equipment, result!.balls)).free();
  }
});

test("a valid layout without near contacts is not changed", () => {
  const random = generator(8);
  const size = table.geometry.size!;
  const inner: Point = [size[0] - 0.2, size[1] - 0.2];
  const places = randomLayout(random, inner, 9, 0.05).map(([x, y]): Point => [x + 0.1, y + 0.1]);
  const found = places.map((position, k) => ({ id: String(k + 1), position }));
  expect(layout(engine, table, found)!.balls.map(({ position }) => position)).toEqual(places);
});

test("a ball over a pocket is put beside its hole", () => {
  for (const { center } of table.geometry.pockets) {
    const found = layout(engine, table, [{ id: "8", position: center }])!;
    const [x, y] = found.balls[0]!.position;
    expect(Math.hypot(x - center[0], y - center[1])).toBeLessThan(0.15);
  }
});
