import { expect, test } from "vitest";
import { load, type Point } from "../../../src/engine/index.ts";
import { project } from "../../../src/photo/geometry/camera.ts";
import { refine } from "../../../src/photo/picture/refine.ts";
import { generator } from "../../photo/random.ts";
import { lit, render } from "../../photo/render.ts";
import { lookAt } from "../../photo/views.ts";

const engine = await load();
const RADIUS = 0.028575;
const BALL = { radius: RADIUS, slack: 0 };
const table = engine.tables.find(({ name }) => name === "wpa-9ft")!;
const camera = lookAt({
  eye: [0.6, -1, 1.2],
  target: [0.635, 0.95, 0],
  roll: 0,
  lens: { focal: 800, k1: -0.05, center: [600, 450] },
});

/** A part of a photo of balls, around the first of them. */
function photo(balls: readonly { id: string; position: Point }[], at: Point, seed: number) {
  const random = generator(seed);
  const [x, y] = project(camera, [...at, RADIUS])!;
  const scene = lit(random, { table, balls, radius: RADIUS, camera });
  const frame = { left: Math.floor(x) - 40, top: Math.floor(y) - 40, width: 80, height: 80 };
  return { pixels: render(scene, frame, random), center: [x, y] as const };
}

for (const id of ["cue", "1", "6", "8", "13"]) {
  test(`a tap 3 pixels beside ball ${id} is moved to its centre`, () => {
    const at: Point = [0.6, 0.7];
    const { pixels, center } = photo([{ id, position: at }], at, 4);
    for (const [dx, dy] of [
      [3, 0],
      [-2, 2],
      [0, -3],
    ] as const) {
      const found = refine(pixels, camera, [center[0] + dx, center[1] + dy], BALL)!;
      expect(Math.hypot(found[0] - center[0], found[1] - center[1])).toBeLessThan(1.2);
    }
  });
}

test("the tap of a finger beside a ball is moved to its centre", () => {
  const at: Point = [0.6, 0.7];
  const { pixels, center } = photo([{ id: "3", position: at }], at, 4);
  const finger = { radius: RADIUS, slack: 20 };
  for (const [dx, dy] of [
    [13, 0],
    [-9, 9],
    [0, -13],
  ] as const) {
    const tap: Point = [center[0] + dx, center[1] + dy];
    const found = refine(pixels, camera, tap, finger)!;
    expect(Math.hypot(found[0] - center[0], found[1] - center[1])).toBeLessThan(1.2);
    const exact = refine(pixels, camera, tap, BALL);
    if (exact) expect(Math.hypot(exact[0] - tap[0], exact[1] - tap[1])).toBeLessThan(13);
  }
});

test("a tap on the front one of two balls stays on it", () => {
  const at: Point = [0.6, 0.7];
  const balls = [
    { id: "1", position: at },
    { id: "2", position: [0.62, 0.7 + 0.054] as const },
  ];
  const { pixels, center } = photo(balls, at, 6);
  const found = refine(pixels, camera, [center[0] + 1, center[1] - 1], BALL)!;
  expect(Math.hypot(found[0] - center[0], found[1] - center[1])).toBeLessThan(1.5);
});

test("bare cloth has no outline", () => {
  const at: Point = [0.6, 0.7];
  const { pixels, center } = photo([], at, 2);
  expect(refine(pixels, camera, center, BALL)).toBeNull();
});
