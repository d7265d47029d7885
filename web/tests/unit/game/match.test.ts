import { describe, expect, test } from "vitest";
import type { Race } from "../../../src/app/document/stored-game.ts";
import { newGame } from "../../../src/app/document/stored-game.ts";
import { foulWithout } from "../../../src/app/game/match/shot-clock.ts";
import { framesWon, nextFrame, raceWinner } from "../../../src/app/game/match/race.ts";
import { trayLabel, trayOf } from "../../../src/app/game/match/pocketed-tray.ts";
import { concede, playMove, playShot, startNext } from "../../../src/app/game/game-actions.ts";
import { standing } from "../../../src/app/game/awaited-turn.ts";
import { stateFromFragment, stateToFragment } from "../../../src/app/share/link-state.ts";
import { toFragment } from "../../../src/app/share/link.ts";
import { begun, context, engine, setup, SHOT } from "./games.ts";

const RACE: Race = { to: 2, breaks: "alternate", won: [0, 0], turned: false };

describe("a race", () => {
  test("with alternate breaks lets the other player break each frame", () => {
    const first = newGame(setup("nine-ball", { race: RACE }));
    const second = nextFrame(first, 0);
    expect(second.setup.names).toEqual(["Bea", "Ann"]);
    expect(second.setup.race).toEqual({ ...RACE, won: [0, 1], turned: true });
    expect(second.setup.options.seed).toBe(8);
    const third = nextFrame(second, 0);
    expect(third.setup.names).toEqual(["Ann", "Bea"]);
    expect(third.setup.race).toEqual({ ...RACE, won: [1, 1], turned: false });
    expect(raceWinner(third.setup.race!, 1)).toBe(1);
    expect(framesWon(third.setup.race!, 1)).toEqual([1, 2]);
  });

  test("with winner breaks lets the winner break, with his machine and his side", () => {
    const race = { ...RACE, breaks: "winner" } as const;
    const own = { race, machines: [null, "level-2"], skills: ["club", null] } as const;
    const first = newGame(setup("nine-ball", own), 0);
    const kept = nextFrame(first, 0);
    expect(kept.setup.names).toEqual(["Ann", "Bea"]);
    const turned = nextFrame(first, 1);
    expect(turned.setup.names).toEqual(["Bea", "Ann"]);
    expect(turned.setup.machines).toEqual(["level-2", null]);
    expect(turned.setup.skills).toEqual([null, "club"]);
    expect(turned.here).toBe(1);
  });

  test("begins again after its end, and repeats a frame without a winner", () => {
    const race = { ...RACE, won: [1, 1] } as const;
    const last = newGame(setup("nine-ball", { race }));
    expect(nextFrame(last, 0).setup.race!.won).toEqual([0, 0]);
    expect(nextFrame(last, null).setup.race).toEqual(race);
  });

  test("is in the link, and a damaged one is refused", () => {
    const store = begun("nine-ball", { race: RACE, clock: 30 });
    const { document } = store;
    const fragment = stateToFragment(store.shot.file, store.state);
    expect(stateFromFragment(fragment)!.game).toEqual(document.game);
    const broken = { ...document.game!.setup, race: { ...RACE, won: [0, -1] } };
    const damaged = toFragment({ shot: SHOT, game: { ...document.game, setup: broken } });
    expect(() => stateFromFragment(damaged)).toThrow(/game/);
  });

  test("goes on with the next frame on the page", () => {
    const store = begun("nine-ball", { race: RACE });
    concede(store, context);
    startNext(store, context, 1);
    const { game } = store.document;
    expect(game!.setup.race).toEqual({ ...RACE, won: [1, 0], turned: true });
    expect(game!.moves).toEqual([]);
    expect(standing(store, engine)!.frame.state.request).toMatchObject({ player: 0 });
  });
});

test.each(engine.ruleSets.filter((rules) => rules !== "practice"))(
  "when the time is up in %s, a shot is played that hits no ball and loses the turn",
  (rules) => {
    const store = begun(rules, { clock: 20 });
    for (let turn = 0; turn < 2; turn += 1) {
      const progress = standing(store, engine)!;
      const { request } = progress.frame.state;
      if (request.kind !== "shot") break;
      const [x, y] = store.shot.balls[store.shot.struck!]!.position;
      const play = foulWithout(progress, [x, y]);
      expect(play).not.toBeNull();
      playMove(store, context, play!);
      const last = standing(store, engine)!.steps.at(-1)!;
      // In these games a shot that hits no ball is legal and scores nothing.
      expect(last.ruling.legal).toBe(["three-cushion", "straight-rail"].includes(rules));
      expect(last.after.request).toMatchObject({ player: 1 - request.player });
    }
  },
);

test("the tray has the balls that were pocketed, and not the cue ball", () => {
  const store = begun("eight-ball");
  const before = standing(store, engine)!;
  expect(trayOf(before, before.frame.state.balls)).toEqual([]);
  store.strike({ speed: 9 }, "aim");
  playShot(store, context, () => undefined);
  const after = standing(store, engine)!;
  expect(trayOf(after, after.frame.state.balls).sort()).toEqual([...after.steps[0]!.potted].sort());
});

test("the tray shows the numbers that the table shows", () => {
  // Seen: a potted red with the number 6.
  expect(["6", "15", "red-6", "black", "cue"].map(trayLabel)).toEqual(["6", "15", "", "", ""]);
});
