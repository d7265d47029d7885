/**
 * Errors of layouts from photos: random cameras, as people hold them, see random layouts on a table. Taps
 * have Gaussian errors; the parts of the photo around the balls and the rails are rendered, with the blur of a lens and
 * the noise of a sensor. Prints the results and writes them to benches/results/photo.json.
 */
import { writeFileSync } from "node:fs";
import { expect, test } from "vitest";
import { load, type Point } from "../src/engine/index.ts";
import {
  calibrate,
  TAP_ERROR,
  type Calibration,
  type Size,
} from "../src/photo/geometry/calibrate.ts";
import { project } from "../src/photo/geometry/camera.ts";
import { landmarks } from "../src/photo/geometry/landmarks.ts";
import { layout, tableOf, type TableOfPhoto } from "../src/photo/geometry/photo-layout.ts";
import { locate } from "../src/photo/geometry/locate.ts";
import { contradicts } from "../src/photo/geometry/proportion.ts";
import { outline } from "../src/photo/picture/ball-outline.ts";
import type { Pixels } from "../src/photo/picture/pixels.ts";
import { straightened } from "../src/photo/picture/rails.ts";
import { refine } from "../src/photo/picture/refine.ts";
import { relativeSize } from "../src/photo/picture/ball-size.ts";
import { generator, type Random } from "../tests/photo/random.ts";
import { renderRails } from "../tests/photo/tiles.ts";
import { lit, render } from "../tests/photo/render.ts";
import { CAMERAS, randomLayout, randomView, STANDS, type View } from "../tests/photo/views.ts";
import { commitAndDate } from "./commit.ts";
import { ROOT } from "./measure.ts";

const PHOTOS = 200;
/** Largest median error with four and with six taps, mm. */
const LARGEST_MEDIAN = 8;
/** In one of this number of photos the size of the balls is compared with two tables. */
const SIZED = 5;
/** Least and most balls of a layout. */
const BALLS = [9, 15] as const;
const CORNERS = [0, 1, 3, 4];
const ALL = [0, 1, 2, 3, 4, 5];

const engine = await load();
const preset = (name: string): TableOfPhoto =>
  tableOf(engine, {
    format: "carom-shot/1",
    table: name,
    balls: [{ id: "cue", position: [0.5, 0.5] }],
  });
const table = preset("wpa-9ft");
const SEVEN_FOOT = preset("bar-7ft");
const { geometry, radius } = table;
const marks = landmarks(geometry)!;

/** Errors of balls by the stand of the photographer, mm. */
type Errors = Record<(typeof STANDS)[number], number[]>;

const empty = (): Errors => ({ end: [], side: [], corner: [] });

interface Tally {
  /** By name: number of taps, and where the pixel of a ball comes from. */
  readonly errors: Readonly<Record<string, Errors>>;
  /** Distances of taps and of refined pixels from the balls' centres, pixels. */
  readonly pixels: Readonly<Record<"tapped" | "refined", number[]>>;
  balls: number;
  unrefined: number;
  /** Calibrations that failed, exchanged the long and short rails or were called a misfit. */
  failed: number;
  misfits: number;
  /** Calibrations to which the rails added nothing. */
  unstraightened: number;
  /** Photos in which the size of the balls was measured, contradicts the true table, or one of 7 feet. */
  sized: number;
  contradicted: number;
  contradicted_7ft: number;
}

/** A ball in a photo. */
interface Seen {
  readonly center: Point;
  readonly tap: Point;
  /** By the outline near the tap; null if there is none. */
  readonly refined: Point | null;
  readonly part: Pixels;
}

/** The place of a ball in a photo, by a tap and by the outline near it. */
function seen(view: View, scene: ReturnType<typeof lit>, at: Point, random: Random): Seen {
  const center = project(view.camera, [...at, radius])!;
  const deviation = TAP_ERROR * view.photo[0];
  const tap: Point = [
    center[0] + random.gaussian(deviation),
    center[1] + random.gaussian(deviation),
  ];
  const size = Math.max(
    ...outline(view.camera, center, radius)!.map(({ offset }) => Math.hypot(...offset)),
  );
  const half = Math.ceil(2.4 * size + 4 * deviation + 2);
  const [left, top] = [Math.floor(tap[0]) - half, Math.floor(tap[1]) - half];
  const part = render(scene, { left, top, width: 2 * half, height: 2 * half }, random);
  return { center, tap, refined: refine(part, view.camera, tap, { radius, slack: 0 }), part };
}

/** Whether the size of the balls contradicts a table that the user may have chosen. */
function isContradicted(
  chosen: TableOfPhoto,
  taps: readonly Point[],
  photo: Size,
  balls: readonly Seen[],
): boolean {
  const found = calibrate(landmarks(chosen.geometry)!, taps, photo);
  if (!found) return false;
  const sizes = balls.flatMap(({ part, tap }) => {
    const center = refine(part, found.camera, tap, { radius: chosen.radius, slack: 0 });
    return (center && relativeSize(part, found.camera, center, chosen.radius)) ?? [];
  });
  return contradicts(sizes.sort((a, b) => a - b)[sizes.length >> 1] ?? 1);
}

