import { afterEach, beforeEach, describe, expect, test, vi } from "vitest";
import type { Decision, FrameRecord, PlayerOptions } from "../../../src/engine/index.ts";
import type { Store } from "../../../src/app/document/store.ts";
import { lastByMachine, reasonOf } from "../../../src/app/game/machine/reason.ts";
import { reasonInWords } from "../../../src/app/game/machine/machine-explanation.ts";
import { LEVELS, machineNoise } from "../../../src/app/game/machine/machine-levels.ts";
import { type Decider, READING, Turns } from "../../../src/app/game/machine/machine-turns.ts";
import { canConcede, playDecision, playShot } from "../../../src/app/game/game-actions.ts";
import { canAim, standing } from "../../../src/app/game/awaited-turn.ts";
import { progressOf } from "../../../src/app/game/game-progress.ts";
import { begun, context, engine } from "./games.ts";

/** A thinker on the calling thread. */
class Here implements Decider {
  readonly decisions: Decision[] = [];
  stopped = 0;
  choose(record: FrameRecord, options: PlayerOptions): Promise<Decision> {
    const [player, frame] = [engine.player(options), engine.replay(record)];
    const decision = player.choose(frame);
    player.free();
    frame.free();
    this.decisions.push(decision);
    return Promise.resolve(decision);
  }
  explain = (record: FrameRecord, options: PlayerOptions & { count?: number }) => {
    const { count, ...player } = options;
    const frame = engine.replay(record);
    return Promise.resolve(engine.player(player).explain(frame, { count: count! }));
  };
  stop(): void {
    this.stopped += 1;
  }
}

interface Machine {
  readonly thinker: Here;
  readonly turns: Turns;
}

/**
 * @param most Moves after which the machine answers no more.
 * @param reading For how long a ruling is shown, ms.
 */
function machineIn(store: Store, most = Infinity, reading = 0): Machine {
  const thinker = new Here();
  const listener = {
    play: (decision: Decision) => {
      if (store.document.game!.moves.length >= most) return;
      playDecision(store, context, decision, () => undefined);
    },
    changed: () => undefined,
  };
  const turns = new Turns(store, engine, () => Promise.resolve(thinker), listener, reading);
  turns.consider();
  return { thinker, turns };
}

const rest = () => new Promise((resolve) => setTimeout(resolve, 0));
const made = (store: Store) => store.document.game!.moves.length;

async function until(condition: () => boolean): Promise<void> {
  for (let k = 0; k < 500 && !condition(); k += 1) await rest();
  expect(condition()).toBe(true);
}

const TWO = { machines: ["level-1", "level-1"] } as const;
const SECOND = { machines: [null, "level-2"] } as const;

