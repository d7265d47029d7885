import { describe, expect, test } from "vitest";
import { CaromError, load, type Strike } from "../../../src/engine/index.ts";
import { documentOf } from "../../../src/app/document/shot-file.ts";
import type { Context } from "../../../src/app/common/context.ts";
import { areasOf } from "../../../src/app/game/game-areas.ts";
import {
  type Game,
  type Move,
  newGame,
  type Setup,
} from "../../../src/app/document/stored-game.ts";
import {
  announceCall,
  intendedCall,
  presentCall,
  tapBall,
  tapPocket,
} from "../../../src/app/game/calling.ts";
import {
  choose,
  concede,
  endGame,
  playShot,
  startGame,
} from "../../../src/app/game/game-actions.ts";
import { askedShot, canAim, standing } from "../../../src/app/game/awaited-turn.ts";
import { progressOf } from "../../../src/app/game/game-progress.ts";
import { freePlace, handOf, referee } from "../../../src/app/game/referee.ts";
import { Store } from "../../../src/app/document/store.ts";

const engine = await load();

const said: string[] = [];
const context = { engine, announce: (text: string) => said.push(text) } as unknown as Context;

const SHOT = {
  format: "carom-shot/1",
  table: "wpa-9ft",
  balls: [{ id: "cue", position: [0.5, 0.6] }],
  strike: { ball: "cue", speed: 2, azimuth_deg: 80 },
} as const;

/** The 1 in front of the top left pocket, and the 2 elsewhere. */
const PAIR = {
  format: "carom-shot/1",
  table: "wpa-9ft",
  balls: [
    { id: "cue", position: [0.2, 1.2] },
    { id: "1", position: [0.17, 2.1] },
    { id: "2", position: [1, 0.5] },
  ],
  strike: { ball: "cue", speed: 2, azimuth_deg: 90 },
} as const;

function setup(rules: string, more: Partial<Setup> = {}): Setup {
  return {
    rules,
    options: { seed: 7 },
    from: null,
    names: ["Ann", "Bea"],
    skills: [null, null],
    ...more,
  };
}

function begun(rules: string, more: Partial<Setup> = {}): Store {
  const store = new Store(referee(engine), documentOf(SHOT));
  expect(startGame(store, context, setup(rules, more))).toBe(true);
  return store;
}

/** A soft shot away from every ball: a foul in every game in which a ball must be hit. */
function foul(store: Store): void {
  store.strike({ speed: 0.3, azimuth_deg: 180 }, "aim");
  shootOnce(store);
}

/** @returns The hash of the shot; null if it was refused. */
function shootOnce(store: Store): string | null {
  let hash: string | null = null;
  playShot(store, context, (trace) => (hash = trace.hash));
  return hash;
}

const refusal = (store: Store) => store.session.refusal?.message ?? "";
const request = (store: Store) => standing(store, engine)!.frame.state.request;

/** @returns Seeds of racks, to search for a break with a certain result. */
const seeds = () => Array.from({ length: 500 }, (_, seed) => seed);

/** @returns A game and a hard break from beside the middle of its head string. */
function breakOf(game: Game): { game: Game; scratch: Move } {
  const { balls } = progressOf(engine, game).frame.state;
  const [, apex] = Object.entries(balls)
    .filter(([id]) => id !== "cue")
    .sort(([, a], [, b]) => a[1] - b[1])[0]!;
  const place = [0.3, 0.6] as const;
  const azimuth = Math.atan2(apex[1] - place[1], apex[0] - place[0]);
  const strike = { speed: 9, azimuth, elevation: 0, side: 0, height: 0 };
  return { game, scratch: { play: { strike, cue_ball: place } } };
}

