import { describe, expect, test } from "vitest";
import type { ShotFile } from "../../../src/engine/index.ts";
import { FIRST_SESSION, FIRST_VIEW } from "../../../src/app/document/document.ts";
import type { State } from "../../../src/app/document/store.ts";
import { LinkError, toFragment } from "../../../src/app/share/link.ts";
import { stateFromFragment, stateToFragment } from "../../../src/app/share/link-state.ts";
import type { Game } from "../../../src/app/document/stored-game.ts";

const errors = { speed: 0.075, azimuth: 0.002, elevation: 0.001, side_m: 0.0005, height_m: 0.0005 };
const noise = { ...errors, cling_probability: 0.02, cling_friction: 0.3 };
const strike = { ball: "cue", speed: 2, azimuth_deg: 90 };
const shot = {
  format: "carom-shot/1",
  table: "wpa-9ft",
  balls: [{ id: "cue", position: [0.5, 1] }],
  strike,
} satisfies ShotFile;

const game: Game = {
  setup: {
    rules: "nine-ball",
    options: { seed: 7 },
    from: null,
    names: ["Ann", "Bea"],
    skills: [null, "club"],
  },
  moves: [
    {
      play: {
        strike: { speed: 8, azimuth: 1.5707963267948966, elevation: 0, side: 0, height: 0 },
        cue_ball: [0.635, 0.6],
      },
    },
    { choice: "play-on" },
  ],
  call: { kind: "push-out" },
};

const state: State = {
  document: { shot, noise: null, seed: 0, game: null },
  view: FIRST_VIEW,
  session: FIRST_SESSION,
};

describe("the state in a link", () => {
  test("is only the shot if everything else has its default", () => {
    expect(stateToFragment(shot, state)).toBe(toFragment({ shot }));
    expect(stateFromFragment(stateToFragment(shot, state))).toStrictEqual({
      shot,
      noise: null,
      seed: 0,
      game: null,
      tree: null,
      study: null,
      lesson: null,
      view: FIRST_VIEW,
      time: null,
    });
  });

  test("restores noise, seed, game, view and the time of the replay", () => {
    const view = { theme: "dark", camera: "cue", units: "mph" } as const;
    const full: State = {
      document: { shot, noise, seed: 12345, game },
      view,
      session: {
        ...FIRST_SESSION,
        mode: "replay",
        replay: { ...FIRST_SESSION.replay, time: 1.234567890123456 },
      },
    };
    expect(stateFromFragment(stateToFragment(shot, full))).toStrictEqual({
      shot,
      noise,
      seed: 12345,
      tree: null,
      study: null,
      lesson: null,
      game,
      view,
      time: 1.234567890123456,
    });
  });

  test("is null for other fragments", () => {
    expect(stateFromFragment("")).toBeNull();
    expect(stateFromFragment("#help")).toBeNull();
  });

  test("without a shot is refused", () => {
    for (const data of [null, 3, [], {}, { shot: [] }]) {
      expect(() => stateFromFragment(toFragment(data))).toThrow(/contains no shot/);
    }
  });

  test("names the σ of a noise that is not a number", () => {
    for (const speed of ["fast", null, undefined]) {
      const odd = toFragment({ shot, noise: { ...noise, speed } });
      expect(() => stateFromFragment(odd)).toThrow(LinkError);
      expect(() => stateFromFragment(odd)).toThrow(/noise\.speed: .*write a number/);
    }
    expect(() => stateFromFragment(toFragment({ shot, noise: 3 }))).toThrow(/noise: found 3/);
  });

  test("a noise of an older link has no cling", () => {
    const old = toFragment({ shot, noise: errors });
    const cling = { cling_probability: 0, cling_friction: 0.22 };
    expect(stateFromFragment(old)?.noise).toStrictEqual({ ...errors, ...cling });
  });

  test("accepts the keys side and height of older links for a noise", () => {
    const { side_m, height_m, ...rest } = noise;
    const old = toFragment({ shot, noise: { ...rest, side: side_m, height: height_m } });
    expect(stateFromFragment(old)?.noise).toStrictEqual(noise);
  });

  test("refuses a game of another structure", () => {
    const { setup, moves, call } = game;
    for (const odd of [
      3,
      {},
      { setup, call },
      { setup: { ...setup, names: ["Ann"] }, moves, call },
      { setup: { ...setup, skills: [1, 2] }, moves, call },
      { setup, moves: [{ play: {} }], call },
      { setup, moves, call: "safety" },
      { setup, moves, call: { kind: "on" } },
      { setup, moves, call: { kind: "wish" } },
      { setup: { ...setup, names: ["A".repeat(10_000), "Bea"] }, moves, call },
    ]) {
      expect(() => stateFromFragment(toFragment({ shot, game: odd }))).toThrow(/game in this link/);
    }
  });

  test("takes the first choice for unknown settings of a view", () => {
    const odd = { shot, view: { theme: "pink", camera: "top", units: 7 } };
    expect(stateFromFragment(toFragment(odd))?.view).toStrictEqual(FIRST_VIEW);
  });

  test("refuses a seed or a time out of range instead of replacing it silently", () => {
    for (const seed of [-3, 0.5, "7"]) {
      expect(() => stateFromFragment(toFragment({ shot, seed }))).toThrow(/seed: .*whole number/);
    }
    for (const time of [-1, "soon"]) {
      expect(() => stateFromFragment(toFragment({ shot, time }))).toThrow(/time: .*seconds/);
    }
  });

  test("refuses a game with more moves than the page can replay at once", () => {
    const moves = Array.from({ length: 2001 }, () => ({ choice: "play-on" }));
    const long = toFragment({ shot, game: { ...game, moves } });
    expect(() => stateFromFragment(long)).toThrow(/has 2001 moves/);
  });
});