/** Distance of two places, if the calibration may have exchanged the ends of the table, mm. */
function error([x, y]: Point, at: Point, calibration: Calibration): number {
  const isTurned = calibration.places[0] !== 0;
  const [u, v] = isTurned ? [marks.size[0] - x, marks.size[1] - y] : [x, y];
  return 1e3 * Math.hypot(u - at[0], v - at[1]);
}

function measure(seed: number, tally: Tally): void {
  const random = generator(seed);
  const view = randomView(random, marks);
  const count = Math.floor(random.uniform(BALLS[0], BALLS[1] + 1));
  const places = randomLayout(random, marks.size, count, radius);
  const balls = places.map((position, k) => ({ id: k === 0 ? "cue" : String(k), position }));
  const scene = lit(random, { table: geometry, balls, radius, camera: view.camera });
  const deviation = TAP_ERROR * view.photo[0];
  const taps = marks.places.map((place): Point => {
    const [x, y] = project(view.camera, place)!;
    return [x + random.gaussian(deviation), y + random.gaussian(deviation)];
  });
  const pixels = places.map((at) => seen(view, scene, at, random));
  tally.balls += count;
  for (const { center, tap, refined } of pixels) {
    const away = ([x, y]: Point) => Math.hypot(x - center[0], y - center[1]);
    tally.pixels.tapped.push(away(tap));
    tally.pixels.refined.push(away(refined ?? tap));
    if (!refined) tally.unrefined += 1;
  }
  if (seed % SIZED === 0) {
    tally.sized += 1;
    if (isContradicted(table, taps, view.photo, pixels)) tally.contradicted += 1;
    if (isContradicted(SEVEN_FOOT, taps, view.photo, pixels)) tally.contradicted_7ft += 1;
  }
  const rails = renderRails(scene, view.photo, random);
  for (const which of [CORNERS, ALL]) {
    const chosen = which.map((k) => taps[k]!);
    const tapped = calibrate(marks, chosen, view.photo);
    const found = tapped && straightened(tapped, marks, chosen, rails);
    if (!found || (found.places[0] !== 0 && found.places[0] !== 3)) {
      tally.failed += 1;
      continue;
    }
    if (!found.fits) tally.misfits += 1;
    if (found === tapped) tally.unstraightened += 1;
    const add = (name: string, k: number, place: Point) =>
      tally.errors[`${which.length} taps, ${name}`]![view.stand].push(
        error(place, places[k]!, found),
      );
    const at = (pixel: Point) => locate(found, pixel, radius)!.position;
    const best = pixels.map(({ tap, refined }) => at(refined ?? tap));
    pixels.forEach(({ tap, refined }, k) =>
      add("without rails", k, locate(tapped, refined ?? tap, radius)!.position),
    );
    pixels.forEach(({ tap }, k) => add("tapped", k, at(tap)));
    best.forEach((place, k) => add("refined", k, place));
    const settled = layout(
      engine,
      table,
      best.map((position, k) => ({ id: balls[k]!.id, position })),
    );
    settled?.balls.forEach(({ position }, k) => add("layout", k, [position[0], position[1]]));
  }
}

function quantile(values: readonly number[], share: number): number {
  const sorted = values.toSorted((a, b) => a - b);
  return Number(sorted[Math.floor(share * (sorted.length - 1))]!.toFixed(2));
}

function summary(values: readonly number[]) {
  return { median: quantile(values, 0.5), percentile_95: quantile(values, 0.95) };
}

test("layouts from photos are exact to some millimetres", { timeout: 3_600_000 }, () => {
  // The commit that is measured, not the one at the end.
  const stamp = commitAndDate();
  const names = ["tapped", "without rails", "refined", "layout"].flatMap((name) =>
    [CORNERS, ALL].map(({ length }) => `${length} taps, ${name}`),
  );
  const tally: Tally = {
    errors: Object.fromEntries(names.map((name) => [name, empty()])),
    pixels: { tapped: [], refined: [] },
    balls: 0,
    unrefined: 0,
    failed: 0,
    misfits: 0,
    unstraightened: 0,
    sized: 0,
    contradicted: 0,
    contradicted_7ft: 0,
  };
  for (let seed = 0; seed < PHOTOS; seed += 1) measure(seed, tally);
  const { errors, pixels, ...counts } = tally;
  const result = {
    ...stamp,
    table: geometry.name,
    photos: PHOTOS,
    ...counts,
    tap_deviation_of_width: TAP_ERROR,
    cameras: CAMERAS,
    errors_mm: Object.fromEntries(
      Object.entries(errors).map(([name, by]) => [
        name,
        {
          ...summary(Object.values(by).flat()),
          ...Object.fromEntries(STANDS.map((stand) => [stand, summary(by[stand])])),
        },
      ]),
    ),
    errors_px: { tapped: summary(pixels.tapped), refined: summary(pixels.refined) },
  };
  writeFileSync(`${ROOT}benches/results/photo.json`, `${JSON.stringify(result, null, 2)}\n`);
  console.log(JSON.stringify(result, null, 2));
  for (const name of ["4 taps, layout", "6 taps, layout"]) {
    expect(result.errors_mm[name]!.median, name).toBeLessThan(LARGEST_MEDIAN);
  }
});
