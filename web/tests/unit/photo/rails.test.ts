import { expect, test } from "vitest";
import { load, type Point } from "../../../src/engine/index.ts";
import { calibrate, type Calibration, type Size } from "../../../src/photo/geometry/calibrate.ts";
import { meet, project } from "../../../src/photo/geometry/camera.ts";
import { landmarks } from "../../../src/photo/geometry/landmarks.ts";
import { tableOf } from "../../../src/photo/geometry/photo-layout.ts";
import { straightened } from "../../../src/photo/picture/rails.ts";
import { renderRails } from "../../photo/tiles.ts";
import { generator } from "../../photo/random.ts";
import { lit } from "../../photo/render.ts";
import { lookAt } from "../../photo/views.ts";

const engine = await load();
const RADIUS = 0.028575;
const PHOTO: Size = [1200, 900];
const BALLS = [
  { id: "cue", position: [0.3, 0.5] as const },
  { id: "1", position: [0.9, 1.2] as const },
  { id: "2", position: [0.7, 2.2] as const },
];
const TABLE = tableOf(engine, { format: "carom-shot/1", table: "wpa-9ft", balls: BALLS });
const MARKS = landmarks(TABLE.geometry)!;
/** A wide lens with barrel distortion. */
const CAMERA = lookAt({
  eye: [0.3, -0.9, 1.3],
  target: [0.6, 0.75, 0],
  roll: 0.02,
  lens: { focal: 760, k1: -0.12, center: [600, 450] },
});
/** Errors of the taps on the four corners, pixels. */
const ERRORS: readonly Point[] = [
  [1.4, -0.8],
  [-1.1, 1.2],
  [0.6, 1.5],
  [-1.3, -0.4],
];
const TAPS = [0, 1, 3, 4].map((k, i): Point => {
  const [x, y] = project(CAMERA, MARKS.places[k]!)!;
  return [x + ERRORS[i]![0], y + ERRORS[i]![1]];
});

/** Largest error of a ball whose pixel is known exactly, m. */
function worst({ camera, places }: Calibration): number {
  const isTurned = places[0] !== 0;
  return Math.max(
    ...BALLS.map(({ position: [x, y] }) => {
      const [u, v] = meet(camera, project(CAMERA, [x, y, RADIUS])!, RADIUS)!;
      const [across, along] = MARKS.size;
      return isTurned ? Math.hypot(across - u - x, along - v - y) : Math.hypot(u - x, v - y);
    }),
  );
}

test("the rails in a photo show the distortion that four taps cannot", () => {
  // Seen: with the corners only, layouts were wrong by 10 mm in the median (docs/photo.md).
  const random = generator(1);
  const scene = lit(random, {
    table: TABLE.geometry,
    balls: BALLS,
    radius: RADIUS,
    camera: CAMERA,
  });
  const pixels = renderRails(scene, PHOTO, random);
  const tapped = calibrate(MARKS, TAPS, PHOTO)!;
  const found = straightened(tapped, MARKS, TAPS, pixels);
  expect(Math.abs(tapped.camera.k1 - CAMERA.k1)).toBeGreaterThan(0.04);
  expect(Math.abs(found.camera.k1 - CAMERA.k1)).toBeLessThan(0.02);
  expect(worst(found)).toBeLessThan(0.5 * worst(tapped));
  expect(found.fits).toBe(true);
  // A landmark that moves keeps the distortion: the search for it takes longest.
  const again = straightened(tapped, MARKS, TAPS, pixels, found.camera.k1);
  expect(worst(again)).toBeLessThan(0.5 * worst(tapped));
});

test("a photo without visible rails, or of another table, keeps its calibration", () => {
  const grey = {
    left: 0,
    top: 0,
    width: PHOTO[0],
    height: PHOTO[1],
    data: new Uint8ClampedArray(4 * PHOTO[0] * PHOTO[1]).fill(128),
  };
  const tapped = calibrate(MARKS, TAPS, PHOTO)!;
  expect(straightened(tapped, MARKS, TAPS, grey)).toBe(tapped);
  const misfit = { ...tapped, fits: false };
  expect(straightened(misfit, MARKS, TAPS, grey)).toBe(misfit);
});
