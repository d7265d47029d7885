import { describe, expect, test, vi } from "vitest";
import { CaromError, load, type Engine } from "../../../src/engine/index.ts";
import { documentOf } from "../../../src/app/document/shot-file.ts";
import {
  type FoundPot,
  type PotQuestion,
  type PotSolver,
  Store,
} from "../../../src/app/document/store.ts";
import { makeElevationAutomatic } from "../../../src/app/document/strike-changes.ts";

const engine: Engine = await load();

const SHOT = {
  format: "carom-shot/1",
  table: "wpa-9ft",
  balls: [
    { id: "cue", position: [0.5, 0.6] },
    { id: "1", position: [0.6, 1.6] },
  ],
  strike: { ball: "cue", speed: 2, azimuth_deg: 80 },
} as const;

const fresh = () => new Store(engine, documentOf(SHOT));
const azimuth = (store: Store) => store.document.shot.strike.azimuth_deg;

describe("history", () => {
  test("undo and redo go through all changes", () => {
    const store = fresh();
    for (let k = 1; k <= 500; k += 1) store.strike({ azimuth_deg: k / 10 }, "aim");
    for (let k = 0; k < 500; k += 1) expect(store.undo()).toBe(true);
    expect(azimuth(store)).toBe(80);
    expect(store.undo()).toBe(false);
    for (let k = 0; k < 500; k += 1) expect(store.redo()).toBe(true);
    expect(azimuth(store)).toBe(50);
    expect(store.redo()).toBe(false);
  });

  test("the changes of a gesture are one step", () => {
    const store = fresh();
    for (const a of [10, 11, 12]) store.strike({ azimuth_deg: a }, "aim", "drag");
    store.settle();
    for (const a of [20, 21]) store.strike({ azimuth_deg: a }, "aim", "drag");
    store.undo();
    expect(azimuth(store)).toBe(12);
    store.undo();
    expect(azimuth(store)).toBe(80);
  });

  test("a new change after undo clears redo", () => {
    const store = fresh();
    store.strike({ azimuth_deg: 1 }, "aim");
    store.undo();
    store.strike({ speed: 3 }, "change the speed");
    expect(store.redoLabel).toBeNull();
    expect(store.undoLabel).toBe("change the speed");
  });

  test("undo does not change the view", () => {
    const store = fresh();
    store.strike({ azimuth_deg: 1 }, "aim");
    store.setView({ units: "mph" });
    store.undo();
    expect(store.view.units).toBe("mph");
  });
});

describe("refusals", () => {
  test("a refused change leaves document, history and ghost as they were, and gives the reason", () => {
    const store = fresh();
    store.strike({ azimuth_deg: 70 }, "aim");
    const before = store.document;
    const hash = store.ghost.trace!.hash;
    const { shot } = before;
    const balls = [shot.balls[0]!, { id: "1", position: [0.51, 0.6] as const }];
    expect(store.apply({ shot: { ...shot, balls } }, "move")).toBe(false);
    expect(store.document).toBe(before);
    expect(store.undoLabel).toBe("aim");
    expect(store.ghost.trace!.hash).toBe(hash);
    expect(store.session.refusal).toMatchObject({ place: "balls[1].position" });
    expect(store.session.refusal?.shot?.balls[1]?.position).toEqual([0.51, 0.6]);
  });

  test("the end of a gesture drops the refused shot, the next change drops its reason", () => {
    const store = fresh();
    expect(store.strike({ side: 0.7 }, "move the tip", "face")).toBe(false);
    expect(store.session.refusal?.shot?.strike.side).toBe(0.7);
    store.settle();
    expect(store.session.refusal).toMatchObject({ shot: null });
    expect(store.session.refusal?.message).toContain("miscue");
    store.strike({ side: 0.3 }, "move the tip");
    expect(store.session.refusal).toBeNull();
  });

  test("an internal error is thrown, not shown as a refusal", () => {
    const compiler = { shot: vi.fn(engine.shot.bind(engine)) };
    const store = new Store(compiler, documentOf(SHOT));
    compiler.shot.mockImplementationOnce(() => {
      throw new TypeError("ours");
    });
    expect(() => store.apply({ shot: { ...store.document.shot, table: "wpa-8ft" } }, "x")).toThrow(
      TypeError,
    );
    expect(() => new Store(engine, documentOf({ ...SHOT, table: "none" }))).toThrow(CaromError);
  });
});

