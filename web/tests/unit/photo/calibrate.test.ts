import { expect, test } from "vitest";
import { load, type Point } from "../../../src/engine/index.ts";
import { calibrate } from "../../../src/photo/geometry/calibrate.ts";
import { project } from "../../../src/photo/geometry/camera.ts";
import { landmarks, type Landmarks } from "../../../src/photo/geometry/landmarks.ts";
import { locate } from "../../../src/photo/geometry/locate.ts";
import { generator, type Random } from "../../photo/random.ts";
import { randomLayout, randomView, type View } from "../../photo/views.ts";
import { tableOf, UNBOUNDED } from "../viewer/tables.ts";

const engine = await load();
const TABLE = landmarks(tableOf("wpa-9ft"))!;
const RADIUS = 0.028575;
const CORNERS = [0, 1, 3, 4];
const ALL = [0, 1, 2, 3, 4, 5];

/** Taps on some landmarks of a view. */
function tapped(view: View, table: Landmarks, which: readonly number[], noise?: Random): Point[] {
  return which.map((place) => {
    const [x, y] = project(view.camera, table.places[place]!)!;
    return [x + (noise?.gaussian(1.5) ?? 0), y + (noise?.gaussian(1.5) ?? 0)];
  });
}

test("exact taps on six landmarks give the camera on every table with rails", () => {
  for (const geometry of engine.tables) {
    const table = landmarks(geometry)!;
    const view = randomView(generator(3), table);
    const found = calibrate(table, tapped(view, table, ALL), view.photo)!;
    expect(found.residual, geometry.name!).toBeLessThan(0.6);
    expect(Math.abs(found.camera.focal / view.camera.focal - 1)).toBeLessThan(0.03);
    expect(found.fits).toBe(true);
  }
});

test("the order of the taps does not matter", () => {
  for (let seed = 0; seed < 20; seed += 1) {
    const view = randomView(generator(seed), TABLE);
    for (const which of [CORNERS, [0, 1, 2, 3, 4], ALL]) {
      const sorted = calibrate(TABLE, tapped(view, TABLE, which), view.photo)!;
      const other = which.toReversed().map((_, k) => which[(k * 5 + 2) % which.length]!);
      const shuffled = [...new Set([...other, ...which])];
      const again = calibrate(TABLE, tapped(view, TABLE, shuffled), view.photo)!;
      const places = shuffled.map((place) => sorted.places[which.indexOf(place)]);
      expect(again.places).toEqual(places);
      expect(again.camera.focal).toBeCloseTo(sorted.camera.focal, 3);
    }
  }
});

test("the corners alone tell the long rails from the short ones", () => {
  let wrong = 0;
  for (let seed = 0; seed < 100; seed += 1) {
    const random = generator(seed);
    const view = randomView(random, TABLE);
    const found = calibrate(TABLE, tapped(view, TABLE, CORNERS, random), view.photo)!;
    if (found.places[0] !== 0 && found.places[0] !== 3) wrong += 1;
  }
  expect(wrong).toBe(0);
});

test("turning exchanges the ends of the table", () => {
  const view = randomView(generator(1), TABLE);
  const taps = tapped(view, TABLE, ALL);
  const pixel = project(view.camera, [0.3, 0.8, RADIUS])!;
  const [a, b] = [false, true].map(
    (turned) => locate(calibrate(TABLE, taps, view.photo, turned)!, pixel, RADIUS)!.position,
  );
  expect(a![0] + b![0]).toBeCloseTo(TABLE.size[0], 5);
  expect(a![1] + b![1]).toBeCloseTo(TABLE.size[1], 5);
});

test("taps with the noise of a hand fit, and a tap beside its pocket does not", () => {
  let [fits, misfits] = [0, 0];
  for (let seed = 0; seed < 100; seed += 1) {
    const random = generator(seed);
    const view = randomView(random, TABLE);
    const taps = tapped(view, TABLE, ALL, random);
    if (calibrate(TABLE, taps, view.photo)?.fits) fits += 1;
    const middle = taps.findIndex((_, k) => k === 2);
    const moved = taps.with(middle, [taps[middle]![0] + 70, taps[middle]![1] + 70]);
    if (!calibrate(TABLE, moved, view.photo)?.fits) misfits += 1;
  }
  expect(fits).toBe(100);
  expect(misfits).toBeGreaterThan(90);
});

test("the predicted error is the true one", () => {
  let [predicted, actual, count] = [0, 0, 0];
  for (let seed = 0; seed < 60; seed += 1) {
    const random = generator(seed);
    const view = randomView(random, TABLE);
    const found = calibrate(TABLE, tapped(view, TABLE, ALL, random), view.photo)!;
    const isTurned = found.places[0] !== 0;
    for (const [x, y] of randomLayout(random, TABLE.size, 10, RADIUS)) {
      const [u, v] = project(view.camera, [x, y, RADIUS])!;
      const pixel = [u + random.gaussian(1.5), v + random.gaussian(1.5)] as const;
      const { position, error } = locate(found, pixel, RADIUS)!;
      const [a, b] = isTurned
        ? [TABLE.size[0] - position[0], TABLE.size[1] - position[1]]
        : position;
      predicted += error ** 2;
      actual += (a - x) ** 2 + (b - y) ** 2;
      count += 1;
    }
  }
  expect(Math.sqrt(actual / count)).toBeLessThan(0.03);
  expect(Math.sqrt(predicted / actual)).toBeGreaterThan(0.8);
  expect(Math.sqrt(predicted / actual)).toBeLessThan(1.25);
});

test("three taps in a line and an unbounded cloth are refused", () => {
  expect(landmarks(UNBOUNDED)).toBeNull();
  const line: Point[] = [
    [100, 100],
    [200, 200],
    [300, 300],
    [400, 400],
  ];
  expect(calibrate(TABLE, line, [1200, 900])).toBeNull();
});
