import { expect, test } from "vitest";
import { load, type Point } from "../../../src/engine/index.ts";
import { project } from "../../../src/photo/geometry/camera.ts";
import { landmarks } from "../../../src/photo/geometry/landmarks.ts";
import { tableOf } from "../../../src/photo/geometry/photo-layout.ts";
import { Session } from "../../../src/photo/photo-session.ts";
import { trayOf } from "../../../src/photo/photo-draft.ts";
import { lookAt } from "../../photo/views.ts";

const engine = await load();
const RADIUS = 0.028575;
const SIZE = [1200, 900] as const;
const TABLE = tableOf(engine, {
  format: "carom-shot/1",
  table: "wpa-9ft",
  balls: [{ id: "cue", position: [0.6, 0.6] }],
});
const CAMERA = lookAt({
  eye: [0.6, -1, 1.3],
  target: [0.635, 0.95, 0],
  roll: 0,
  lens: { focal: 800, k1: 0, center: [SIZE[0] / 2, SIZE[1] / 2] },
});
/** A grey photo: no outline moves a tap. */
const PIXELS = {
  left: 0,
  top: 0,
  width: SIZE[0],
  height: SIZE[1],
  data: new Uint8ClampedArray(4 * SIZE[0] * SIZE[1]).fill(128),
};
const LANDMARKS = landmarks(TABLE.geometry)!.places.map((place) => project(CAMERA, place)!);

function pixelOf([x, y]: Point): Point {
  return project(CAMERA, [x, y, RADIUS])!;
}

function marked(): Session {
  const session = new Session(engine, TABLE, PIXELS);
  for (const pixel of LANDMARKS) expect(session.tap(pixel)).toBe("landmark");
  return session;
}

test("six landmarks and one tap per ball give the layout", () => {
  const session = marked();
  const places: Point[] = [
    [0.3, 0.5],
    [0.9, 1.2],
    [0.5, 2.2],
  ];
  for (const place of places) expect(session.tap(pixelOf(place))).toBe("ball");
  const { balls } = session.layout!;
  expect(balls.map(({ id }) => id)).toEqual(["cue", "1", "2"]);
  balls.forEach(({ position }, k) => {
    expect(Math.hypot(position[0] - places[k]![0], position[1] - places[k]![1])).toBeLessThan(2e-3);
  });
  expect(session.draft.next).toBe("3");
  expect(session.accuracy).toBeGreaterThan(0.001);
});

test("four corners are enough, and undo takes back each step", () => {
  const session = new Session(engine, TABLE, PIXELS);
  for (const k of [0, 1, 3, 4]) session.tap(LANDMARKS[k]!);
  session.finishLandmarks();
  session.tap(pixelOf([0.6, 1]));
  expect(session.layout!.balls).toHaveLength(1);
  session.undo();
  expect(session.draft.balls).toEqual([]);
  session.undo();
  expect(session.draft.marked).toBe(false);
  for (let k = 0; k < 4; k += 1) session.undo();
  expect(session.canUndo).toBe(false);
  expect(session.calibration).toBeNull();
});

test("a drag is one step of the history", () => {
  const session = marked();
  session.tap(pixelOf([0.6, 1]));
  session.moveBall("cue", pixelOf([0.6, 1.1]), true);
  session.moveBall("cue", pixelOf([0.6, 1.2]), false);
  expect(session.layout!.balls[0]!.position[1]).toBeCloseTo(1.2, 2);
  session.undo();
  expect(session.layout!.balls[0]!.position[1]).toBeCloseTo(1, 2);
});

test("a tap beside the table places no ball", () => {
  const session = marked();
  expect(session.tap([10, 10])).toBe("off table");
  expect(session.tap(project(CAMERA, [-0.4, 1, RADIUS])!)).toBe("off table");
  expect(session.draft.balls).toEqual([]);
});

test("a ball can be renamed, exchanged and removed", () => {
  const session = marked();
  session.tap(pixelOf([0.3, 0.5]));
  session.tap(pixelOf([0.9, 0.5]));
  session.rename("cue", "9");
  expect(session.draft.balls.map(({ id }) => id)).toEqual(["9", "1"]);
  session.rename("9", "1");
  expect(session.draft.balls.map(({ id }) => id)).toEqual(["1", "9"]);
  session.remove("1");
  expect(session.draft.next).toBe("1");
  session.choose("cue");
  expect(session.tap(pixelOf([0.6, 1]))).toBe("ball");
  expect(session.draft.balls.map(({ id }) => id)).toEqual(["9", "cue"]);
});

test("another table has its own tray and keeps the balls that it has", () => {
  const session = marked();
  session.tap(pixelOf([0.3, 0.5]));
  session.tap(pixelOf([0.9, 0.5]));
  const snooker = { id: "cue", position: [0.9, 0.9] as const };
  session.changeTable(
    tableOf(engine, { format: "carom-shot/1", table: "snooker-12ft", balls: [snooker] }),
  );
  expect(session.tray).toHaveLength(22);
  expect(session.draft.balls.map(({ id }) => id)).toEqual(["cue"]);
  expect(session.draft.next).toBe("red-1");
  session.undo();
  expect(session.draft.balls.every(({ id }) => session.tray.includes(id))).toBe(true);
});

test("every table with rails has a tray with a cue ball first", () => {
  for (const geometry of engine.tables) {
    const tray = trayOf(engine, geometry);
    expect(tray[0], geometry.name!).toBe("cue");
    const most = geometry.pockets.length === 0 ? 4 : geometry.physics?.startsWith("sn") ? 22 : 16;
    expect(tray, geometry.name!).toHaveLength(most);
  }
});
