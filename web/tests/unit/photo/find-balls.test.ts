import { expect, test } from "vitest";
import { load, type Point } from "../../../src/engine/index.ts";
import { project } from "../../../src/photo/geometry/camera.ts";
import { landmarks } from "../../../src/photo/geometry/landmarks.ts";
import { bow } from "../../../src/photo/geometry/lens.ts";
import { tableOf } from "../../../src/photo/geometry/photo-layout.ts";
import { trayOf } from "../../../src/photo/photo-draft.ts";
import { Session } from "../../../src/photo/photo-session.ts";
import { findBalls } from "../../../src/photo/picture/find-balls.ts";
import type { Pixels } from "../../../src/photo/picture/pixels.ts";
import { disturbed } from "../../photo/disturb.ts";
import { generator } from "../../photo/random.ts";
import { type Color, lit, type SceneBall } from "../../photo/render.ts";
import { renderTable } from "../../photo/tiles.ts";
import { lookAt } from "../../photo/views.ts";

const engine = await load();
const SIZE = [1000, 750] as const;
const BLUE: Color = [40, 95, 150];

function tableNamed(name: string) {
  const table = tableOf(engine, {
    format: "carom-shot/1",
    table: name,
    balls: [{ id: "cue", position: [0.5, 0.5] }],
  });
  const { geometry, radius } = table;
  const marks = landmarks(geometry)!;
  const [width, length] = marks.size;
  const camera = lookAt({
    eye: [0.4 * width, -0.45 * length, 0.55 * length],
    target: [0.5 * width, 0.4 * length, 0],
    roll: 0.01,
    lens: { focal: 720, k1: -0.04, center: [SIZE[0] / 2, SIZE[1] / 2] },
  });
  const photo = (balls: readonly SceneBall[]): Pixels => {
    const random = generator(7);
    const scene = lit(random, { table: geometry, balls, radius, camera });
    return disturbed(renderTable({ ...scene, cloth: BLUE }, SIZE, random), random);
  };
  const find = (pixels: Pixels) => {
    const searched = { size: marks.size, radius, pockets: geometry.pockets };
    return findBalls(pixels, camera, searched, trayOf(engine, geometry));
  };
  return { table, marks, camera, radius, photo, find };
}

const POOL = tableNamed("wpa-9ft");

/** The found balls at places, as `id` or null. */
function idsAt(
  found: ReturnType<typeof POOL.find>,
  balls: readonly SceneBall[],
  radius: number,
): (string | null)[] {
  return balls.map(({ position: [x, y] }) => {
    const near = found.find(({ place }) => Math.hypot(place[0] - x, place[1] - y) < radius);
    return near?.id ?? null;
  });
}

const BALLS: readonly SceneBall[] = [
  { id: "cue", position: [0.4, 0.5] },
  { id: "1", position: [0.9, 0.6] },
  { id: "3", position: [0.25, 1.1] },
  { id: "5", position: [0.7, 1.0] },
  { id: "8", position: [1.05, 1.3] },
  { id: "9", position: [0.6, 0.3] },
  { id: "11", position: [0.5, 1.6] },
  // Touching, and by a rail.
  { id: "4", position: [0.9572, 0.6] },
  { id: "14", position: [0.03, 0.8] },
];
const PHOTO = POOL.photo(BALLS);

test("the balls of a disturbed photo are found, at most one under another name, and nothing else", () => {
  const found = POOL.find(PHOTO);
  const names = idsAt(found, BALLS, POOL.radius);
  expect(names).not.toContain(null);
  const right = names.filter((name, index) => name === BALLS[index]!.id);
  expect(right.length).toBeGreaterThanOrEqual(BALLS.length - 1);
  expect(found).toHaveLength(BALLS.length);
});

test("an empty table has no balls", () => {
  expect(POOL.find(POOL.photo([]))).toEqual([]);
});

test("snooker balls get their colours, and reds any red", () => {
  const snooker = tableNamed("snooker-12ft");
  const balls: SceneBall[] = [
    { id: "cue", position: [0.6, 0.7] },
    { id: "yellow", position: [1.2, 0.7] },
    { id: "brown", position: [0.9, 1.0] },
    { id: "pink", position: [0.9, 1.9] },
    { id: "black", position: [0.5, 1.4] },
    { id: "red-1", position: [1.3, 1.5] },
    { id: "red-2", position: [1.1, 1.3] },
  ];
  const ids = idsAt(snooker.find(snooker.photo(balls)), balls, snooker.radius);
  const stem = (id: string | null) => id?.replace(/-\d+$/, "");
  expect(ids.map(stem)).toEqual(balls.map(({ id }) => stem(id)));
});

test("suggestions come with the last landmark, and a tap, a drag or a name confirms one", () => {
  const session = new Session(engine, POOL.table, PHOTO);
  for (const place of POOL.marks.places) session.tap(project(POOL.camera, place)!);
  expect(session.suggested).toBe(BALLS.length);
  expect(session.layout!.balls).toHaveLength(BALLS.length);
  expect(session.draft.next).toBe("2");
  session.confirm("8");
  session.rename("3", "2");
  const pixel = session.draft.balls.find(({ id }) => id === "cue")!.pixel;
  session.moveBall("cue", [pixel[0] + 4, pixel[1]], true);
  expect(session.suggested).toBe(BALLS.length - 3);
  expect(session.draft.next).toBe("3");
  // What the user has confirmed stays.
  session.suggest();
  expect(session.suggested).toBe(BALLS.length - 3);
  for (let k = 0; k < 4; k += 1) session.undo();
  expect(session.draft.balls).toEqual([]);
  expect(session.draft.marked).toBe(true);
});

test("a lens without distortion bends no rail, and a barrel lens does", () => {
  const size: Point = POOL.marks.size;
  expect(bow({ ...POOL.camera, k1: 0 }, size)).toBeLessThan(1e-9);
  expect(bow({ ...POOL.camera, k1: -0.2 }, size)).toBeGreaterThan(0.01);
});
