import { beforeEach, describe, expect, test, vi } from "vitest";
import { load, type Point } from "../../../src/engine/index.ts";
import type { Context } from "../../../src/app/common/context.ts";
import { DrawLoop } from "../../../src/app/common/draw-loop.ts";
import { toDegrees, toRadians } from "../../../src/app/common/angles.ts";
import { documentOf } from "../../../src/app/document/shot-file.ts";
import { Store } from "../../../src/app/document/store.ts";
import { cancel, end, hover, move, start } from "../../../src/app/input/gesture.ts";
import { GestureState, type Pointer } from "../../../src/app/input/gesture-state.ts";

const engine = await load();

const SHOT = {
  format: "carom-shot/1",
  table: "wpa-9ft",
  balls: [
    { id: "cue", position: [0.5, 0.6] },
    { id: "1", position: [0.6, 1.6] },
  ],
  strike: { ball: "cue", speed: 2, azimuth_deg: 40 },
} as const;

/** Pixels per metre of a picture whose origin is the origin of the table. */
const SCALE = 500;

/** Within this many pixels of a ball's centre the pointer is on it; a finger takes it from further away. */
const ON = 14;
const NEAR = 24;

let store: Store;
let state: GestureState;
let isOpen: boolean;

const viewer = {
  controls: true,
  pick(x: number, y: number, type?: string) {
    const point: Point = [x / SCALE, y / SCALE];
    const reach = type === "touch" ? NEAR : ON;
    const ball = store.shot.balls.findIndex(
      ({ position: [u, v] }) => Math.hypot(u * SCALE - x, v * SCALE - y) < reach,
    );
    return { ball: ball < 0 ? null : ball, point };
  },
  hit(x: number, y: number) {
    const { point } = viewer.pick(x, y);
    const pocket = store.shot.geometry.pockets.find(
      ({ center: [u, v] }) => Math.hypot(u - point[0], v - point[1]) < 0.08,
    );
    return { point, pocket: pocket?.name ?? null };
  },
  project: (x: number, y: number) => [x * SCALE, y * SCALE] as const,
  loupe: vi.fn(),
};

/** A pointer at a place of the table (m), moved by some pixels. */
function at([x, y]: readonly number[], more: Partial<Pointer> & { by?: Point } = {}): Pointer {
  const [dx, dy] = more.by ?? [0, 0];
  const place = { clientX: x! * SCALE + dx, clientY: y! * SCALE + dy };
  const rest = { pointerId: 1, pointerType: "mouse", button: 0, shiftKey: false };
  return { ...rest, ...place, ...more };
}

const strike = () => store.document.shot.strike;
const positionOf = (id: string) => store.shot.balls.find((ball) => ball.id === id)!.position;

beforeEach(() => {
  vi.stubGlobal("innerWidth", 1200);
  vi.stubGlobal("innerHeight", 1600);
  store = new Store(engine, documentOf(SHOT));
  isOpen = true;
  viewer.controls = true;
  viewer.loupe.mockClear();
  const loop = new DrawLoop(
    () => false,
    () => 0,
  );
  const context = { engine, viewer, loop, announce: vi.fn() } as unknown as Context;
  state = new GestureState(store, context, {
    dataset: {},
    setPointerCapture: vi.fn(),
    isOpen: () => isOpen,
  });
});

/** A press, moves, and the release at the last place. */
function drag(...places: Pointer[]): void {
  start(state, places[0]!);
  for (const place of places) move(state, place);
  end(state, places.at(-1)!);
}

describe("a tap", () => {
  test("on the cloth aims there, also if the pointer slips by two pixels", () => {
    drag(at([1, 0.6]), at([1, 0.6], { by: [2, 0] }));
    expect(strike().azimuth_deg).toBe(0);
  });

  test("on a ball selects it and aims at its centre", () => {
    drag(at([0.6, 1.6], { by: [3, 3] }));
    expect(store.session.selected).toBe("1");
    expect(strike().azimuth_deg).toBeCloseTo(84.2894, 3);
  });

  test("during a replay aims nowhere", () => {
    store.setSession({ mode: "replay" });
    drag(at([1, 0.6]));
    expect(strike().azimuth_deg).toBe(40);
  });
});