describe("simulation", () => {
  test("the ghost equals the engine's simulation of the document's file", () => {
    const store = fresh();
    for (const patch of [
      { azimuth_deg: 81.1234 },
      { speed: 3.3 },
      { elevation_deg: 33.3, side: 0.2 },
    ]) {
      store.strike(patch, "try");
      expect(store.ghost.trace!.hash).toBe(engine.shot(store.document.shot).simulate().hash);
    }
    store.undo();
    expect(store.ghost.trace!.hash).toBe(engine.shot(store.document.shot).simulate().hash);
  });

  test("an automatic elevation follows the aim, and what is saved has the angle", () => {
    const near = { ...SHOT, balls: [{ id: "cue", position: [0.5, 0.06] }, SHOT.balls[1]] } as const;
    const store = new Store(engine, documentOf(near));
    const used = () => (store.shot.strike!.elevation * 180) / Math.PI;
    expect(used()).toBeGreaterThan(10);
    store.strike({ azimuth_deg: 0 }, "aim");
    expect(used()).toBeCloseTo(3, 12);
    expect(store.document.shot.strike.elevation_deg).toBeUndefined();
    expect(store.shot.file.strike!.elevation_deg).toBeCloseTo(3, 12);
    store.strike({ elevation_deg: 0 }, "lower the cue");
    expect(used()).toBe(0);
    makeElevationAutomatic(store);
    expect(used()).toBeCloseTo(3, 12);
    store.undo();
    expect(used()).toBe(0);
  });

  test("a change of the strike does not read the file again, and the ghost is simulated once", () => {
    const compiler = { shot: vi.fn(engine.shot.bind(engine)) };
    const store = new Store(compiler, documentOf(SHOT));
    for (let a = 0; a < 50; a += 1) store.strike({ azimuth_deg: a }, "aim", "drag");
    expect(compiler.shot).toHaveBeenCalledTimes(1);
    expect(store.ghost).toBe(store.ghost);
  });

  test("the replayed trace stays valid after the change that ends its replay", () => {
    const store = fresh();
    const { trace } = store.ghost;
    store.setSession({ mode: "replay", replay: { ...store.session.replay, trace } });
    store.strike({ azimuth_deg: 12 }, "aim");
    expect(store.session).toMatchObject({ mode: "aim", replay: { trace: null } });
    expect(trace!.hash).toMatch(/^[0-9a-f]{16}$/);
  });
});

test("listeners receive every change once, with the previous state", () => {
  const store = fresh();
  const received: [number, number][] = [];
  const stop = store.subscribe((now, before) => {
    received.push([
      now.document.shot.strike.azimuth_deg!,
      before.document.shot.strike.azimuth_deg!,
    ]);
  });
  store.strike({ azimuth_deg: 1 }, "aim");
  store.setView({ theme: "dark" });
  stop();
  store.strike({ azimuth_deg: 2 }, "aim");
  expect(received).toEqual([
    [1, 80],
    [1, 1],
  ]);
});

describe("a pot whose line a change has lost", () => {
  type Ask = Parameters<PotSolver>;

  /** A page whose solver waits, and a locked pot that a soft stroke and then a firm one have lost. */
  function lost() {
    const asked: Ask[] = [];
    const store = fresh();
    store.solvePotsWith((...ask) => asked.push(ask));
    expect(store.aimAtPocket("1", "top-right", "pot")).toBe(true);
    store.strike({ speed: 0.2 }, "soft", "drag");
    store.settle();
    store.strike({ speed: 3, side: 0.5 }, "firm", "power");
    expect(store.session.lock!.solved).toBe(false);
    return { store, asked };
  }
  const answerOf = ({ shot, ball, pockets }: PotQuestion): FoundPot => {
    const aim = engine.shot(shot).potAim(ball, pockets[0]!)!;
    return { pocket: pockets[0]!, aim };
  };

  test("is aimed again when the solver has found a line, in the same step of the history", () => {
    const { store, asked } = lost();
    const [question, answer] = asked.at(-1)!;
    expect(question.pockets).toEqual(["top-right"]);
    answer(answerOf(question));
    expect(store.session.lock!.solved).toBe(true);
    expect(store.ghost.trace!.outcome.pocketed).toContainEqual(["1", "top-right"]);
    store.strike({ speed: 3.1 }, "firm", "power");
    store.undo();
    expect(store.document.shot.strike.speed).toBe(0.2);
  });

  test("stays as it is if the answer comes too late, or there is no line", () => {
    const { store, asked } = lost();
    const [question, answer] = asked.at(-1)!;
    answer(null);
    expect(store.session.lock!.solved).toBe(false);
    store.strike({ azimuth_deg: 12 }, "aim");
    const before = store.document;
    answer(answerOf(question));
    expect(store.document).toBe(before);
    expect(store.session.lock).toBeNull();
  });
});
