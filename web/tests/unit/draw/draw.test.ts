import { beforeEach, describe, expect, test, vi } from "vitest";
import { type DrawnMark, load, type Point } from "../../../src/engine/index.ts";
import type { Context } from "../../../src/app/common/context.ts";
import {
  distanceTo,
  FIRST_DRAWING,
  markBetween,
  marksOf,
  withMarks,
} from "../../../src/app/document/marks.ts";
import { documentOf } from "../../../src/app/document/shot-file.ts";
import { withShot } from "../../../src/app/document/shot-tree.ts";
import { Store } from "../../../src/app/document/store.ts";
import { draw } from "../../../src/app/draw/draw-changes.ts";
import { beginDraw, erase, moveDraw, tapDraw } from "../../../src/app/draw/draw-gesture.ts";
import { snapAt, snapPoints } from "../../../src/app/draw/snap-points.ts";
import { stateFromFragment, stateToFragment } from "../../../src/app/share/link-state.ts";

const engine = await load();

const SHOT = {
  format: "carom-shot/1",
  table: "wpa-9ft",
  balls: [
    { id: "cue", position: [0.5, 0.6] },
    { id: "1", position: [0.6, 1.6] },
  ],
  strike: { ball: "cue", speed: 2, azimuth_deg: 84 },
} as const;

/** Pixels per metre of a picture whose origin is that of the table. */
const SCALE = 500;

let store: Store;
const viewer = {
  pick: (x: number, y: number) => ({ ball: null, point: [x / SCALE, y / SCALE] as Point }),
  project: (x: number, y: number) => [x * SCALE, y * SCALE] as const,
};
const context = { engine, viewer, announce: vi.fn() } as unknown as Context;

const at = ([x, y]: Point, by: Point = [0, 0]) => ({
  clientX: x * SCALE + by[0],
  clientY: y * SCALE + by[1],
  pointerType: "mouse",
});
const marks = () => marksOf(store.document.shot);

beforeEach(() => {
  store = new Store(engine, documentOf(SHOT));
  store.setSession({ drawing: FIRST_DRAWING });
});

/** A drag from a place to another one. */
function drag(...places: ReturnType<typeof at>[]): void {
  const begun = beginDraw(store, context, places[0]!)!;
  for (const place of places) moveDraw(store, context, begun, place, "gesture 1");
  store.settle();
}

describe("a drag", () => {
  test("draws an arrow between the snap points at its ends, as one step of undo", () => {
    const [pocket] = store.shot.geometry.pockets;
    drag(at([0.5, 0.6], [6, -4]), at([0.3, 0.3]), at(pocket!.center, [-5, 5]));
    expect(marks()).toHaveLength(1);
    const [arrow] = marks();
    expect(arrow).toMatchObject({ kind: "arrow", color: "yellow", from: [0.5, 0.6] });
    const { to } = arrow as DrawnMark & { kind: "arrow" };
    expect(Math.hypot(to[0] - pocket!.center[0], to[1] - pocket!.center[1])).toBeLessThan(1e-4);
    expect(store.undo()).toBe(true);
    expect(marks()).toEqual([]);
    expect(store.document.shot).not.toHaveProperty("marks");
  });

  test("draws a circle from its centre and an area from corner to corner", () => {
    store.setSession({ drawing: { ...FIRST_DRAWING, tool: "circle", color: "red" } });
    drag(at([0.6, 1.6]), at([0.6, 1.3]));
    expect(marks()[0]).toEqual({ kind: "circle", color: "red", center: [0.6, 1.6], radius: 0.3 });
    store.setSession({ drawing: { ...FIRST_DRAWING, tool: "area" } });
    drag(at([0.2, 0.2]), at([0.4, 0.9]));
    const outline = [
      [0.2, 0.2],
      [0.4, 0.2],
      [0.4, 0.9],
      [0.2, 0.9],
    ];
    expect(marks()[1]).toEqual({ kind: "area", color: "yellow", outline });
  });

  test("without a length draws nothing", () => {
    drag(at([0.2, 0.2]), at([0.2, 0.2]));
    expect(marks()).toEqual([]);
    expect(markBetween("area", "red", [0.1, 0.1], [0.1, 0.5])).toBeNull();
  });
});

