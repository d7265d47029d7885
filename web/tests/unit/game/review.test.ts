import { describe, expect, test } from "vitest";
import type { Decision, FrameRecord, PlayerOptions } from "../../../src/engine/index.ts";
import type { Store } from "../../../src/app/document/store.ts";
import { concede, playDecision, playShot } from "../../../src/app/game/game-actions.ts";
import { type Cost, costsOf, gradeOf, worstOf } from "../../../src/app/game/review/shot-costs.ts";
import { neighbour, replayedMove, traceOf } from "../../../src/app/game/review/reviewed-shots.ts";
import { standing } from "../../../src/app/game/awaited-turn.ts";
import { begun, context, engine } from "./games.ts";

/** Plays a shot. @returns The hash of its trace. */
function shoot(store: Store, azimuth_deg: number, speed: number): string {
  let hash = "";
  store.strike({ azimuth_deg, speed }, "aim");
  playShot(store, context, (trace) => (hash = trace.hash));
  return hash;
}

describe("the shots of a game", () => {
  test("are replayed to the bit, and the game stays as it is", () => {
    const store = begun("nine-ball");
    const hashes = [shoot(store, 90, 8), shoot(store, 30, 3), shoot(store, 200, 4)];
    const progress = standing(store, engine)!;
    const { game } = store.document;
    expect(hashes.map((_, index) => traceOf(progress, index)!.hash)).toEqual(hashes);
    expect(traceOf(progress, 0)).toBe(traceOf(progress, 0));
    expect(store.document.game).toBe(game);
  });

  test("have neighbours that are shots too", () => {
    const store = begun("nine-ball");
    shoot(store, 90, 8);
    shoot(store, 30, 3);
    concede(store, context);
    const progress = standing(store, engine)!;
    expect(neighbour(progress, 0, 1)).toBe(1);
    expect(neighbour(progress, 1, 1)).toBeNull();
    expect(neighbour(progress, 0, -1)).toBeNull();
    store.setSession({
      mode: "replay",
      replay: { ...store.session.replay, trace: traceOf(progress, 0) },
    });
    expect(replayedMove(store, engine)).toBe(0);
    store.setPart("replay", { trace: progress.trace });
    expect(replayedMove(store, engine)).toBe(1);
  });
});

describe("the costs of shots", () => {
  /** A player on the calling thread. */
  const thinker = {
    choose: (record: FrameRecord, options: PlayerOptions): Promise<Decision> => {
      const [player, frame] = [engine.player(options), engine.replay(record)];
      const decision = player.choose(frame);
      player.free();
      frame.free();
      return Promise.resolve(decision);
    },
  };

  /** Nine-ball with a nine in front of a pocket: the player at the table wins. */
  const HANGING = {
    format: "carom-shot/1",
    table: "wpa-9ft",
    balls: [
      { id: "cue", position: [0.635, 1.9] },
      { id: "9", position: [1.2, 2.47] },
    ],
    strike: { ball: "cue", speed: 2, azimuth_deg: 45 },
  } as const;

  test("a foul beside a hanging nine costs the person nearly the frame, and the machine nothing", async () => {
    const store = begun("nine-ball", { from: HANGING, machines: [null, "level-5"] });
    shoot(store, 180, 0.5);
    const [game, progress] = [store.document.game!, standing(store, engine)!];
    const done: number[] = [];
    const costs = await costsOf(engine, game, progress, thinker, (made) => done.push(made) > 0);
    expect(costs).toHaveLength(1);
    const [{ index, player, before, after }] = costs as [(typeof costs & object)[number]];
    expect([index, player]).toEqual([0, 0]);
    expect(before).toBeGreaterThan(0.8);
    expect(after).toBeLessThan(0.2);
    expect(done).toEqual([0, 1]);
  });

  test("are listed for the three worst shots, without those that cost nearly nothing", () => {
    const costs = [0.04, 0.5, 0.3, 0.035, 0.02].map((loss) => ({ before: 0.6, after: 0.6 - loss }));
    const [small, great, large, other] = costs;
    expect(worstOf(costs as Cost[])).toEqual([great, large, small]);
    expect(worstOf(costs.slice(3) as Cost[])).toEqual([other]);
    const machines = costs.map((cost) => ({ ...cost, byMachine: true }));
    expect(worstOf(machines as Cost[])).toEqual([]);
  });

  test("are marked by what they cost", () => {
    const grades = [0, 0.02, 0.05, 0.2].map((loss) => gradeOf({ before: 0.6, after: 0.6 - loss }));
    expect(grades).toEqual(["good", "good", "slip", "mistake"]);
  });

  test("have the shots of a machine too, which are not among the costliest", async () => {
    const store = begun("nine-ball", { from: HANGING, machines: ["level-5", null] });
    const options = { simulations: 100, seed: 1 };
    const made = await thinker.choose(standing(store, engine)!.frame.record, options);
    playDecision(store, context, made, () => undefined);
    const [game, progress] = [store.document.game!, standing(store, engine)!];
    const costs = (await costsOf(engine, game, progress, thinker, () => true))!;
    expect(costs).toHaveLength(1);
    expect(costs[0]).toMatchObject({ index: 0, player: 0, byMachine: true });
    expect(worstOf(costs)).toEqual([]);
  });

  test("the shot that wins costs nothing", async () => {
    const store = begun("nine-ball", { from: HANGING });
    expect(store.aimAtPocket("9", "top-right", "aim")).toBe(true);
    // The first speed at which the nine falls and the cue ball stays.
    const clean = [1, 1.4, 1.8, 2.2, 2.6, 3].find((speed) => {
      store.strike({ speed, height: -0.4 }, "aim");
      const { pocketed } = store.ghost.trace!.outcome;
      return pocketed.length === 1 && pocketed[0]![0] === "9";
    });
    expect(clean).toBeDefined();
    playShot(store, context, () => undefined);
    const progress = standing(store, engine)!;
    expect(progress.frame.state.request).toMatchObject({ kind: "over", winner: 0 });
    const [cost] = (await costsOf(engine, store.document.game!, progress, thinker, () => true))!;
    expect(cost!.after).toBe(1);
  });

  test("are not counted to the end when the search is ended", async () => {
    const store = begun("nine-ball", { from: HANGING });
    shoot(store, 180, 0.5);
    const progress = standing(store, engine)!;
    const { game } = store.document;
    expect(await costsOf(engine, game!, progress, thinker, (made) => made < 1)).toBeNull();
  });
});