describe("a machine", () => {
  test.each(engine.ruleSets)("plays %s, and its moves replay to the same state", async (rules) => {
    const store = begun(rules, TWO);
    machineIn(store, 8);
    const over = () => standing(store, engine)!.frame.state.request.kind === "over";
    await until(() => made(store) === 8 || over());
    expect(store.session.refusal).toBeNull();
    const game = structuredClone(store.document.game!);
    const again = progressOf(engine, game);
    expect(again.frame.state).toEqual(standing(store, engine)!.frame.state);
  });

  test("has five levels, each with smaller errors than the one below", () => {
    const errors = LEVELS.map((level) => machineNoise(engine, level).azimuth);
    expect(errors).toHaveLength(5);
    expect([...errors].sort((a, b) => b - a)).toEqual(errors);
    for (const level of LEVELS) expect(engine.players).toContain(level);
  });

  test("executes its shot with the errors of its level, the same ones each time", async () => {
    const play = async () => {
      const store = begun("nine-ball", { machines: ["level-1", null] });
      const { thinker } = machineIn(store);
      await until(() => made(store) > 0);
      const [move] = store.document.game!.moves;
      const strike = move && "play" in move ? move.play.strike : null;
      return { strike, meant: thinker.decisions[0]!.play!.strike };
    };
    const { strike, meant } = await play();
    expect(strike!.azimuth).not.toBe(meant.azimuth);
    expect(Math.abs(strike!.azimuth! - meant.azimuth)).toBeLessThan(0.03);
    expect((await play()).strike).toEqual(strike);
  });

  test("lets no person aim, shoot or concede for it", () => {
    const store = begun("nine-ball", { machines: ["level-3", null] });
    expect(canAim(store, engine)).toBe(false);
    expect(canConcede(store, engine)).toBe(false);
    playShot(store, context, () => undefined);
    expect(made(store)).toBe(0);
    expect(store.session.refusal?.message).toMatch(/No shot can be played now/);
  });

  test("waits for the end of a replay", async () => {
    const store = begun("nine-ball", SECOND);
    machineIn(store);
    store.strike({ speed: 0.3, azimuth_deg: 180 }, "aim");
    playShot(store, context, (trace) =>
      store.setSession({ mode: "replay", replay: { ...store.session.replay, trace } }),
    );
    for (let k = 0; k < 20; k += 1) await rest();
    expect(made(store)).toBe(1);
    store.setSession({ mode: "aim", replay: { ...store.session.replay, trace: null } });
    await until(() => made(store) > 1);
  });

  describe("after a ruling", () => {
    // Seen: a foul of one's own was never shown, because the machine played in the same moment.
    beforeEach(() => {
      vi.useFakeTimers();
    });
    afterEach(() => {
      vi.useRealTimers();
    });
    const soft = { speed: 0.3, azimuth_deg: 180 };
    const pass = (ms: number) => vi.advanceTimersByTimeAsync(ms);

    test("that tells a foul it waits for as long as two sentences take to read", async () => {
      const store = begun("nine-ball", SECOND);
      machineIn(store, Infinity, READING);
      store.strike(soft, "aim");
      playShot(store, context, (trace) =>
        store.setSession({ mode: "replay", replay: { ...store.session.replay, trace } }),
      );
      await pass(10 * READING);
      expect(made(store)).toBe(1);
      store.setSession({ mode: "aim", replay: { ...store.session.replay, trace: null } });
      await pass(1500);
      expect(made(store)).toBe(1);
      await pass(READING - 1500);
      expect(made(store)).toBe(2);
    });

    test("that tells a foul it plays at once when the user taps", async () => {
      const store = begun("nine-ball", SECOND);
      const { turns } = machineIn(store, Infinity, READING);
      store.strike(soft, "aim");
      playShot(store, context, () => undefined);
      await pass(100);
      expect([made(store), turns.waiting]).toEqual([1, "reading"]);
      turns.readOn();
      expect(made(store)).toBe(2);
    });

    test("that tells its own choice it waits too", async () => {
      const store = begun("snooker", SECOND);
      const { thinker } = machineIn(store, Infinity, READING);
      const choose = thinker.choose.bind(thinker);
      thinker.choose = (record, options) =>
        made(store) === 1
          ? Promise.resolve({ play: null, choice: "play-on" } as Decision)
          : choose(record, options);
      store.strike(soft, "aim");
      playShot(store, context, () => undefined);
      await pass(READING);
      expect(made(store)).toBe(2);
      await pass(1500);
      expect(made(store)).toBe(2);
      await pass(READING - 1500);
      expect(made(store)).toBe(3);
    });

    test("that the shot was legal it does not wait", async () => {
      const store = begun("eight-ball", { ...SECOND, options: { seed: 1 } });
      machineIn(store, 2, READING);
      playShot(store, context, () => undefined);
      const [step] = standing(store, engine)!.steps;
      expect([step!.ruling.legal, step!.after.request]).toMatchObject([true, { player: 1 }]);
      await pass(1);
      expect(made(store)).toBe(2);
    });
  });

  test("does not repeat what was taken back until the user lets it play", async () => {
    const store = begun("nine-ball", SECOND);
    const { turns } = machineIn(store);
    store.strike({ speed: 0.3, azimuth_deg: 180 }, "aim");
    playShot(store, context, () => undefined);
    await until(() => made(store) > 1 && turns.waiting === null);
    while (made(store) > 1) store.undo();
    expect(turns.waiting).toBe("held");
    for (let k = 0; k < 20; k += 1) await rest();
    expect(made(store)).toBe(1);
    turns.resume();
    await until(() => made(store) > 1);
  });

  test("is asked to end its search by Stop, and when its move is taken back", async () => {
    const store = begun("nine-ball", SECOND);
    let stopped = 0;
    const decider: Decider = {
      choose: () => new Promise<Decision>(() => undefined),
      stop: () => {
        stopped += 1;
      },
    };
    const turns = new Turns(store, engine, () => Promise.resolve(decider), {
      play: () => undefined,
      changed: () => undefined,
    });
    store.strike({ speed: 0.3, azimuth_deg: 180 }, "aim");
    playShot(store, context, () => undefined);
    await rest();
    expect(turns.waiting).toBe("thinking");
    turns.stop();
    await rest();
    expect(stopped).toBe(1);
    store.undo();
    await rest();
    expect(stopped).toBe(2);
    expect(turns.waiting).toBeNull();
  });

  test("explains each of its shots by the play that it executed", async () => {
    const store = begun("eight-ball", { machines: ["level-2", "level-3"] });
    const { thinker } = machineIn(store, 10);
    await until(() => made(store) === 10);
    const game = store.document.game!;
    const progress = progressOf(engine, game);
    let explained = 0;
    for (const [index, { move }] of progress.steps.entries()) {
      if (!("play" in move)) continue;
      const reason = (await reasonOf(engine, game, progress, index, thinker))!;
      const words = reasonInWords(reason);
      expect(words).toMatch(/win the frame: \d+ %/);
      if (!reason.meant) continue;
      expect(reason.meant.play.call).toEqual(move.play.call);
      expect(words).toMatch(/^Meant: /);
      // Seen: "the next best" with a better chance than the shot itself.
      const isBetter = (reason.instead?.win_chance ?? 0) > reason.meant.win_chance;
      expect(words.includes("The analysis prefers:")).toBe(isBetter);
      explained += 1;
    }
    expect(explained).toBeGreaterThan(5);
    expect(lastByMachine(game, progress)).toBe(
      progress.steps.findLastIndex(({ move }) => "play" in move),
    );
  });
});