test("places snap to balls, pockets, diamonds and the contacts of the aimed shot", () => {
  const points = snapPoints(store);
  const near = (place: Point) =>
    points.some(({ at: [x, y] }) => Math.hypot(x - place[0], y - place[1]) < 1e-6);
  const { sights, size } = store.shot.geometry;
  expect(near([0.6, 1.6])).toBe(true);
  expect(near([size![0] / 4, -sights!.setback])).toBe(true);
  const ghost = store.ghost.trace!.events.find(({ type }) => type === "ball-collision")!;
  const [x, y] = ghost.before[ghost.balls.indexOf("cue")]!.position;
  expect(near([x, y])).toBe(true);
  const spot = snapAt([0.5 * SCALE + 11, 0.6 * SCALE], points, viewer.project, 12);
  expect(spot?.at).toEqual([0.5, 0.6]);
  expect(snapAt([0.5 * SCALE + 13, 0.6 * SCALE], points, viewer.project, 12)).toBeNull();
});

test("a tap puts the label that was written, and refuses one without text", () => {
  store.setSession({ drawing: { ...FIRST_DRAWING, tool: "label", text: "  " } });
  tapDraw(store, context, at([0.3, 0.4]));
  expect(marks()).toEqual([]);
  expect(store.session.refusal?.message).toMatch(/no text/);
  store.setSession({ drawing: { ...FIRST_DRAWING, tool: "label", text: " ½ ball " } });
  tapDraw(store, context, at([0.3, 0.4]));
  expect(marks()).toEqual([{ kind: "label", color: "yellow", at: [0.3, 0.4], text: "½ ball" }]);
});

test("the eraser removes the nearest mark, and tells where none is", () => {
  const line = (y: number) => markBetween("line", "white", [0.2, y], [0.9, y])!;
  draw(store, [line(0.5), line(0.6)], "draw");
  expect(erase(store, [0.5, 0.52], 0.03)).toBe(true);
  expect(marks()).toEqual([line(0.6)]);
  expect(erase(store, [0.5, 0.52], 0.03)).toBe(false);
  expect(store.session.refusal?.message).toMatch(/No mark is here/);
  expect(
    distanceTo(markBetween("circle", "red", [0.5, 0.5], [0.5, 0.7])!, [0.71, 0.5]),
  ).toBeCloseTo(0.01, 6);
});

test("a position has at most a hundred marks", () => {
  const line = markBetween("line", "white", [0.2, 0.2], [0.9, 0.2])!;
  expect(
    draw(
      store,
      Array.from({ length: 100 }, () => line),
      "draw",
    ),
  ).toBe(true);
  expect(draw(store, [...marks(), line], "draw")).toBe(false);
  expect(store.session.refusal?.message).toMatch(/at most 100 marks/);
});

test("marks stay while the cue turns and in links, and change neither the shot nor its tree", () => {
  const hash = store.ghost.trace!.hash;
  const mark = markBetween("arrow", "blue", [0.2, 0.2], [0.9, 1.2])!;
  draw(store, [mark], "draw");
  expect(store.ghost.trace!.hash).toBe(hash);
  store.strike({ azimuth_deg: 20 }, "aim");
  expect(marks()).toEqual([mark]);
  const state = { ...store.state };
  const link = stateToFragment(engine.withDatedNames(store.shot.file), state);
  expect(stateFromFragment(link)!.shot.marks).toEqual([mark]);
  const bare = withMarks(store.document.shot, []);
  const tree = withShot({ nodes: [], at: null }, bare, () => bare.balls);
  expect(withShot(tree, store.document.shot, () => bare.balls).nodes[1]?.parent).toBe(1);
});