describe("a drag on the cloth", () => {
  test("turns the cue by as much as the pointer turns around the ball", () => {
    drag(at([1, 0.6]), at([0.5 + 0.5 * Math.cos(0.1), 0.6 + 0.5 * Math.sin(0.1)]));
    expect(strike().azimuth_deg).toBeCloseTo(40 + toDegrees(0.1), 3);
    expect(store.undo()).toBe(true);
    expect(strike().azimuth_deg).toBe(40);
  });

  test("turns it by a tenth with the shift key", () => {
    const shiftKey = true;
    drag(at([1, 0.6], { shiftKey }), at([0.5, 1.1], { shiftKey }));
    expect(strike().azimuth_deg).toBeCloseTo(49, 3);
  });

  test("is the viewer's with the free camera", () => {
    store.setView({ camera: "orbit" });
    start(state, at([1, 0.6]));
    expect(state.present?.kind).toBe("camera");
    expect(viewer.controls).toBe(true);
    move(state, at([1, 1]));
    end(state, at([1, 1]));
    expect(strike().azimuth_deg).toBe(40);
  });
});

describe("a drag of a ball", () => {
  test("moves it with the point at which it is held, as one step of the history", () => {
    const by: Point = [4, 0];
    start(state, at([0.6, 1.6], { by }));
    expect(viewer.controls).toBe(false);
    for (const y of [1.5, 1.4, 1.3]) move(state, at([0.6, y], { by }));
    expect(state.surface.dataset.drag).toBe("ball");
    end(state, at([0.6, 1.3], { by }));
    expect(positionOf("1")[1]).toBeCloseTo(1.3, 3);
    expect(positionOf("1")[0]).toBeCloseTo(0.6, 3);
    expect(state.surface.dataset.drag).toBeUndefined();
    store.undo();
    expect(positionOf("1")[1]).toBe(1.6);
  });

  test("puts it away where the page covers the table", () => {
    start(state, at([0.6, 1.6]));
    isOpen = false;
    move(state, at([0.6, 1.2]));
    expect(state.surface.dataset.away).toBe("");
    end(state, at([0.6, 1.2]));
    expect(store.shot.balls.map(({ id }) => id)).toEqual(["cue"]);
  });

  test("needs a finger that is on the ball: beside it the cue turns", () => {
    const pointerType = "touch";
    start(state, at([0.6, 1.6], { pointerType, by: [20, 0] }));
    expect(state.present).toMatchObject({ kind: "cue", ball: 1 });
    cancel(state);
    start(state, at([0.6, 1.6], { pointerType, pointerId: 2, by: [5, 0] }));
    expect(state.down.size).toBe(2);
    expect(state.present).toBeNull();
  });
});

describe("a pull of the cue", () => {
  const azimuth = toRadians(40);
  const behind = (away: number) => [0.5 - away * Math.cos(azimuth), 0.6 - away * Math.sin(azimuth)];

  test("sets the speed, and gives it back where the stroke is cancelled", () => {
    hover(state, at(behind(0.3)));
    expect(state.surface.dataset.over).toBe("cue");
    start(state, at(behind(0.3)));
    expect(state.present?.kind).toBe("stroke");
    move(state, at(behind(0.5)));
    expect(strike().speed).not.toBe(2);
    cancel(state);
    expect(strike().speed).toBe(2);
    expect(viewer.controls).toBe(true);
  });
});

test("a second finger cancels the gesture", () => {
  start(state, at([1, 0.6], { pointerType: "touch" }));
  start(state, at([1, 1], { pointerType: "touch", pointerId: 2 }));
  expect(state.present).toBeNull();
  move(state, at([0.5, 1.1]));
  expect(strike().azimuth_deg).toBe(40);
});

test("a pointer that did not start the gesture neither moves nor ends it", () => {
  start(state, at([1, 0.6]));
  move(state, at([0.5, 1.1], { pointerId: 7 }));
  end(state, at([0.5, 1.1], { pointerId: 7 }));
  expect(state.present?.kind).toBe("cue");
  expect(strike().azimuth_deg).toBe(40);
});
