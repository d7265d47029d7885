import { expect, test } from "vitest";
import { load, type Point } from "../../../src/engine/index.ts";
import { calibrate } from "../../../src/photo/geometry/calibrate.ts";
import { project } from "../../../src/photo/geometry/camera.ts";
import { landmarks } from "../../../src/photo/geometry/landmarks.ts";
import { tableOf } from "../../../src/photo/geometry/photo-layout.ts";
import { contradicts, fittingPreset } from "../../../src/photo/geometry/proportion.ts";
import { refine } from "../../../src/photo/picture/refine.ts";
import { relativeSize } from "../../../src/photo/picture/ball-size.ts";
import { generator } from "../../photo/random.ts";
import { lit, render } from "../../photo/render.ts";
import { randomLayout, randomView } from "../../photo/views.ts";

const engine = await load();

function preset(name: string) {
  const balls = [{ id: "cue", position: [0.4, 0.4] as const }];
  return tableOf(engine, { format: "carom-shot/1", table: name, balls });
}

/** Median size of six balls of a rendered photo of `real`, if the user has chosen `chosen`. */
function medianSize(real: string, chosen: string, seed: number): number {
  const random = generator(seed);
  const { geometry, radius } = preset(real);
  const marks = landmarks(geometry)!;
  const view = randomView(random, marks);
  const places = randomLayout(random, marks.size, 6, radius);
  const balls = places.map((position, k) => ({ id: String(2 * k + 1), position }));
  const scene = lit(random, { table: geometry, balls, radius, camera: view.camera });
  const taps = marks.places.map((place): Point => {
    const [x, y] = project(view.camera, place)!;
    return [x + random.gaussian(1.5), y + random.gaussian(1.5)];
  });
  const other = preset(chosen);
  const { camera } = calibrate(landmarks(other.geometry)!, taps, view.photo)!;
  const sizes = places.map((at) => {
    const [x, y] = project(view.camera, [...at, radius])!;
    const tap: Point = [x + random.gaussian(1.5), y + random.gaussian(1.5)];
    const frame = { left: Math.floor(x) - 50, top: Math.floor(y) - 50, width: 100, height: 100 };
    const pixels = render(scene, frame, random);
    const center = refine(pixels, camera, tap, { radius: other.radius, slack: 0 }) ?? tap;
    return relativeSize(pixels, camera, center, other.radius)!;
  });
  return sizes.sort((a, b) => a - b)[3]!;
}

for (const [real, chosen] of [
  ["wpa-9ft", "wpa-9ft"],
  ["bar-7ft", "wpa-9ft"],
  ["wpa-9ft", "bar-7ft"],
] as const) {
  test(`balls on ${real} ${real === chosen ? "fit" : "do not fit"} ${chosen}`, () => {
    const sizes = [1, 2, 3].map((seed) => medianSize(real, chosen, seed));
    for (const size of sizes) {
      expect(contradicts(size), `size ${size}`).toBe(real !== chosen);
      if (real !== chosen) expect(fittingPreset(engine, preset(chosen), size)).not.toBe(chosen);
    }
  });
}

test("a ball of a third more than its size belongs to a table of 7 feet", () => {
  expect(fittingPreset(engine, preset("wpa-9ft"), 1.27 / 0.9652)).toBe("bar-7ft");
  expect(fittingPreset(engine, preset("wpa-9ft"), 3)).toBeNull();
});
