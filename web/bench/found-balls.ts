/** What is found in a random disturbed photo of a random layout, and what lies there. */
import { load, type Point } from "../src/engine/index.ts";
import { calibrate, TAP_ERROR } from "../src/photo/geometry/calibrate.ts";
import { project } from "../src/photo/geometry/camera.ts";
import { landmarks } from "../src/photo/geometry/landmarks.ts";
import { tableOf, type TableOfPhoto } from "../src/photo/geometry/photo-layout.ts";
import { trayOf } from "../src/photo/photo-draft.ts";
import { findBalls, type NamedBall } from "../src/photo/picture/find-balls.ts";
import { straightened } from "../src/photo/picture/rails.ts";
import { look } from "../src/viewer/balls/look.ts";
import { disturbed } from "../tests/photo/disturb.ts";
import { generator, type Random } from "../tests/photo/random.ts";
import { type Color, lit, type SceneBall } from "../tests/photo/render.ts";
import { renderTable } from "../tests/photo/tiles.ts";
import { randomLayout, randomView } from "../tests/photo/views.ts";

/** Least and most balls of a layout, if the set has as many. */
const BALLS = [9, 15] as const;
/** A ball is seen if one is found this near, radii in the photo. */
const NEAR = 0.5;
/** Cloths of snooker and carom; those of pool have more colours. */
const CLOTHS: readonly Color[] = [
  [30, 120, 80],
  [40, 95, 150],
  [25, 80, 60],
];

const engine = await load();

/** What was found in some photos. */
export interface Tally {
  photos: number;
  balls: number;
  seen: number;
  right: number;
  /** Found where no ball is. */
  extra: number;
  /** Calibrations that failed or exchanged the rails. */
  failed: number;
}

function shuffled(ids: readonly string[], random: Random): string[] {
  const drawn = ids.map((id) => ({ id, at: random.uniform(0, 1) }));
  return drawn.sort((a, b) => a.at - b.at).map(({ id }) => id);
}

/** Whether two balls look alike, as two reds. */
function isSame(a: string, b: string): boolean {
  const [one, other] = [look(a, 0), look(b, 0)];
  return one.body === other.body && one.label === other.label && one.dots === other.dots;
}

export const nothing = (): Tally => ({
  photos: 0,
  balls: 0,
  seen: 0,
  right: 0,
  extra: 0,
  failed: 0,
});

/** A table of a preset. */
export function presetTable(name: string): TableOfPhoto {
  const balls = [{ id: "cue", position: [0.5, 0.5] as const }];
  return tableOf(engine, { format: "carom-shot/1", table: name, balls });
}

/** Adds what is found in a random photo of a table. */
export function findIn(table: TableOfPhoto, seed: number, tally: Tally): void {
  const random = generator(seed);
  const { geometry, radius } = table;
  const marks = landmarks(geometry)!;
  const view = randomView(random, marks);
  const tray = trayOf(engine, geometry);
  const count = Math.min(tray.length, Math.floor(random.uniform(BALLS[0], BALLS[1] + 1)));
  const ids = [tray[0]!, ...shuffled(tray.slice(1), random)].slice(0, count);
  const places = randomLayout(random, marks.size, count, radius);
  const balls = places.map((position, k): SceneBall => ({ id: ids[k]!, position }));
  const drawn = lit(random, { table: geometry, balls, radius, camera: view.camera });
  const isPool = tray.includes("15");
  const scene = isPool ? drawn : { ...drawn, cloth: random.choice(CLOTHS) };
  const photo = disturbed(renderTable(scene, view.photo, random), random);
  const deviation = TAP_ERROR * view.photo[0];
  const taps = marks.places.map((place): Point => {
    const [x, y] = project(view.camera, place)!;
    return [x + random.gaussian(deviation), y + random.gaussian(deviation)];
  });
  tally.photos += 1;
  tally.balls += count;
  const tapped = calibrate(marks, taps, view.photo);
  if (!tapped || (tapped.places[0] !== 0 && tapped.places[0] !== 3)) {
    tally.failed += 1;
    return;
  }
  const { camera } = straightened(tapped, marks, taps, photo);
  const searched = { size: marks.size, radius, pockets: geometry.pockets };
  const found = new Set(findBalls(photo, camera, searched, tray));
  for (const { id, position } of balls) {
    const center = project(view.camera, [...position, radius])!;
    const near = nearest(found, center);
    if (!near) continue;
    found.delete(near);
    tally.seen += 1;
    if (isSame(near.id, id)) tally.right += 1;
  }
  tally.extra += found.size;
}

/** The found ball at a pixel; null if none is near. */
function nearest(found: ReadonlySet<NamedBall>, [x, y]: Point): NamedBall | null {
  const away = ({ pixel }: NamedBall) => Math.hypot(pixel[0] - x, pixel[1] - y);
  const best = [...found].sort((a, b) => away(a) - away(b))[0];
  if (!best) return null;
  return away(best) < NEAR * Math.hypot(...best.points[0]!.offset) ? best : null;
}