describe("a game", () => {
  test.each(engine.ruleSets)("of %s begins with a shot that can be aimed at", (rules) => {
    const store = begun(rules);
    expect(canAim(store, engine)).toBe(true);
    expect(store.document.shot.strike.ball).toBe(askedShot(store, engine)!.cue_ball);
    expect(store.ghost.trace).not.toBeNull();
  });

  test("plays the shot that is shown, to the bit, wherever it is aimed", () => {
    for (const azimuth of [10.1234, 77.7777, 181.003, 359.9]) {
      const store = begun("nine-ball");
      store.strike({ azimuth_deg: azimuth, side: 0.31, elevation_deg: 7.7 }, "aim");
      const shown = store.ghost.trace!.hash;
      expect(shootOnce(store)).toBe(shown);
    }
  });

  test("keeps the policies of the strike, also in its moves", () => {
    const store = begun("nine-ball");
    store.strike({ side: 0.55 }, "aim");
    expect(refusal(store)).toMatch(/miscue/);
    const { shot } = store.document;
    const strike = { ...shot.strike, side: 0.55, miscue: "report" } as const;
    expect(store.apply({ shot: { ...shot, strike } }, "aim")).toBe(true);
    expect(shootOnce(store)).not.toBeNull();
    const { game } = store.document;
    expect(game!.moves[0]).toMatchObject({ play: { strike: { miscue: "report" } } });
    const again = progressOf(engine, structuredClone(game!));
    expect(again.frame.state).toEqual(standing(store, engine)!.frame.state);
  });

  test("continues with the balls where they stop, and undo takes the shot back", () => {
    const store = begun("nine-ball");
    const before = store.document;
    shootOnce(store);
    const { frame, steps, trace } = standing(store, engine)!;
    expect(steps).toHaveLength(1);
    expect(store.undoLabel).toBe("Ann’s shot");
    const lying = Object.fromEntries(
      store.shot.balls.map(({ id, position: [x, y] }) => [id, [x, y]]),
    );
    expect(lying).toEqual(frame.state.balls);
    expect(trace!.shot.balls).toHaveLength(10);
    store.undo();
    expect(store.document).toBe(before);
    store.redo();
    // Redo does not simulate the move again.
    expect(standing(store, engine)!.trace).toBe(trace);
  });

  test("that is over refuses shots, and can be ended", () => {
    // The first rack whose usual break pockets the nine.
    const store = seeds()
      .map((seed) => begun("nine-ball", { options: { seed } }))
      .find((store) => shootOnce(store) !== null && request(store).kind === "over")!;
    expect(request(store)).toMatchObject({ kind: "over", winner: 0 });
    expect(canAim(store, engine)).toBe(false);
    expect(shootOnce(store)).toBeNull();
    expect(refusal(store)).toMatch(/No shot can be played now/);
    endGame(store);
    expect(store.document.game).toBeNull();
    expect(canAim(store, engine)).toBe(true);
  });

  test("replayed from its moves has the same state", () => {
    const store = begun("snooker");
    foul(store);
    choose(store, context, "play-on");
    shootOnce(store);
    const game = store.document.game!;
    const copy = JSON.parse(JSON.stringify(game)) as Game;
    const [a, b] = [progressOf(engine, game), progressOf(engine, copy)];
    expect(b).not.toBe(a);
    expect(b.frame.state).toEqual(a.frame.state);
    expect(b.steps).toEqual(a.steps);
    expect(b.trace!.hash).toBe(a.trace!.hash);
  });

  test("with the old choice after a scratch on the break of eight-ball has the same state", () => {
    // Before, the frame asked for a choice with the one option "play-from-hand" here.
    const { game, scratch } = seeds()
      .map((seed) => breakOf(newGame(setup("eight-ball", { options: { seed } }))))
      .find(({ game, scratch }) => {
        const { frame, steps } = progressOf(engine, { ...game, moves: [scratch] });
        const fouls = steps.at(-1)!.ruling.fouls.map((foul) => foul.what);
        return fouls.join() === "the cue ball was pocketed" && frame.state.request.kind === "shot";
      })!;
    const choice: Move = { choice: "play-from-hand" };
    const expected = progressOf(engine, { ...game, moves: [scratch] });
    expect(expected.frame.state.request).toMatchObject({ in_hand: "behind-head-string" });
    const old = progressOf(engine, { ...game, moves: [scratch, choice] });
    expect(old.frame.state).toEqual(expected.frame.state);
    expect(old.steps).toEqual(expected.steps);
    expect(() => progressOf(engine, { ...game, moves: [choice] })).toThrow(/^Move 1 of this game/);
  });

  test("with an invalid set-up or move is refused with its place", () => {
    expect(() => progressOf(engine, newGame(setup("croquet")))).toThrow(CaromError);
    const store = new Store(referee(engine), documentOf(SHOT));
    expect(startGame(store, context, setup("snooker", { options: { table: "carom-match" } }))).toBe(
      false,
    );
    expect(refusal(store)).toMatch(/^The table: this page does not know “carom-match”/);
    const moves = [{ choice: "rebreak" as const }];
    expect(() => progressOf(engine, { ...newGame(setup("nine-ball")), moves })).toThrow(
      /^Move 1 of this game: The answer: .*\(choice/,
    );
  });
});

describe("the referee", () => {
  test("allows only a cue ball in hand to be moved, and nothing to be added, removed or changed", () => {
    const store = begun("nine-ball");
    const { shot } = store.document;
    const [cue, one] = [shot.balls[0]!, shot.balls[1]!];
    const without = shot.balls.filter((ball) => ball !== one);
    const tries = [
      { ...shot, balls: [cue, { ...one, position: [0.3, 0.3] as const }, ...without.slice(1)] },
      { ...shot, balls: without },
      { ...shot, balls: [...shot.balls, { id: "x", position: [0.3, 1.0] as const }] },
      { ...shot, balls: [{ ...cue, mass: 0.2 }, ...shot.balls.slice(1)] },
      { ...shot, table: "wpa-8ft" },
      { ...shot, physics: "poolfiz" },
      { ...shot, strike: { ...shot.strike, ball: "1" } },
    ];
    const refused = tries.map((next) => {
      expect(store.apply({ shot: next }, "try")).toBe(false);
      expect(store.document.shot).toBe(shot);
      return refusal(store);
    });
    expect(refused.slice(0, 3).every((text) => text.includes("balls cannot be moved"))).toBe(true);
    expect(refused[4]).toMatch(/Table and physics cannot be changed/);
    expect(refused[6]).toMatch(/must strike the cue ball/);
  });

  test("keeps a cue ball in hand within its region and clear of other balls", () => {
    const store = begun("nine-ball");
    const put = (x: number, y: number) =>
      store.apply(({ shot }) => {
        const [cue, ...others] = shot.balls;
        return { shot: { ...shot, balls: [{ ...cue!, position: [x, y] }, ...others] } };
      }, "move");
    expect(put(0.3, 0.3)).toBe(true);
    expect(put(0.3, 0.7)).toBe(false);
    expect(refusal(store)).toMatch(/behind the head string/);
    shootOnce(store);
    foul(store);
    const hand = handOf(standing(store, engine)!);
    expect(hand).toBe("cue");
    expect(put(0.3, 1.9)).toBe(true);
    const other = store.shot.balls[1]!.position;
    expect(put(other[0], other[1])).toBe(false);
  });

  test("finds a free place for a cue ball that is off the table", () => {
    const store = begun("snooker");
    const progress = standing(store, engine)!;
    const place = freePlace(progress, "cue")!;
    expect(place).toEqual(store.document.shot.balls[0]!.position);
    expect(freePlace(progress, "blue")).not.toBeNull();
    expect(freePlace(standing(begun("three-cushion"), engine)!, "cue")).toBeNull();
  });
});

describe("calls", () => {
  test("are made by taps on a ball and a pocket, in any order", () => {
    const store = begun("straight-pool");
    const pocket = store.shot.geometry.pockets.find(({ name }) => name === "left")!;
    expect(tapPocket(store, engine, pocket.name)).toBe(true);
    expect(shootOnce(store)).toBeNull();
    expect(refusal(store)).toMatch(/No ball is called/);
    tapBall(store, engine, "cue");
    expect(store.document.game!.call).toEqual({ kind: "pocket", into: "left" });
    tapBall(store, engine, "4");
    expect(store.document.game!.call).toEqual({ kind: "pocket", ball: "4", into: "left" });
    expect(tapPocket(store, engine, null)).toBe(false);
    expect(shootOnce(store)).not.toBeNull();
    expect(store.document.game!.moves[0]).toMatchObject({
      play: { call: { kind: "pocket", ball: "4", into: "left" } },
    });
    // The next player starts without a call.
    expect(store.document.game!.call).toBeNull();
  });

  test("that the game does not request are not made by taps, and refused with the shot", () => {
    const store = begun("nine-ball");
    tapBall(store, engine, "4");
    expect(tapPocket(store, engine, store.shot.geometry.pockets[0]!.name)).toBe(false);
    expect(store.document.game!.call).toBeNull();
    announceCall(store, { kind: "push-out" });
    expect(shootOnce(store)).toBeNull();
    expect(refusal(store)).toMatch(/push-out is allowed only in the first shot/);
  });

  test("follow the aim where one is required: the first ball, and the pocket to which it is sent", () => {
    const { balls } = PAIR;
    const store = begun("straight-pool", { from: PAIR, guide: "short" });
    expect(balls).toHaveLength(3);
    store.strike({ azimuth_deg: 90, speed: 1.5 }, "aim");
    const call = { kind: "pocket", ball: "1", into: "top-left" };
    expect(presentCall(store, engine)).toEqual(call);
    // A soft shot that stops short gets the same call: the short guide tells no result.
    store.strike({ speed: 0.8 }, "aim");
    expect(store.ghost.trace!.outcome.pocketed).toEqual([]);
    expect(presentCall(store, engine)).toEqual(call);
    expect(shootOnce(store)).not.toBeNull();
    expect(store.document.game!.moves[0]).toMatchObject({ play: { call } });
  });

  test("of a locked pot are its ball and pocket, until the player calls another", () => {
    const store = begun("straight-pool", { from: PAIR });
    expect(store.aimAtPocket("1", "top-left", "aim")).toBe(true);
    const call = { kind: "pocket", ball: "1", into: "top-left" } as const;
    expect(presentCall(store, engine)).toEqual(call);
    announceCall(store, { kind: "safety" });
    expect(presentCall(store, engine)).toEqual({ kind: "safety" });
    announceCall(store, null);
    expect(presentCall(store, engine)?.kind).toBe("pocket");
  });

  test("do not follow the aim where none is required", () => {
    expect(presentCall(begun("nine-ball"), engine)).toBeNull();
    expect(intendedCall(begun("nine-ball"), engine)).toBeNull();
  });

  test("with the full guide are the ball that will fall", () => {
    const store = begun("straight-pool", { from: PAIR, guide: "full" });
    expect(store.aimAtPocket("1", "top-left", "aim")).toBe(true);
    store.setSession({ lock: null });
    const [drop] = store.ghost.trace!.outcome.pocketed;
    expect(presentCall(store, engine)).toEqual({ kind: "pocket", ball: drop![0], into: drop![1] });
  });
});

describe("a game that starts from the balls as they lie", () => {
  const LAST_TWO = {
    format: "carom-shot/1",
    table: "wpa-9ft",
    balls: [
      { id: "cue", position: [0.635, 1.4] },
      { id: "9", position: [0.95, 2.2] },
    ],
    strike: { ball: "cue", speed: 2.5, azimuth_deg: 70 },
  } as const;

  test("is lost by the player who concedes", () => {
    const store = begun("nine-ball", { from: LAST_TWO });
    expect(store.shot.balls.map(({ id }) => id)).toEqual(["cue", "9"]);
    expect(askedShot(store, engine)).toMatchObject({ player: 0, in_hand: null, on: ["9"] });
    concede(store, context);
    expect(request(store)).toMatchObject({ kind: "over", winner: 1 });
    expect(store.undoLabel).toBe("Ann concedes");
    concede(store, context);
    expect(store.document.game!.moves).toHaveLength(1);
  });

  test("has the pocketed balls too, for a new rack", () => {
    const store = begun("nine-ball", { from: LAST_TWO });
    expect(standing(store, engine)!.start.balls).toHaveLength(10);
    expect(store.document.shot.balls).toHaveLength(2);
  });

  test("is refused if the game has no such balls", () => {
    const store = new Store(referee(engine), documentOf(SHOT));
    expect(startGame(store, context, setup("nine-ball", { from: SHOT }))).toBe(false);
    expect(refusal(store)).not.toBe("");
  });
});

test("a choice must be one of those offered", () => {
  const store = begun("eight-ball");
  store.strike({ speed: 1 }, "a soft break");
  shootOnce(store);
  expect(request(store)).toMatchObject({ kind: "choice", player: 1 });
  expect(canAim(store, engine)).toBe(false);
  choose(store, context, "spot-eight");
  expect(refusal(store)).toMatch(/not among the choices/);
  choose(store, context, "rebreak");
  expect(request(store)).toMatchObject({ kind: "shot", player: 1, in_hand: "behind-head-string" });
  expect(store.undoLabel).toBe("Bea: rack again and break");
  expect(store.document.shot.strike.speed).toBe(8);
});

describe("errors of a player", () => {
  const strike = (store: Store): Strike => {
    shootOnce(store);
    const [move] = store.document.game!.moves;
    return (move as { play: { strike: Strike } }).play.strike;
  };

  test("change the strike of the player who has them, in the same way for the same seed", () => {
    const exact = strike(begun("nine-ball"));
    const erring = strike(begun("nine-ball", { skills: ["beginner", null] }));
    expect(erring).not.toEqual(exact);
    expect(strike(begun("nine-ball", { skills: ["beginner", null] }))).toEqual(erring);
    expect(strike(begun("nine-ball", { skills: [null, "beginner"] }))).toEqual(exact);
  });

  test("are the engine's variants", () => {
    const store = begun("nine-ball", { skills: ["club", null] });
    const { strikes } = store.shot.vary(engine.noisePresets.club!, 1, { seed: 7 });
    expect(Object.values(strike(store))).toEqual([...strikes]);
  });

  test("have the index of the move, so that every shot has its own", () => {
    const store = begun("nine-ball", { skills: ["club", "club"] });
    foul(store);
    const { strikes } = store.shot.vary(engine.noisePresets.club!, 1, { seed: 7, first: 1 });
    shootOnce(store);
    const last = store.document.game!.moves.at(-1) as { play: { strike: Strike } };
    expect(Object.values(last.play.strike)).toEqual([...strikes]);
  });

  test("contain the contacts that cling, which the move stores", () => {
    // No preset has cling, so the club player gets one.
    const club = { ...engine.noisePresets.club!, cling_probability: 0.5, cling_friction: 0.9 };
    const clinging = new Proxy(engine, {
      get: (target, key) =>
        key === "noisePresets"
          ? { ...engine.noisePresets, club }
          : (Reflect.get(target, key, target) as unknown),
    });
    const store = begun("nine-ball", { skills: ["club", null] });
    const variant = store.shot.variant(club, 0, { seed: 7 });
    playShot(store, { ...context, engine: clinging }, () => undefined);
    const { game } = store.document;
    const [move] = game!.moves;
    const cling = (move as { play: { cling: unknown } }).play.cling;
    expect(cling).toEqual(variant.file.cling);
    const { frame, trace } = standing(store, engine)!;
    expect(trace!.shot.file.cling).toEqual(cling);
    const again = progressOf(engine, structuredClone(game!));
    expect(again.frame.state).toEqual(frame.state);
    expect(again.trace!.hash).toBe(trace!.hash);
  });

  test("never make the shot unplayable: a miscue is moved back to the miscue limit", () => {
    let moved = 0;
    for (const seed of [1, 2, 3, 4, 5]) {
      const store = begun("nine-ball", { options: { seed }, skills: ["beginner", null] });
      store.strike({ side: 0.45, height: 0.1 }, "far out");
      const limit = 0.999 * store.shot.miscueLimit;
      expect(shootOnce(store), refusal(store)).not.toBeNull();
      const [move] = store.document.game!.moves;
      const { side, height } = (move as { play: { strike: Strike } }).play.strike;
      expect(Math.hypot(side, height)).toBeLessThanOrEqual(limit + 1e-15);
      if (Math.abs(Math.hypot(side, height) - limit) < 1e-12) moved++;
    }
    expect(moved).toBeGreaterThan(0);
  });
});

describe("on the cloth", () => {
  const areas = (store: Store) =>
    areasOf(store.document.game!.call, standing(store, engine)!, store.shot.geometry, 0.028);

  test("the region of the cue ball in hand is marked: a half disk for the D", () => {
    const [d] = areas(begun("snooker"));
    expect(d!.outline.length).toBeGreaterThan(20);
    expect(Math.max(...d!.outline.map(([, y]) => y))).toBeCloseTo(0.737, 9);
    const [kitchen] = areas(begun("eight-ball"));
    expect(kitchen!.outline).toEqual([
      [0, 0],
      [1.27, 0],
      [1.27, 0.635],
      [0, 0.635],
    ]);
  });

  test("rings mark the call and the balls on, if they are few", () => {
    const store = begun("straight-pool");
    expect(areas(store)).toHaveLength(1);
    announceCall(store, { kind: "pocket", ball: "4", into: "left" });
    expect(areas(store)).toHaveLength(3);
    // The region, and the ring around ball 1.
    expect(areas(begun("nine-ball"))).toHaveLength(2);
  });
});
