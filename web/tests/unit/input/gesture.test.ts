import { beforeEach, describe, expect, test, vi } from "vitest";
import { load, type Point } from "../../../src/engine/index.ts";
import type { Context } from "../../../src/app/common/context.ts";
import { DrawLoop } from "../../../src/app/common/draw-loop.ts";
import { toDegrees, toRadians } from "../../../src/app/common/angles.ts";
import { documentOf } from "../../../src/app/document/shot-file.ts";
import { Store } from "../../../src/app/document/store.ts";
import { AimCloseUp } from "../../../src/app/input/aim-close-up.ts";
import { cancel, end, hover, move, start } from "../../../src/app/input/gesture.ts";
import { GestureState, type Pointer } from "../../../src/app/input/gesture-state.ts";

interface Spot {
  readonly x: number;
  readonly y: number;
}

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

/** The part of the window in which the table is seen. */
const PICTURE = { left: 0, top: 0, right: 700, bottom: 1400 };

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
  const rest = { pointerId: 1, pointerType: "mouse", button: 0, shiftKey: false, timeStamp: 0 };
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
  const surface = { dataset: {}, setPointerCapture: vi.fn(), isOpen: () => isOpen };
  const closeUp = new AimCloseUp(store, context, () => PICTURE);
  state = new GestureState(store, context, surface, closeUp);
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

describe("a finger that turns the cue", () => {
  const pointerType = "touch";

  /** The most that the cue turns when a slow drag leaves the reach of a tap, three pixels; degrees. */
  const FIRST_STEP = 0.125;

  /** A drag from a place by steps of some pixels to the right, each after some milliseconds. */
  function slide(from: readonly number[], steps: number, by: number, every: number): void {
    start(state, at(from, { pointerType }));
    for (let k = 1; k <= steps; k += 1) {
      move(state, at(from, { pointerType, by: [k * by, 0], timeStamp: k * every }));
    }
    end(state, at(from, { pointerType, by: [steps * by, 0], timeStamp: steps * every + 10 }));
  }

  /** Steps of the azimuth while a gesture is made, degrees. */
  function stepsOf(gesture: () => void): number[] {
    const seen = [strike().azimuth_deg!];
    const end = store.subscribe(({ document }) => seen.push(document.shot.strike.azimuth_deg!));
    gesture();
    end();
    return seen.slice(1).map((azimuth, k) => Math.abs(azimuth - seen[k]!));
  }

  test("slowly turns it by a twentieth of a degree per pixel at the most, and never by a jump", () => {
    // Seen: a drag of nine pixels turned the cue by six degrees.
    const steps = stepsOf(() => slide([0.5, 0.9], 9, 1, 40));
    expect(Math.max(...steps)).toBeLessThan(FIRST_STEP);
    expect(strike().azimuth_deg).toBeLessThan(40);
    expect(strike().azimuth_deg).toBeGreaterThan(39.5);
  });

  test("slowly turns it as finely beside the cue ball", () => {
    expect(Math.max(...stepsOf(() => slide([0.5, 0.64], 9, 1, 40)))).toBeLessThan(FIRST_STEP);
  });

  test("fast turns it widely, and finely again after it was slow for a while", () => {
    const from = [0.5, 0.9];
    start(state, at(from, { pointerType }));
    for (let k = 1; k <= 10; k += 1) {
      move(state, at(from, { pointerType, by: [10 * k, 0], timeStamp: 16 * k }));
    }
    const wide = strike().azimuth_deg!;
    expect(40 - wide).toBeGreaterThan(15);
    const steps = stepsOf(() => {
      for (let k = 1; k <= 20; k += 1) {
        const by: Point = [100 + k, 0];
        move(state, at(from, { pointerType, by, timeStamp: 600 + 40 * k }));
      }
    });
    expect(Math.max(...steps)).toBeLessThan(0.05);
    end(state, at(from, { pointerType, by: [120, 0], timeStamp: 1500 }));
    expect(store.undo()).toBe(true);
    expect(strike().azimuth_deg).toBe(40);
  });

  test("leaves a pot finely, from its middle", () => {
    store.aimAtPocket("1", "top-right", "pot");
    const middle = strike().azimuth_deg!;
    slide([0.5, 0.9], 5, 1, 40);
    expect(strike().azimuth_deg, "within the pot").toBe(middle);
    expect(store.session.lock?.solved).toBe(true);
    const steps = stepsOf(() => slide([0.5, 0.9], 20, 1, 40));
    expect(strike().azimuth_deg).not.toBe(middle);
    expect(store.session.lock).toBeNull();
    expect(Math.max(...steps)).toBeLessThan(0.05);
  });

  test("sees a close-up of the contact, away from the finger, until it is lifted", () => {
    store.strike({ azimuth_deg: 84 }, "aim");
    const from = [0.9, 1];
    start(state, at(from, { pointerType }));
    expect(viewer.loupe).not.toHaveBeenCalled();
    move(state, at(from, { pointerType, by: [4, 0], timeStamp: 100 }));
    const [point, { at: disc, zoom }] = viewer.loupe.mock.lastCall as [
      Spot,
      { at: Spot; zoom: number },
    ];
    // Between the ghost ball and the ball 1.
    expect(Math.hypot(point.x - 0.6 * SCALE, point.y - 1.6 * SCALE)).toBeLessThan(0.06 * SCALE);
    expect(Math.hypot(disc.x - 0.9 * SCALE, disc.y - 1 * SCALE)).toBeGreaterThan(100);
    expect(zoom).toBeCloseTo(2.03, 2);
    end(state, at(from, { pointerType, by: [4, 0], timeStamp: 120 }));
    expect(viewer.loupe).toHaveBeenLastCalledWith(null);
  });

  test("sees none where the cue ball meets no ball, and a mouse sees none", () => {
    slide([0.5, 0.2], 6, 1, 40);
    drag(at([1, 0.6]), at([1, 0.9]));
    expect(viewer.loupe).not.toHaveBeenCalled();
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
